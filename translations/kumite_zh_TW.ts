<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_TW" sourcelanguage="en">
<context>
    <name>Core</name>
    <message>
        <source>Open</source>
        <translation>開啟</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>救回</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>帶入標籤</translation>
    </message>
    <message>
        <source>Take over labels of %1</source>
        <translation>帶入 %1 的標籤</translation>
    </message>
    <message>
        <source>Remove boundary %1</source>
        <translation>移除邊界 %1</translation>
    </message>
    <message>
        <source>Restore boundary %1</source>
        <translation>還原邊界 %1</translation>
    </message>
    <message>
        <source>Add boundary %1</source>
        <translation>加入邊界 %1</translation>
    </message>
    <message>
        <source>Move boundary %1</source>
        <translation>移動邊界 %1</translation>
    </message>
    <message>
        <source>Accept boundary %1</source>
        <translation>接受邊界 %1</translation>
    </message>
    <message>
        <source>Change segmentation settings</source>
        <translation>變更分段設定</translation>
    </message>
    <message>
        <source>Change body model to %1</source>
        <translation>將身體模型改為 %1</translation>
    </message>
    <message>
        <source>Restore the version of %1</source>
        <translation>還原 %1 的版本</translation>
    </message>
    <message>
        <source>Add clips</source>
        <translation>加入片段</translation>
    </message>
    <message>
        <source>Remove clips</source>
        <translation>移除片段</translation>
    </message>
    <message>
        <source>Add take %1</source>
        <translation>加入鏡次 %1</translation>
    </message>
    <message>
        <source>Remove take %1</source>
        <translation>移除鏡次 %1</translation>
    </message>
    <message>
        <source>Rename take to %1</source>
        <translation>將鏡次重新命名為 %1</translation>
    </message>
    <message>
        <source>Move take %1 to place %2</source>
        <translation>將鏡次 %1 移到位置 %2</translation>
    </message>
    <message>
        <source>Swap fighters</source>
        <translation>對調選手</translation>
    </message>
    <message>
        <source>Change time offset, fighter %1</source>
        <translation>變更時間位移，選手 %1</translation>
    </message>
    <message>
        <source>Change floor, fighter %1</source>
        <translation>變更地板，選手 %1</translation>
    </message>
    <message>
        <source>Change role %1, fighter %2</source>
        <translation>變更角色 %1，選手 %2</translation>
    </message>
    <message>
        <source>Relink recording, fighter %1</source>
        <translation>重新連結錄製檔，選手 %1</translation>
    </message>
    <message>
        <source>Keep bout as take %1</source>
        <translation>將對打存為鏡次 %1</translation>
    </message>
    <message>
        <source>Keep motion as take %1</source>
        <translation>將動態存為鏡次 %1</translation>
    </message>
    <message>
        <source>Label action %1, fighter %2: %3</source>
        <translation>標記動作 %1，選手 %2：%3</translation>
    </message>
    <message>
        <source>Label action %1, fighter %2</source>
        <translation>標記動作 %1，選手 %2</translation>
    </message>
    <message>
        <source>Label %1 actions, fighter %2: %3</source>
        <translation>標記 %1 個動作，選手 %2：%3</translation>
    </message>
    <message>
        <source>Label %1 actions, fighter %2</source>
        <translation>標記 %1 個動作，選手 %2</translation>
    </message>
    <message>
        <source>Label %1 actions: %2</source>
        <translation>標記 %1 個動作：%2</translation>
    </message>
    <message>
        <source>Label %1 actions</source>
        <translation>標記 %1 個動作</translation>
    </message>
    <message>
        <source>Clear label, action %1, fighter %2</source>
        <translation>清除標籤，動作 %1，選手 %2</translation>
    </message>
    <message>
        <source>Clear label, %1 actions, fighter %2</source>
        <translation>清除標籤，%1 個動作，選手 %2</translation>
    </message>
    <message>
        <source>Accept labels</source>
        <translation>接受標籤</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>匯入標籤</translation>
    </message>
    <message>
        <source>Merge labels</source>
        <translation>合併標籤</translation>
    </message>
    <message>
        <source>Change vocabulary to %1</source>
        <translation>將詞彙改為 %1</translation>
    </message>
    <message>
        <source>Change rules</source>
        <translation>變更規則</translation>
    </message>
    <message>
        <source>Change learning settings</source>
        <translation>變更學習設定</translation>
    </message>
    <message>
        <source>Keep model</source>
        <translation>保留模型</translation>
    </message>
    <message>
        <source>Remove note %1</source>
        <translation>移除註記 %1</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>註記 %1</translation>
    </message>
    <message>
        <source>Accept what rules say</source>
        <translation>接受規則的說法</translation>
    </message>
    <message>
        <source>Accept 1 label</source>
        <translation>接受 1 個標籤</translation>
    </message>
    <message>
        <source>Accept %1 labels</source>
        <translation>接受 %1 個標籤</translation>
    </message>
    <message>
        <source>at %1, fighter %2</source>
        <translation>於 %1，選手 %2</translation>
    </message>
    <message>
        <source>A model of two fighters needs a take with two of them.</source>
        <translation>兩位選手的模型需要有兩位選手的鏡次。</translation>
    </message>
    <message>
        <source>No action is labelled yet: label some by hand and let the machine do the rest, or import labels.</source>
        <translation>尚無動作有標籤：請手動標記一些，其餘交給機器，或匯入標籤。</translation>
    </message>
    <message>
        <source>No transition has the labels of all its three actions: label more of both fighters.</source>
        <translation>沒有任何轉換具備三個動作的標籤：請為兩位選手標記更多。</translation>
    </message>
    <message>
        <source>cannot be read: %1.</source>
        <translation>無法讀取：%1。</translation>
    </message>
    <message>
        <source>cannot read: %1.</source>
        <translation>讀取失敗：%1。</translation>
    </message>
    <message>
        <source>cannot write: %1.</source>
        <translation>無法寫入：%1。</translation>
    </message>
    <message>
        <source>cannot make this folder: %1.</source>
        <translation>無法建立此資料夾：%1。</translation>
    </message>
    <message>
        <source>is a folder, expected a file.</source>
        <translation>是資料夾，應為檔案。</translation>
    </message>
    <message>
        <source>is no regular file; save it as one first.</source>
        <translation>不是一般檔案；請先另存為一般檔案。</translation>
    </message>
    <message>
        <source>is a folder, expected a file to write.</source>
        <translation>是資料夾，應為可寫入的檔案。</translation>
    </message>
    <message>
        <source>is what is read here; write to another file.</source>
        <translation>正是這裡讀取的檔案；請寫入其他檔案。</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>沒有這個檔案。</translation>
    </message>
    <message>
        <source>Every motion has too few frames for %1 key poses.</source>
        <translation>每段動態的影格都太少，不夠用於 %1 個關鍵姿勢。</translation>
    </message>
    <message>
        <source>There is no frame of %1 to write.</source>
        <translation>%1 沒有可寫出的影格。</translation>
    </message>
    <message>
        <source>The file holds %1 skeletons: %2. The first is read unless --root names another.</source>
        <translation>檔案含有 %1 個骨架：%2。除非以 --root 指定其他骨架，否則讀取第一個。</translation>
    </message>
    <message>
        <source>found several skeletons beside it (%1), expected one (name it with --asf)</source>
        <translation>旁邊有好幾個骨架（%1），只能有一個（請以 --asf 指定）</translation>
    </message>
    <message>
        <source>found %1, expected %2</source>
        <translation>讀到：%1；應為：%2</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>檔案結尾</translation>
    </message>
    <message>
        <source>only the %1 channels that CHANNELS announces</source>
        <translation>只有 CHANNELS 宣告的 %1 個通道</translation>
    </message>
    <message>
        <source>A split by takes needs two takes or more with labelled transitions.</source>
        <translation>依鏡次分組至少需要兩個含有已標記轉換的鏡次。</translation>
    </message>
    <message>
        <source>There are too few labelled transitions to set some apart.</source>
        <translation>已標記的轉換太少，無法另外保留一部分。</translation>
    </message>
    <message>
        <source>For labelling, these joints take their parents&apos; place: %1.</source>
        <translation>標記時，這些關節改用上層關節的位置：%1。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no aspect of the vocabulary %2.</source>
        <translation>「%1」不是詞彙 %2 的面向。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no qualifier of %2.</source>
        <translation>「%1」不是 %2 的修飾詞。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names an aspect twice.</source>
        <translation>「%1」重複指定了同一個面向。</translation>
    </message>
    <message>
        <source>After %1 a confidence is expected, such as 0.6 or 60 %.</source>
        <translation>%1 之後應有信心值，例如 0.6 或 60%。</translation>
    </message>
    <message>
        <source>After %1 a confidence is expected, such as 0.6 or 60 %, not %2.</source>
        <translation>%1 之後應為信心值，例如 0.6 或 60%，而不是 %2。</translation>
    </message>
    <message>
        <source>Say whether the confidence is &quot;below %1&quot; or &quot;above %1&quot;.</source>
        <translation>請說明信心是「below %1」還是「above %1」。</translation>
    </message>
    <message>
        <source>After %1 a time is expected, such as %2.</source>
        <translation>%1 之後應有時間，例如 %2。</translation>
    </message>
    <message>
        <source>After %1 a time is expected, such as %2, not %3.</source>
        <translation>%1 之後應為時間，例如 %2，而不是 %3。</translation>
    </message>
    <message>
        <source>After %1 two times are expected, such as 0:30 to 1:00.</source>
        <translation>%1 之後應有兩個時間，例如 0:30 to 1:00。</translation>
    </message>
    <message>
        <source>After %1 1 or 2 is expected.</source>
        <translation>%1 之後應為 1 或 2。</translation>
    </message>
    <message>
        <source>After %1 1 or 2 is expected, not %2.</source>
        <translation>%1 之後應為 1 或 2，而不是 %2。</translation>
    </message>
    <message>
        <source>There is no take %1; the takes are %2.</source>
        <translation>沒有鏡次 %1；現有鏡次：%2。</translation>
    </message>
    <message>
        <source>Say which take; the takes are %1.</source>
        <translation>請指定鏡次；現有鏡次：%1。</translation>
    </message>
    <message>
        <source>No aspect has a &quot;strike&quot;: %1 will never find anything to react to.</source>
        <translation>沒有任何面向設定「strike」：%1 永遠找不到可反應的對象。</translation>
    </message>
    <message>
        <source>The key %1 stands for both %2 and %3.</source>
        <translation>按鍵 %1 同時代表 %2 與 %3。</translation>
    </message>
    <message>
        <source>In %1 the key %2 stands for both %3 and %4.</source>
        <translation>在 %1 中，按鍵 %2 同時代表 %3 與 %4。</translation>
    </message>
    <message>
        <source>The target has no %1: their turns go to the joints below them.</source>
        <translation>目標骨架沒有 %1：其旋轉改由下層關節承接。</translation>
    </message>
    <message>
        <source>The source has no %1: they keep their rest relative to their parent.</source>
        <translation>來源骨架沒有 %1：這些關節相對於上層關節保持靜止姿勢。</translation>
    </message>
    <message>
        <source>No joint was found for: %1.</source>
        <translation>找不到對應的關節：%1。</translation>
    </message>
    <message>
        <source>Joint %1 does not stand behind its parent.</source>
        <translation>關節 %1 沒有排在其上層關節之後。</translation>
    </message>
    <message>
        <source>The channels of joint %1 do not follow the ones before.</source>
        <translation>關節 %1 的通道沒有接續前面的通道。</translation>
    </message>
    <message>
        <source>The End Site %1 has channels.</source>
        <translation>End Site %1 含有通道。</translation>
    </message>
    <message>
        <source>The offset of joint %1 is not a finite number.</source>
        <translation>關節 %1 的位移不是有限數值。</translation>
    </message>
    <message>
        <source>Frame 0 is a rest pose, not motion; takes leave it out.</source>
        <translation>影格 0 是靜止姿勢，不是動態；鏡次不含此影格。</translation>
    </message>
    <message>
        <source>Frames 0 to %1 are a rest pose, not motion; takes leave them out.</source>
        <translation>影格 0 至 %1 是靜止姿勢，不是動態；鏡次不含這些影格。</translation>
    </message>
    <message>
        <source>Fighter %1 has no boundary near frame %2.</source>
        <translation>選手 %1 在影格 %2 附近沒有邊界。</translation>
    </message>
    <message>
        <source>Fighter %1 has no boundary near frame %2; the nearest is at %3.</source>
        <translation>選手 %1 在影格 %2 附近沒有邊界；最近的在 %3。</translation>
    </message>
    <message>
        <source>the recording is missing; its boundaries cannot be edited.</source>
        <translation>錄製檔遺失；無法編輯其邊界。</translation>
    </message>
    <message>
        <source>A time offset must be a number.</source>
        <translation>時間位移必須是數字。</translation>
    </message>
    <message>
        <source>A placement must be a number.</source>
        <translation>位置必須是數字。</translation>
    </message>
    <message>
        <source>The floor&apos;s height must be a number.</source>
        <translation>地板高度必須是數字。</translation>
    </message>
    <message>
        <source>There is a take named &quot;%1&quot; already.</source>
        <translation>已有名為「%1」的鏡次。</translation>
    </message>
    <message>
        <source>%1 has another skeleton: it is not the recording that is missing.</source>
        <translation>%1 的骨架不同：這不是遺失的那個錄製檔。</translation>
    </message>
    <message>
        <source>the suffix says what to write, expected .bvh, .glb, .npz, .csv, .json or .eaf.</source>
        <translation>副檔名決定寫出的格式，應為 .bvh、.glb、.npz、.csv、.json 或 .eaf。</translation>
    </message>
    <message>
        <source>the recording is missing; the take cannot be written without it.</source>
        <translation>錄製檔遺失；沒有它就無法寫出鏡次。</translation>
    </message>
    <message>
        <source>a graph is written as .csv, .json or .graphml.</source>
        <translation>轉換圖可寫成 .csv、.json 或 .graphml。</translation>
    </message>
    <message>
        <source>there is no joint named &quot;%1&quot;; there is: %2.</source>
        <translation>沒有名為「%1」的關節；現有關節：%2。</translation>
    </message>
    <message>
        <source>the name holds bytes that are no UTF-8 text; rename the file or folder.</source>
        <translation>名稱含有不屬於 UTF-8 文字的位元組；請重新命名檔案或資料夾。</translation>
    </message>
    <message>
        <source>the key pose of clip &quot;%1&quot; is not in the project</source>
        <translation>片段「%1」的關鍵姿勢不在專案中</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no source.</source>
        <translation>「%1」不是標籤來源。</translation>
    </message>
    <message>
        <source>labels are written as .csv, .json or .eaf.</source>
        <translation>標籤可寫成 .csv、.json 或 .eaf。</translation>
    </message>
    <message>
        <source>labels are read from .csv, .json and .eaf files.</source>
        <translation>標籤可從 .csv、.json 與 .eaf 檔案讀取。</translation>
    </message>
    <message>
        <source>the project has no take &quot;%1&quot;.</source>
        <translation>專案沒有鏡次「%1」。</translation>
    </message>
    <message>
        <source>the take has no such fighter.</source>
        <translation>此鏡次沒有這位選手。</translation>
    </message>
    <message>
        <source>no action there.</source>
        <translation>該處沒有動作。</translation>
    </message>
    <message>
        <source>its action takes the label of %1.</source>
        <translation>該動作已採用 %1 的標籤。</translation>
    </message>
    <message>
        <source>no joint has the role pelvis, so its actions cannot be compared.</source>
        <translation>沒有關節對應骨盆，因此無法比較其動作。</translation>
    </message>
    <message>
        <source>the recording is missing; its actions cannot be labelled.</source>
        <translation>錄製檔遺失；無法標記其動作。</translation>
    </message>
    <message>
        <source>has no body with two legs; it is left out.</source>
        <translation>沒有具備雙腿的身體；已略過。</translation>
    </message>
    <message>
        <source>%1 It is left out.</source>
        <translation>%1已略過。</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: expected frames as A:B after the @.</source>
        <translation>「%1」：@ 之後的影格應寫成 A:B。</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: these frames are not in it; it has %2 to %3.</source>
        <translation>「%1」：其中沒有這些影格；現有影格 %2 至 %3。</translation>
    </message>
    <message>
        <source>No action of the library is labelled &quot;%1&quot;.</source>
        <translation>資料庫中沒有標為「%1」的動作。</translation>
    </message>
    <message>
        <source>No action of the library is labelled &quot;%1&quot; of that player.</source>
        <translation>資料庫中，該選手沒有標為「%1」的動作。</translation>
    </message>
    <message>
        <source>None of these clips is of that player.</source>
        <translation>這些片段都不是該選手的。</translation>
    </message>
    <message>
        <source>joint &quot;%1&quot; is gone; the role %2 has no joint now.</source>
        <translation>關節「%1」已不存在；角色 %2 目前沒有關節。</translation>
    </message>
    <message>
        <source>%1 The recording is left out; its corrections are kept.</source>
        <translation>%1已略過此錄製檔；保留其修正。</translation>
    </message>
    <message>
        <source>the recording is missing; put it back or relink it. Its corrections are kept.</source>
        <translation>錄製檔遺失；請放回原處或重新連結。其修正仍保留。</translation>
    </message>
    <message>
        <source>the recording has changed since it became part of the project; check the boundaries, then relink it to accept the change.</source>
        <translation>錄製檔加入專案後有變更；請檢查邊界，再重新連結以接受變更。</translation>
    </message>
    <message>
        <source>the recording is missing; the take cannot be shown without it.</source>
        <translation>錄製檔遺失；沒有它就無法顯示鏡次。</translation>
    </message>
    <message>
        <source>There is no take named &quot;%1&quot;; the project has none.</source>
        <translation>沒有名為「%1」的鏡次；專案中沒有鏡次。</translation>
    </message>
    <message>
        <source>There is no take named &quot;%1&quot;; there is: %2.</source>
        <translation>沒有名為「%1」的鏡次；現有鏡次：%2。</translation>
    </message>
    <message>
        <source>no contact force without a body; no joint has the role %1.</source>
        <translation>沒有身體就算不出接觸力；沒有關節對應角色 %1。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; of fighter %2 is no correction without a minimum.</source>
        <translation>「%1」（選手 %2）不在沒有極小值的修正之列。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; leaves no boundary that could be added.</source>
        <translation>「%1」沒有可加入的邊界。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be reached: the nearest target that can is %2.</source>
        <translation>「%1」無法擊中：可及的最近目標是 %2。</translation>
    </message>
    <message>
        <source>What was saved before could not be kept. %1</source>
        <translation>無法保留先前儲存的內容。%1</translation>
    </message>
    <message>
        <source>holds %1 frames only; the take ends there for this fighter.</source>
        <translation>只有 %1 個影格；這位選手的鏡次到此為止。</translation>
    </message>
    <message>
        <source>holds %1 frames now, the take begins at frame %2; the recording is left out.</source>
        <translation>目前只有 %1 個影格，但鏡次從影格 %2 開始；已略過此錄製檔。</translation>
    </message>
    <message>
        <source>holds %1 frames now; the take ends there.</source>
        <translation>目前只有 %1 個影格；鏡次到此為止。</translation>
    </message>
    <message>
        <source>a cutoff of %1 Hz smooths nothing at %2 frames a second; choose one below %3 Hz.</source>
        <translation>每秒 %2 影格時，截止頻率 %1 Hz 沒有平滑效果；請選低於 %3 Hz 的值。</translation>
    </message>
    <message>
        <source>the annotation &quot;%1&quot; has no time and is left out.</source>
        <translation>註解「%1」沒有時間，已略過。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no action that can be asked for; there are %2, what they strike with, and ASPECT:QUALIFIER.</source>
        <translation>「%1」不是可要求的動作；可用：%2、打擊所用的部位，以及 ASPECT:QUALIFIER（面向:修飾詞）。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing.</source>
        <translation>缺少「%1」。</translation>
    </message>
    <message>
        <source>expected a list.</source>
        <translation>應為清單。</translation>
    </message>
    <message>
        <source>expected an object.</source>
        <translation>應為物件。</translation>
    </message>
    <message>
        <source>expected a whole number.</source>
        <translation>應為整數。</translation>
    </message>
    <message>
        <source>expected a number.</source>
        <translation>應為數字。</translation>
    </message>
    <message>
        <source>expected a finite number.</source>
        <translation>應為有限數值。</translation>
    </message>
    <message>
        <source>expected a number above 0.</source>
        <translation>應為大於 0 的數字。</translation>
    </message>
    <message>
        <source>expected true or false.</source>
        <translation>應為 true 或 false。</translation>
    </message>
    <message>
        <source>expected text.</source>
        <translation>應為文字。</translation>
    </message>
    <message>
        <source>expected 0 or more.</source>
        <translation>應為 0 以上。</translation>
    </message>
    <message>
        <source>expected [begin, end] with 0 &lt;= begin &lt; end.</source>
        <translation>應為 [begin, end]，且 0 &lt;= begin &lt; end。</translation>
    </message>
    <message>
        <source>expected an object with &quot;key_poses&quot;: 1, &quot;rate&quot; and &quot;keys&quot;.</source>
        <translation>應為含有 &quot;key_poses&quot;: 1、&quot;rate&quot; 與 &quot;keys&quot; 的物件。</translation>
    </message>
    <message>
        <source>expected a colour like #3a86d8.</source>
        <translation>應為顏色，例如 #3a86d8。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no joint role.</source>
        <translation>「%1」不是關節角色。</translation>
    </message>
    <message>
        <source>is no joint role.</source>
        <translation>不是關節角色。</translation>
    </message>
    <message>
        <source>is no vocabulary: it has no &quot;vocabulary&quot; version.</source>
        <translation>不是詞彙：缺少「vocabulary」版本。</translation>
    </message>
    <message>
        <source>is the id of two qualifiers.</source>
        <translation>這個 id 由兩個修飾詞共用。</translation>
    </message>
    <message>
        <source>is the id of two aspects.</source>
        <translation>這個 id 由兩個面向共用。</translation>
    </message>
    <message>
        <source>is the name of two takes.</source>
        <translation>這個名稱由兩個鏡次共用。</translation>
    </message>
    <message>
        <source>a take has one or two fighters.</source>
        <translation>一個鏡次有一或兩名選手。</translation>
    </message>
    <message>
        <source>a vocabulary has one aspect or more.</source>
        <translation>詞彙至少要有一個面向。</translation>
    </message>
    <message>
        <source>an aspect has two qualifiers or more.</source>
        <translation>面向至少要有兩個修飾詞。</translation>
    </message>
    <message>
        <source>is none of the qualifiers.</source>
        <translation>不在修飾詞之中。</translation>
    </message>
    <message>
        <source>there is no aspect &quot;%1&quot;.</source>
        <translation>沒有面向「%1」。</translation>
    </message>
    <message>
        <source>The system&apos;s OpenSSL library cannot compute SHA-256.</source>
        <translation>系統的 OpenSSL 程式庫無法計算 SHA-256。</translation>
    </message>
    <message>
        <source>A demo bout lasts from 1 second to 24 hours; %1 seconds were asked for.</source>
        <translation>示範對打的長度為 1 秒到 24 小時；要求的是 %1 秒。</translation>
    </message>
    <message>
        <source>A demo bout has 24 to 240 frames a second; %1 were asked for.</source>
        <translation>示範對打為每秒 24 到 240 影格；要求的是 %1。</translation>
    </message>
    <message>
        <source>There is no key pose to make a motion of.</source>
        <translation>沒有可製作動態的關鍵姿勢。</translation>
    </message>
    <message>
        <source>The library holds no motion.</source>
        <translation>資料庫中沒有動態。</translation>
    </message>
    <message>
        <source>There is no key at frame %1.</source>
        <translation>影格 %1 沒有關鍵姿勢。</translation>
    </message>
    <message>
        <source>Frame %1 is not behind the key before.</source>
        <translation>影格 %1 不在前一個關鍵姿勢之後。</translation>
    </message>
    <message>
        <source>Keys can be brought nearer or farther by a factor above 0 only.</source>
        <translation>縮放關鍵姿勢間距的倍數必須大於 0。</translation>
    </message>
    <message>
        <source>Keys cannot be brought that far.</source>
        <translation>關鍵姿勢無法移得那麼遠。</translation>
    </message>
    <message>
        <source>Key poses need a skeleton.</source>
        <translation>關鍵姿勢需要骨架。</translation>
    </message>
    <message>
        <source>Key poses need a rate above 0.</source>
        <translation>關鍵姿勢的速率必須大於 0。</translation>
    </message>
    <message>
        <source>The key at frame %1 is a pose of another skeleton.</source>
        <translation>影格 %1 的關鍵姿勢屬於另一個骨架。</translation>
    </message>
    <message>
        <source>The key at frame %1 comes after one at frame %2.</source>
        <translation>影格 %1 的關鍵姿勢排到了影格 %2 的後面。</translation>
    </message>
    <message>
        <source>Frames %1:%2 are not in the take, which has %3.</source>
        <translation>影格 %1:%2 不在鏡次中；鏡次有 %3 個影格。</translation>
    </message>
    <message>
        <source>The part comes from another skeleton.</source>
        <translation>部位來自另一個骨架。</translation>
    </message>
    <message>
        <source>Frames %1 to %2 are not in the source, which has %3.</source>
        <translation>影格 %1 至 %2 不在來源中；來源有 %3 個影格。</translation>
    </message>
    <message>
        <source>There is no key pose to look for.</source>
        <translation>沒有可供尋找的關鍵姿勢。</translation>
    </message>
    <message>
        <source>At most 1000 key poses can be looked for.</source>
        <translation>最多可尋找 1000 個關鍵姿勢。</translation>
    </message>
    <message>
        <source>Every key pose needs its features and its frame.</source>
        <translation>每個關鍵姿勢都需要特徵與影格。</translation>
    </message>
    <message>
        <source>Key poses must stand in the order of their frames, one per frame.</source>
        <translation>關鍵姿勢必須依影格順序排列，每個影格最多一個。</translation>
    </message>
    <message>
        <source>Two examples of the strike cannot be aligned in time.</source>
        <translation>這個打擊有兩個範例無法在時間上對齊。</translation>
    </message>
    <message>
        <source>There is no example of the strike to blend.</source>
        <translation>沒有可混合的打擊範例。</translation>
    </message>
    <message>
        <source>The skeleton has no %1: its roles tell nothing that could hit.</source>
        <translation>骨架沒有 %1：從角色看不出用什麼打擊。</translation>
    </message>
    <message>
        <source>Strike &quot;%1&quot; is of another skeleton.</source>
        <translation>打擊「%1」屬於另一個骨架。</translation>
    </message>
    <message>
        <source>Feature poses must come in pairs, one of the query and one of the clip.</source>
        <translation>特徵姿勢必須成對，查詢與片段各一個。</translation>
    </message>
    <message>
        <source>Feature poses must follow each other in time.</source>
        <translation>特徵姿勢必須依時間先後排列。</translation>
    </message>
    <message>
        <source>An AMC file does not say its frame rate: 120 Hz is assumed; give another with --rate.</source>
        <translation>AMC 檔案不含影格率：假定為 120 Hz；可用 --rate 指定其他值。</translation>
    </message>
    <message>
        <source>Frame %1, the last, is cut: it is dropped.</source>
        <translation>最後的影格 %1 不完整：已捨棄。</translation>
    </message>
    <message>
        <source>Frame %1 does not follow the one before it by number: the frames are taken one after the other.</source>
        <translation>影格 %1 的編號沒有接續前一個：影格依檔案中的順序讀取。</translation>
    </message>
    <message>
        <source>found %1 numbers, expected %2 for bone %3 in frame %4</source>
        <translation>影格 %4 的骨骼 %3 有 %1 個數字，應有 %2 個</translation>
    </message>
    <message>
        <source>found no line for bone %1 in frame %2, expected one for each bone with a dof</source>
        <translation>影格 %2 沒有骨骼 %1 的資料列，有 dof 的骨骼都應各有一列</translation>
    </message>
    <message>
        <source>found %1, expected a unit of length greater than zero</source>
        <translation>讀到 %1，長度單位應大於零</translation>
    </message>
    <message>
        <source>found a bone without name, expected one</source>
        <translation>骨骼沒有名稱，應有名稱</translation>
    </message>
    <message>
        <source>found a second bone %1, expected one</source>
        <translation>骨骼 %1 重複出現，應只有一個</translation>
    </message>
    <message>
        <source>found bone %1 a second time, expected one parent for each</source>
        <translation>骨骼 %1 出現兩次，每個骨骼應只有一個上層</translation>
    </message>
    <message>
        <source>found bone %1 that does not hang on the root, expected it in :hierarchy</source>
        <translation>骨骼 %1 沒有連到根，應列在 :hierarchy 中</translation>
    </message>
    <message>
        <source>found a skeleton without any dof, expected an order for the root</source>
        <translation>骨架沒有任何 dof，根應有 order</translation>
    </message>
    <message>
        <source>Bone %1 changes its length: that is not used.</source>
        <translation>骨骼 %1 的長度會改變：不採用。</translation>
    </message>
    <message>
        <source>found more joints than a skeleton can have, expected %1 at most</source>
        <translation>關節超過骨架所能容納的數量，最多 %1 個</translation>
    </message>
    <message>
        <source>%1 has no OFFSET: taken as 0 0 0.</source>
        <translation>%1 沒有 OFFSET：視為 0 0 0。</translation>
    </message>
    <message>
        <source>%1 has channels or children: read as a joint.</source>
        <translation>%1 含有通道或子關節：視為關節讀取。</translation>
    </message>
    <message>
        <source>found a second %1, expected one in joint %2</source>
        <translation>讀到第二個 %1，關節 %2 中應只有一個</translation>
    </message>
    <message>
        <source>found a skeleton without any channel, expected CHANNELS</source>
        <translation>骨架沒有任何通道，應有 CHANNELS</translation>
    </message>
    <message>
        <source>found %1 numbers after Frame Time, expected at least one frame of %2 numbers</source>
        <translation>Frame Time 之後有 %1 個數字，應至少有一個含 %2 個數字的影格</translation>
    </message>
    <message>
        <source>found more frames than can be counted, expected fewer</source>
        <translation>影格多到無法計數，請減少</translation>
    </message>
    <message>
        <source>A .glb file cannot hold more than 4 GB: export a shorter range.</source>
        <translation>.glb 檔案不能超過 4 GB：請匯出較短的範圍。</translation>
    </message>
    <message>
        <source>There is no figure to write.</source>
        <translation>沒有可寫出的人物。</translation>
    </message>
    <message>
        <source>A glTF skeleton cannot have more than 65 535 joints.</source>
        <translation>glTF 骨架不能超過 65 535 個關節。</translation>
    </message>
    <message>
        <source>is not valid JSON here.</source>
        <translation>此處不是有效的 JSON。</translation>
    </message>
    <message>
        <source>holds a number that is too large.</source>
        <translation>含有過大的數字。</translation>
    </message>
    <message>
        <source>A .npz file cannot hold more than 4 GB: export a shorter range.</source>
        <translation>.npz 檔案不能超過 4 GB：請匯出較短的範圍。</translation>
    </message>
    <message>
        <source>found no skeleton beside it, expected an .asf file (name it with --asf)</source>
        <translation>旁邊沒有骨架，應有 .asf 檔案（請以 --asf 指定）</translation>
    </message>
    <message>
        <source>found an ASF skeleton, which holds no motion, expected the .amc file that belongs to it.</source>
        <translation>這是 ASF 骨架，不含動態，應為所屬的 .amc 檔案。</translation>
    </message>
    <message>
        <source>The recording holds no skeleton.</source>
        <translation>錄製檔中沒有骨架。</translation>
    </message>
    <message>
        <source>found UTF-16 text, expected plain text (save the file as UTF-8)</source>
        <translation>讀到 UTF-16 文字，應為純文字（請將檔案存成 UTF-8）</translation>
    </message>
    <message>
        <source>has a quote that is not closed.</source>
        <translation>有未關閉的引號。</translation>
    </message>
    <message>
        <source>No joint has the role pelvis: actions cannot be compared.</source>
        <translation>沒有關節對應骨盆：無法比較動作。</translation>
    </message>
    <message>
        <source>Nothing stands before &quot;or&quot;.</source>
        <translation>「or」之前沒有內容。</translation>
    </message>
    <message>
        <source>Nothing stands after &quot;or&quot;.</source>
        <translation>「or」之後沒有內容。</translation>
    </message>
    <message>
        <source>Something is missing after &quot;not&quot;.</source>
        <translation>「not」之後缺少內容。</translation>
    </message>
    <message>
        <source>Points to be aligned must come in pairs.</source>
        <translation>要對齊的點必須成對。</translation>
    </message>
    <message>
        <source>Points to be aligned need a weight above zero.</source>
        <translation>要對齊的點，權重必須大於零。</translation>
    </message>
    <message>
        <source>A rate must be a positive number of frames a second.</source>
        <translation>速率必須是正的每秒影格數。</translation>
    </message>
    <message>
        <source>Foot locking needs a frame to show.</source>
        <translation>足部鎖定需要可顯示的影格。</translation>
    </message>
    <message>
        <source>Foot locking needs to know of every frame which feet stand.</source>
        <translation>足部鎖定需要知道每個影格有哪些腳站定。</translation>
    </message>
    <message>
        <source>A clip without frames cannot be joined.</source>
        <translation>沒有影格的片段無法接合。</translation>
    </message>
    <message>
        <source>Clips can be joined only at one rate and on one skeleton.</source>
        <translation>片段的速率與骨架都相同才能接合。</translation>
    </message>
    <message>
        <source>A motion needs a skeleton.</source>
        <translation>動態需要骨架。</translation>
    </message>
    <message>
        <source>A motion&apos;s frame time must be a positive number of seconds.</source>
        <translation>動態的影格時間必須是正的秒數。</translation>
    </message>
    <message>
        <source>A motion&apos;s channel values do not fill its frames.</source>
        <translation>動態的通道數值不足以填滿影格。</translation>
    </message>
    <message>
        <source>A channel value is not a finite number.</source>
        <translation>有通道數值不是有限數值。</translation>
    </message>
    <message>
        <source>A clip&apos;s rig does not have the joints of its motion.</source>
        <translation>片段的骨架與其動態的關節不符。</translation>
    </message>
    <message>
        <source>A clip of %1 joints cannot be written with the %2 joints of another skeleton: retarget it first.</source>
        <translation>%1 個關節的片段無法寫成另一個有 %2 個關節的骨架：請先重定向。</translation>
    </message>
    <message>
        <source>Ways are scaled by %1 for the legs&apos; lengths.</source>
        <translation>移動距離依腿長縮放為 %1 倍。</translation>
    </message>
    <message>
        <source>%1 moves by up to %2 cm of its own, which is not kept: %3 carries the body.</source>
        <translation>%1 自行移動最多 %2 cm，此移動不保留：帶動身體的是 %3。</translation>
    </message>
    <message>
        <source>The bone to %1 changes by up to %2 cm; its mean is kept.</source>
        <translation>通往 %1 的骨骼長度變化最多 %2 cm；採用其平均值。</translation>
    </message>
    <message>
        <source>No neck: the chest (%1) stands in for it.</source>
        <translation>沒有頸部：以胸部（%1）代替。</translation>
    </message>
    <message>
        <source>The joint names say nothing; the roles were read off the skeleton&apos;s shape. Check left and right.</source>
        <translation>從關節名稱看不出角色；角色已由骨架形狀判讀。請檢查左右。</translation>
    </message>
    <message>
        <source>This skeleton is not a human body that is known here: it is shown and measured, but the contact force needs joint roles. Name them by hand if it is one.</source>
        <translation>此骨架不是程式認得的人體：可以顯示與測量，但接觸力需要關節角色。若這是人體，請手動指定角色。</translation>
    </message>
    <message>
        <source>A skeleton needs at least one joint.</source>
        <translation>骨架至少需要一個關節。</translation>
    </message>
    <message>
        <source>A skeleton&apos;s channel count does not add up.</source>
        <translation>骨架的通道總數不符。</translation>
    </message>
    <message>
        <source>The body lies along the x axis; y was taken for up. Say which axis is up.</source>
        <translation>身體沿 x 軸平躺；已將 y 當成朝上。請指定朝上的軸。</translation>
    </message>
    <message>
        <source>Without legs the unit cannot be found; centimetres are assumed.</source>
        <translation>沒有腿就無法求得單位；假定為公分。</translation>
    </message>
    <message>
        <source>The labels belong to another segmentation.</source>
        <translation>標籤屬於另一個分段。</translation>
    </message>
    <message>
        <source>The differences belong to another segmentation or vocabulary.</source>
        <translation>差異屬於另一個分段或詞彙。</translation>
    </message>
    <message>
        <source>Fighter %1 has no removed boundary near frame %2.</source>
        <translation>選手 %1 在影格 %2 附近沒有已移除的邊界。</translation>
    </message>
    <message>
        <source>Fighter %1 has another boundary at frame %2; move that one first.</source>
        <translation>選手 %1 在影格 %2 已有另一個邊界；請先移動它。</translation>
    </message>
    <message>
        <source>Frame %1 is not inside the take, whose last frame is %2: a boundary cannot stand there.</source>
        <translation>影格 %1 不在鏡次之內（最後影格為 %2）：該處不能有邊界。</translation>
    </message>
    <message>
        <source>The boundary can move between its neighbours only: frames %1 to %2.</source>
        <translation>邊界只能在相鄰邊界之間移動：影格 %1 至 %2。</translation>
    </message>
    <message>
        <source>The boundary at frame %1 is an end of the take, which stays.</source>
        <translation>影格 %1 的邊界是鏡次的端點，不能變更。</translation>
    </message>
    <message>
        <source>Take %1, player %2: its skeleton has other joints than that of the first take, so it is left out of bouts.</source>
        <translation>鏡次 %1，選手 %2：骨架的關節與第一個鏡次不同，因此不用於對打。</translation>
    </message>
    <message>
        <source>No action of player %1 begins in frames %2 to %3 of take %4.</source>
        <translation>選手 %1 在鏡次 %4 的影格 %2 至 %3 之間沒有開始任何動作。</translation>
    </message>
    <message>
        <source>Player %1 does not attack in frames %2 to %3 of take %4.</source>
        <translation>選手 %1 在鏡次 %4 的影格 %2 至 %3 之間沒有攻擊。</translation>
    </message>
    <message>
        <source>Player %1 never attacks.</source>
        <translation>選手 %1 從未攻擊。</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2.</source>
        <translation>無法建立資料夾 %1：%2。</translation>
    </message>
    <message>
        <source>The cutoff must be a positive number of Hz.</source>
        <translation>截止頻率必須是大於 0 的 Hz 值。</translation>
    </message>
    <message>
        <source>The prominence must be a number of body weights, 0 or more.</source>
        <translation>突出度必須是 0 以上的體重倍數。</translation>
    </message>
    <message>
        <source>A take needs a name.</source>
        <translation>鏡次需要名稱。</translation>
    </message>
    <message>
        <source>A take has one or two fighters.</source>
        <translation>一個鏡次有一或兩名選手。</translation>
    </message>
    <message>
        <source>There is no such place in the list of takes.</source>
        <translation>鏡次清單中沒有這個位置。</translation>
    </message>
    <message>
        <source>There is one fighter only: nothing to swap.</source>
        <translation>只有一名選手：無從對調。</translation>
    </message>
    <message>
        <source>The skeleton has no such joint.</source>
        <translation>骨架沒有這個關節。</translation>
    </message>
    <message>
        <source>%1 holds %2 frames, but the take reaches to frame %3: it is not the recording that is missing.</source>
        <translation>%1 有 %2 個影格，但鏡次到影格 %3 為止：這不是遺失的那個錄製檔。</translation>
    </message>
    <message>
        <source>The placement cannot be written: neither the root nor a joint right below it has all position and rotation channels.</source>
        <translation>無法寫入位置：根或其正下方的關節都沒有完整的位置與旋轉通道。</translation>
    </message>
    <message>
        <source>A take is made of one or two recordings.</source>
        <translation>一個鏡次由一到兩個錄製檔組成。</translation>
    </message>
    <message>
        <source>The take&apos;s name holds bytes that are no UTF-8 text.</source>
        <translation>鏡次名稱含有不屬於 UTF-8 文字的位元組。</translation>
    </message>
    <message>
        <source>A frame rate lies between 1 and 10000 Hz.</source>
        <translation>影格率須介於 1 與 10000 Hz 之間。</translation>
    </message>
    <message>
        <source>The recordings run at %1 and %2 Hz; each keeps its own rate.</source>
        <translation>兩個錄製檔分別為 %1 與 %2 Hz；各自保留原本的速率。</translation>
    </message>
    <message>
        <source>Take %1, player %2: no pelvis or no centre of mass is known, so its actions are left out.</source>
        <translation>鏡次 %1，選手 %2：骨盆或質心未知，因此略過其動作。</translation>
    </message>
    <message>
        <source>Player %1: %2 of %3 actions have no label and are left out, with every transition that touches them.</source>
        <translation>選手 %1：%3 個動作中有 %2 個沒有標籤，連同相關的轉換都已略過。</translation>
    </message>
    <message>
        <source>No take of two has a recording of player %1 with the skeleton of the bout: it was removed since the bout was begun.</source>
        <translation>雙人鏡次中，選手 %1 沒有使用此對打骨架的錄製檔：對打開始後已被移除。</translation>
    </message>
    <message>
        <source>An .eaf file holds one take: say which.</source>
        <translation>一個 .eaf 檔案只容納一個鏡次：請指定鏡次。</translation>
    </message>
    <message>
        <source>is empty.</source>
        <translation>是空的。</translation>
    </message>
    <message>
        <source>has no column %1; a label table needs begin_s, end_s and label.</source>
        <translation>沒有 %1 欄；標籤表格需要 begin_s、end_s 與 label。</translation>
    </message>
    <message>
        <source>holds no labels: it has neither &quot;kumite_labels&quot; nor &quot;players&quot;.</source>
        <translation>不含標籤：沒有「kumite_labels」也沒有「players」。</translation>
    </message>
    <message>
        <source>There is no action %1; the fighter has %2.</source>
        <translation>沒有動作 %1；這位選手有 %2 個動作。</translation>
    </message>
    <message>
        <source>The vocabulary has no aspect %1.</source>
        <translation>詞彙沒有面向 %1。</translation>
    </message>
    <message>
        <source>%1 has no qualifier %2.</source>
        <translation>%1 沒有修飾詞 %2。</translation>
    </message>
    <message>
        <source>The label belongs to another vocabulary.</source>
        <translation>標籤屬於另一個詞彙。</translation>
    </message>
    <message>
        <source>The thresholds of the rules must be numbers, 0 or more.</source>
        <translation>規則的門檻必須是 0 以上的數字。</translation>
    </message>
    <message>
        <source>A cross-validation has two folds or more.</source>
        <translation>交叉驗證至少要分成兩份。</translation>
    </message>
    <message>
        <source>A library&apos;s rate lies between %1 and %2 Hz.</source>
        <translation>資料庫的速率須介於 %1 與 %2 Hz 之間。</translation>
    </message>
    <message>
        <source>The library is empty: no source holds the motion of a body.</source>
        <translation>資料庫是空的：沒有任何來源含有身體的動態。</translation>
    </message>
    <message>
        <source>The library has no clip &quot;%1&quot;; it has %2.</source>
        <translation>資料庫沒有片段「%1」；現有片段：%2。</translation>
    </message>
    <message>
        <source>None of these clips shows a hand or a foot that strikes.</source>
        <translation>這些片段都沒有手或腳的打擊。</translation>
    </message>
    <message>
        <source>No strike of the %1 was found in &quot;%2&quot;.</source>
        <translation>在「%2」中找不到 %1 的打擊。</translation>
    </message>
    <message>
        <source>%1 was not where the project says; the same recording was found at %2.</source>
        <translation>%1 不在專案所記的位置；在 %2 找到相同的錄製檔。</translation>
    </message>
    <message>
        <source>%1 is there already: choose another name.</source>
        <translation>%1 已經存在：請選擇其他名稱。</translation>
    </message>
    <message>
        <source>is a recording; make a project of it with kumite new.</source>
        <translation>是錄製檔；請用 kumite new 建立成專案。</translation>
    </message>
    <message>
        <source>is not a Kumite project: it has no &quot;kumite&quot; version.</source>
        <translation>不是 Kumite 專案：缺少「kumite」版本。</translation>
    </message>
    <message>
        <source>was written by a newer Kumite (file version %1, this one reads up to %2); open it with that one.</source>
        <translation>由較新的 Kumite 寫入（檔案版本 %1，本程式最多讀到 %2）；請用該版本開啟。</translation>
    </message>
    <message>
        <source>No motion from key poses of %1: %2</source>
        <translation>%1 的關鍵姿勢無法產生動態：%2</translation>
    </message>
    <message>
        <source>There is no clip to rate.</source>
        <translation>沒有可評分的片段。</translation>
    </message>
    <message>
        <source>Frame %1 is not inside the take: a boundary cannot stand there.</source>
        <translation>影格 %1 不在鏡次之內：該處不能有邊界。</translation>
    </message>
    <message>
        <source>Fighter %1 has another boundary at frame %2; forget this one.</source>
        <translation>選手 %1 在影格 %2 已有另一個邊界；請捨棄這個。</translation>
    </message>
    <message>
        <source>Fighter %1 has no action at frame %2.</source>
        <translation>選手 %1 在影格 %2 沒有動作。</translation>
    </message>
    <message>
        <source>The budget is a share of all actions, above 0 and at most 1.</source>
        <translation>額度是佔全部動作的比例，須大於 0 且不超過 1。</translation>
    </message>
    <message>
        <source>Player %1 has no labelled action that follows another labelled one: label more of it.</source>
        <translation>選手 %1 沒有接在已標記動作之後的已標記動作：請為這位選手標記更多。</translation>
    </message>
    <message>
        <source>The captured attack holds no action.</source>
        <translation>錄下的攻擊不含動作。</translation>
    </message>
    <message>
        <source>No take of two shows player %1.</source>
        <translation>沒有任何雙人鏡次含有選手 %1。</translation>
    </message>
    <message>
        <source>The captured attack cannot be shown: its take is missing.</source>
        <translation>無法顯示錄下的攻擊：其鏡次遺失。</translation>
    </message>
    <message>
        <source>Player %1 shows nothing but attacks outside of the captured one.</source>
        <translation>除了錄下的攻擊之外，選手 %1 也只有攻擊。</translation>
    </message>
    <message>
        <source>No recorded moment shows both fighters labelled.</source>
        <translation>錄製中沒有任何時刻是雙方都有標籤的。</translation>
    </message>
    <message>
        <source>Only a bout with an avatar can be steered.</source>
        <translation>只有化身模式的對打可以操控。</translation>
    </message>
    <message>
        <source>The library was made without an avatar&apos;s model.</source>
        <translation>資料庫建立時沒有化身的模型。</translation>
    </message>
    <message>
        <source>Player %1 never shows &quot;%2&quot; after another labelled action.</source>
        <translation>選手 %1 從未在其他已標記動作之後做出「%2」。</translation>
    </message>
    <message>
        <source>A weight is 0 (never) or a positive factor.</source>
        <translation>權重為 0（永不）或正的倍數。</translation>
    </message>
    <message>
        <source>A temperature is 0 or positive.</source>
        <translation>溫度為 0 或正數。</translation>
    </message>
    <message>
        <source>No action of the avatar is followed by half a second of its take.</source>
        <translation>化身的每個動作之後，鏡次都剩不到半秒。</translation>
    </message>
    <message>
        <source>The action has no frame.</source>
        <translation>此動作沒有影格。</translation>
    </message>
    <message>
        <source>The threshold of pose clusters must be a positive number.</source>
        <translation>姿勢群集的門檻必須是正數。</translation>
    </message>
    <message>
        <source>The block &quot;%1&quot; has no motion.</source>
        <translation>區塊「%1」沒有動態。</translation>
    </message>
    <message>
        <source>Frames %1:%2 cannot be taken from &quot;%3&quot;, which has %4.</source>
        <translation>無法從「%3」取用影格 %1:%2；它有 %4 個影格。</translation>
    </message>
    <message>
        <source>The block &quot;%1&quot; has no frame.</source>
        <translation>區塊「%1」沒有影格。</translation>
    </message>
    <message>
        <source>The sequence has no block.</source>
        <translation>序列沒有區塊。</translation>
    </message>
    <message>
        <source>There is no path in the graph between these two actions; choose a curve, or clips played backward.</source>
        <translation>圖中沒有連接這兩個動作的路徑；請選擇曲線，或倒轉播放的片段。</translation>
    </message>
    <message>
        <source>There are %1 candidate paths, counted from 0: no path %2.</source>
        <translation>共有 %1 條候選路徑，從 0 起算：沒有路徑 %2。</translation>
    </message>
    <message>
        <source>A transition needs motion on both sides.</source>
        <translation>轉換的前後都要有動態。</translation>
    </message>
    <message>
        <source>%1 (%2–%3 s, fighter %4): %5</source>
        <translation>%1（%2–%3 s，選手 %4）：%5</translation>
    </message>
    <message>
        <source>at least one whole frame</source>
        <translation>至少一個完整影格</translation>
    </message>
    <message>
        <source>the number of a frame</source>
        <translation>影格編號</translation>
    </message>
    <message>
        <source>a bone of the skeleton that has a dof, or the number of the frame after %1</source>
        <translation>骨架中有 dof 的骨骼，或影格 %1 之後的影格編號</translation>
    </message>
    <message>
        <source>each bone once in frame %1</source>
        <translation>影格 %1 中每個骨骼各一次</translation>
    </message>
    <message>
        <source>a number for bone %1 in frame %2</source>
        <translation>影格 %2 中骨骼 %1 的數字</translation>
    </message>
    <message>
        <source>only %1 numbers for bone %2 in frame %3</source>
        <translation>影格 %3 中骨骼 %2 只有 %1 個數字</translation>
    </message>
    <message>
        <source>a section of an ASF file, such as :units or :bonedata</source>
        <translation>ASF 檔案的區段，例如 :units 或 :bonedata</translation>
    </message>
    <message>
        <source>the section :root</source>
        <translation>:root 區段</translation>
    </message>
    <message>
        <source>the section :hierarchy</source>
        <translation>:hierarchy 區段</translation>
    </message>
    <message>
        <source>deg or rad</source>
        <translation>deg 或 rad</translation>
    </message>
    <message>
        <source>order, axis, position or orientation</source>
        <translation>order、axis、position 或 orientation</translation>
    </message>
    <message>
        <source>10000 bones at most</source>
        <translation>最多 10000 個骨骼</translation>
    </message>
    <message>
        <source>end, behind the last line of a bone</source>
        <translation>end，位於骨骼的最後一行之後</translation>
    </message>
    <message>
        <source>the name of a bone of :bonedata, or end</source>
        <translation>:bonedata 中的骨骼名稱，或 end</translation>
    </message>
    <message>
        <source>an order of rotations, such as XYZ</source>
        <translation>旋轉順序，例如 XYZ</translation>
    </message>
    <message>
        <source>each degree of freedom once</source>
        <translation>每個自由度各一次</translation>
    </message>
    <message>
        <source>OFFSET, CHANNELS, JOINT, End Site or } in joint %1</source>
        <translation>關節 %1 中的 OFFSET、CHANNELS、JOINT、End Site 或 }</translation>
    </message>
    <message>
        <source>the number of channels, 0 to 6</source>
        <translation>通道數，0 到 6</translation>
    </message>
    <message>
        <source>each channel once in a joint</source>
        <translation>每個通道在一個關節中只出現一次</translation>
    </message>
    <message>
        <source>channel %1 of %2: Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation</source>
        <translation>%2 的通道 %1：Xposition、Yposition、Zposition、Xrotation、Yrotation 或 Zrotation</translation>
    </message>
    <message>
        <source>a finite number with a decimal point</source>
        <translation>以小數點表示的有限數值</translation>
    </message>
    <message>
        <source>no action of the opponent at that time</source>
        <translation>對手當時沒有動作</translation>
    </message>
    <message>
        <source>the opponent&apos;s action is no attack</source>
        <translation>對手的動作不是攻擊</translation>
    </message>
    <message>
        <source>stands left</source>
        <translation>左腳支撐</translation>
    </message>
    <message>
        <source>stands right</source>
        <translation>右腳支撐</translation>
    </message>
    <message>
        <source>in the air</source>
        <translation>騰空</translation>
    </message>
    <message>
        <source>opponent&apos;s %1, closing only %2 m/s</source>
        <translation>對手的%1，逼近速度僅 %2 m/s</translation>
    </message>
    <message>
        <source>opponent&apos;s %1, closing %2 m/s</source>
        <translation>對手的%1，逼近速度 %2 m/s</translation>
    </message>
    <message>
        <source>%1 at the beginning, %2 at the end</source>
        <translation>開始時%1，結束時%2</translation>
    </message>
    <message>
        <source>There is no root %1; the recording has %2.</source>
        <translation>沒有根節點 %1；錄製檔中有 %2。</translation>
    </message>
    <message>
        <source>The body stands on its head most of the time: is up right?</source>
        <translation>身體大部分時間頭下腳上：上方軸正確嗎？</translation>
    </message>
    <message>
        <source>The legs would be %1 m long: is the unit (%2) right?</source>
        <translation>腿長會是 %1 m：單位（%2）正確嗎？</translation>
    </message>
    <message>
        <source>Relative to the legs the target&apos;s arms are %1 % longer: hands do not reach the same places.</source>
        <translation>以腿長為準，目標骨架的手臂長了 %1%：雙手到不了相同的位置。</translation>
    </message>
    <message>
        <source>Relative to the legs the target&apos;s arms are %1 % shorter: hands do not reach the same places.</source>
        <translation>以腿長為準，目標骨架的手臂短了 %1%：雙手到不了相同的位置。</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>frames %1:%2 cannot be taken from a recording of %3 frames.</source>
        <translation>影格 %1:%2 無法從 %3 個影格的錄製中取出。</translation>
    </message>
    <message>
        <source>found %1 data, expected BVH or ASF/AMC: import it into Blender and export it as Motion Capture (.bvh).</source>
        <translation>讀到 %1 資料；應為 BVH 或 ASF/AMC。請匯入 Blender，再匯出為 Motion Capture (.bvh)。</translation>
    </message>
    <message>
        <source>the opponent&apos;s action is not labelled yet</source>
        <translation>對手的動作尚未標記</translation>
    </message>
</context>
<context>
    <name>KeysSheet</name>
    <message>
        <source>Kumite: keys and mouse</source>
        <translation>Kumite：按鍵與滑鼠</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>pelvis</source>
        <translation>骨盆</translation>
    </message>
    <message>
        <source>spine</source>
        <translation>脊椎</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>胸部</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>頸部</translation>
    </message>
    <message>
        <source>head</source>
        <translation>頭部</translation>
    </message>
    <message>
        <source>left clavicle</source>
        <translation>左鎖骨</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>左肩</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>左肘</translation>
    </message>
    <message>
        <source>left wrist</source>
        <translation>左腕</translation>
    </message>
    <message>
        <source>left hip</source>
        <translation>左髖</translation>
    </message>
    <message>
        <source>left knee</source>
        <translation>左膝</translation>
    </message>
    <message>
        <source>left ankle</source>
        <translation>左踝</translation>
    </message>
    <message>
        <source>left toe</source>
        <translation>左腳趾</translation>
    </message>
    <message>
        <source>right clavicle</source>
        <translation>右鎖骨</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>右肩</translation>
    </message>
    <message>
        <source>right elbow</source>
        <translation>右肘</translation>
    </message>
    <message>
        <source>right wrist</source>
        <translation>右腕</translation>
    </message>
    <message>
        <source>right hip</source>
        <translation>右髖</translation>
    </message>
    <message>
        <source>right knee</source>
        <translation>右膝</translation>
    </message>
    <message>
        <source>right ankle</source>
        <translation>右踝</translation>
    </message>
    <message>
        <source>right toe</source>
        <translation>右腳趾</translation>
    </message>
</context>
<context>
    <name>ShortLabel</name>
    <message>
        <source>fwd</source>
        <translation>前</translation>
    </message>
    <message>
        <source>bwd</source>
        <translation>後</translation>
    </message>
    <message>
        <source>bwdfwd</source>
        <translation>後前</translation>
    </message>
    <message>
        <source>fwdbwd</source>
        <translation>前後</translation>
    </message>
    <message>
        <source>up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>down</source>
        <translation>下</translation>
    </message>
    <message>
        <source>downup</source>
        <translation>下上</translation>
    </message>
    <message>
        <source>kick</source>
        <translation>踢</translation>
    </message>
    <message>
        <source>punch</source>
        <translation>拳</translation>
    </message>
    <message>
        <source>L-L</source>
        <translation>左-左</translation>
    </message>
    <message>
        <source>L-R</source>
        <translation>左-右</translation>
    </message>
    <message>
        <source>L-F</source>
        <translation>左-空</translation>
    </message>
    <message>
        <source>R-L</source>
        <translation>右-左</translation>
    </message>
    <message>
        <source>R-R</source>
        <translation>右-右</translation>
    </message>
    <message>
        <source>R-F</source>
        <translation>右-空</translation>
    </message>
    <message>
        <source>F-L</source>
        <translation>空-左</translation>
    </message>
    <message>
        <source>F-R</source>
        <translation>空-右</translation>
    </message>
    <message>
        <source>F-F</source>
        <translation>空-空</translation>
    </message>
</context>
<context>
    <name>Vocabulary</name>
    <message>
        <source>Left punch</source>
        <translation>左拳</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>向前</translation>
    </message>
    <message>
        <source>back</source>
        <translation>向後</translation>
    </message>
    <message>
        <source>back and forward</source>
        <translation>向後再向前</translation>
    </message>
    <message>
        <source>forward and back</source>
        <translation>向前再向後</translation>
    </message>
    <message>
        <source>none</source>
        <translation>無</translation>
    </message>
    <message>
        <source>Right punch</source>
        <translation>右拳</translation>
    </message>
    <message>
        <source>Left kick</source>
        <translation>左踢</translation>
    </message>
    <message>
        <source>up</source>
        <translation>向上</translation>
    </message>
    <message>
        <source>down</source>
        <translation>向下</translation>
    </message>
    <message>
        <source>down and up</source>
        <translation>向下再向上</translation>
    </message>
    <message>
        <source>Right kick</source>
        <translation>右踢</translation>
    </message>
    <message>
        <source>Jump</source>
        <translation>跳躍</translation>
    </message>
    <message>
        <source>React</source>
        <translation>反應</translation>
    </message>
    <message>
        <source>to a kick</source>
        <translation>對踢擊</translation>
    </message>
    <message>
        <source>to a punch</source>
        <translation>對拳擊</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>left to left</source>
        <translation>左到左</translation>
    </message>
    <message>
        <source>left to right</source>
        <translation>左到右</translation>
    </message>
    <message>
        <source>left to flight</source>
        <translation>左到騰空</translation>
    </message>
    <message>
        <source>right to left</source>
        <translation>右到左</translation>
    </message>
    <message>
        <source>right to right</source>
        <translation>右到右</translation>
    </message>
    <message>
        <source>right to flight</source>
        <translation>右到騰空</translation>
    </message>
    <message>
        <source>flight to left</source>
        <translation>騰空到左</translation>
    </message>
    <message>
        <source>flight to right</source>
        <translation>騰空到右</translation>
    </message>
    <message>
        <source>flight to flight</source>
        <translation>騰空到騰空</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>無</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Key: %1</source>
        <translation>按鍵：%1</translation>
    </message>
</context>
<context>
    <name>kumite</name>
    <message>
        <source>Male means (de Leva 1996)</source>
        <translation>男性平均值（de Leva 1996）</translation>
    </message>
    <message>
        <source>Female means (de Leva 1996)</source>
        <translation>女性平均值（de Leva 1996）</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>今天 %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>昨天 %1</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>極小值</translation>
    </message>
    <message>
        <source>foot contact</source>
        <translation>足部接觸</translation>
    </message>
    <message>
        <source>boundary of the other</source>
        <translation>另一方的邊界</translation>
    </message>
    <message>
        <source>playhead</source>
        <translation>播放頭</translation>
    </message>
</context>
<context>
    <name>kumite::studio</name>
    <message>
        <source>example, sample, tutorial, try</source>
        <translation>範例, 樣本, 教學, 試用, 示範</translation>
    </message>
    <message>
        <source>import, load, bvh, amc, asf, mocap, motion capture, new project</source>
        <translation>匯入, 載入, bvh, amc, asf, mocap, 動作捕捉, 動捕, 新專案</translation>
    </message>
    <message>
        <source>load, kumite file</source>
        <translation>載入, 開檔, kumite 檔案</translation>
    </message>
    <message>
        <source>store, write</source>
        <translation>存檔, 寫入, 保存</translation>
    </message>
    <message>
        <source>copy, rename project, duplicate</source>
        <translation>複製, 重新命名專案, 副本, 另存新檔</translation>
    </message>
    <message>
        <source>backup, restore, earlier, revert, snapshot</source>
        <translation>備份, 還原, 先前, 回復, 快照</translation>
    </message>
    <message>
        <source>csv, json, table, spreadsheet, results, segmentation</source>
        <translation>csv, json, 表格, 試算表, 結果, 分段</translation>
    </message>
    <message>
        <source>bvh, skeleton, animation, blender, mocap</source>
        <translation>bvh, 骨架, 動畫, blender, 動捕</translation>
    </message>
    <message>
        <source>missing, relink, locate, moved</source>
        <translation>遺失, 重新連結, 找檔案, 已移動</translation>
    </message>
    <message>
        <source>exit, close, leave</source>
        <translation>離開, 關閉, 退出</translation>
    </message>
    <message>
        <source>back, revert, oops</source>
        <translation>返回, 還原, 上一步</translation>
    </message>
    <message>
        <source>again, repeat</source>
        <translation>再一次, 取消復原, 重複</translation>
    </message>
    <message>
        <source>settings, options, configuration, shortcuts, autosave</source>
        <translation>設定, 選項, 組態, 快速鍵, 自動儲存</translation>
    </message>
    <message>
        <source>import, new, load, clip, session</source>
        <translation>匯入, 新增, 載入, 片段, 鏡次, 場次</translation>
    </message>
    <message>
        <source>name, title</source>
        <translation>名稱, 標題, 改名</translation>
    </message>
    <message>
        <source>delete, close, clip</source>
        <translation>刪除, 關閉, 片段</translation>
    </message>
    <message>
        <source>previous clip, switch</source>
        <translation>上一個片段, 切換</translation>
    </message>
    <message>
        <source>next clip, switch</source>
        <translation>下一個片段, 切換</translation>
    </message>
    <message>
        <source>switch, opponent, toggle, player</source>
        <translation>切換, 對手, 玩家, 選手</translation>
    </message>
    <message>
        <source>joints, roles, skeleton, rate, offset, sync, floor, body model, mass</source>
        <translation>關節, 角色, 骨架, 取樣率, 位移, 同步, 地板, 身體模型, 質量</translation>
    </message>
    <message>
        <source>exchange, colours, player</source>
        <translation>對調, 交換, 顏色, 玩家</translation>
    </message>
    <message>
        <source>warnings, problems, errors, log, report</source>
        <translation>警告, 問題, 錯誤, 記錄, 報告</translation>
    </message>
    <message>
        <source>delete, erase, clear, undelete, merge, cut</source>
        <translation>刪除, 清除, 取消刪除, 合併, 剪下</translation>
    </message>
    <message>
        <source>split, cut, insert, new, razor, slice, mark, here</source>
        <translation>分割, 切割, 插入, 新增, 剃刀, 切片, 標記, 此處</translation>
    </message>
    <message>
        <source>merge left, combine, previous</source>
        <translation>向左合併, 結合, 上一個</translation>
    </message>
    <message>
        <source>merge right, combine, next</source>
        <translation>向右合併, 結合, 下一個</translation>
    </message>
    <message>
        <source>nudge left, shift</source>
        <translation>向左微移, 位移</translation>
    </message>
    <message>
        <source>nudge right, shift</source>
        <translation>向右微移, 位移</translation>
    </message>
    <message>
        <source>repeat, zoom to action, segment</source>
        <translation>重複, 縮放至動作, 分段</translation>
    </message>
    <message>
        <source>comment, annotate, remark, text, label</source>
        <translation>註解, 註記, 備註, 文字, 標籤</translation>
    </message>
    <message>
        <source>review, suspicious, error, uncertain, queue</source>
        <translation>檢查, 可疑, 錯誤, 不確定, 佇列</translation>
    </message>
    <message>
        <source>review, suspicious</source>
        <translation>檢查, 可疑</translation>
    </message>
    <message>
        <source>accept, approve, confirm, ok, yes, good</source>
        <translation>接受, 同意, 確認, 好, 是, 正確, ok</translation>
    </message>
    <message>
        <source>reject, delete, dismiss, discard, no, false, wrong</source>
        <translation>拒絕, 刪除, 忽略, 捨棄, 否, 錯誤</translation>
    </message>
    <message>
        <source>reset, reopen, undecided, withdraw</source>
        <translation>重設, 重新開啟, 未決定, 撤回</translation>
    </message>
    <message>
        <source>difference, a/b, versus, parameters</source>
        <translation>差異, a/b, 對比, 參數</translation>
    </message>
    <message>
        <source>raw, unfiltered, noise</source>
        <translation>原始, 未濾波, 雜訊</translation>
    </message>
    <message>
        <source>com, cog, gravity</source>
        <translation>com, cog, 重心, 質心</translation>
    </message>
    <message>
        <source>velocity, wrist, punch</source>
        <translation>速度, 手腕, 出拳</translation>
    </message>
    <message>
        <source>velocity, ankle, kick</source>
        <translation>速度, 腳踝, 踢</translation>
    </message>
    <message>
        <source>seconds, frames, timecode</source>
        <translation>秒, 影格, 時間碼</translation>
    </message>
    <message>
        <source>start, stop, run</source>
        <translation>開始, 停止, 執行</translation>
    </message>
    <message>
        <source>pause, halt</source>
        <translation>暫停, 停下</translation>
    </message>
    <message>
        <source>rewind, shuttle</source>
        <translation>倒帶, 倒轉, 快倒</translation>
    </message>
    <message>
        <source>fast forward, shuttle</source>
        <translation>快轉, 快進</translation>
    </message>
    <message>
        <source>previous frame, step</source>
        <translation>上一影格, 單格</translation>
    </message>
    <message>
        <source>next frame, step</source>
        <translation>下一影格, 單格</translation>
    </message>
    <message>
        <source>beginning, first frame, rewind</source>
        <translation>開頭, 第一影格, 倒帶</translation>
    </message>
    <message>
        <source>last frame</source>
        <translation>最後影格, 結尾</translation>
    </message>
    <message>
        <source>slow motion, speed, rate</source>
        <translation>慢動作, 速度, 速率</translation>
    </message>
    <message>
        <source>speed up, rate</source>
        <translation>加速, 速率</translation>
    </message>
    <message>
        <source>repeat, cycle</source>
        <translation>重複, 循環播放</translation>
    </message>
    <message>
        <source>in point, mark in, start, range</source>
        <translation>入點, 標記入點, 開始, 範圍</translation>
    </message>
    <message>
        <source>out point, mark out, end, range</source>
        <translation>出點, 標記出點, 結束, 範圍</translation>
    </message>
    <message>
        <source>fit, frame all, zoom out, home, reset view</source>
        <translation>符合視窗, 全部顯示, 縮小, 首頁, 重設檢視</translation>
    </message>
    <message>
        <source>frame selected, zoom in, focus, centre</source>
        <translation>顯示選取項目, 放大, 對焦, 置中</translation>
    </message>
    <message>
        <source>sidebar, show panels, focus mode</source>
        <translation>側邊欄, 顯示面板, 專注模式</translation>
    </message>
    <message>
        <source>maximise, maximize</source>
        <translation>最大化, 全螢幕</translation>
    </message>
    <message>
        <source>font size, zoom, bigger, accessibility, scale</source>
        <translation>文字大小, 縮放, 放大, 無障礙, 比例</translation>
    </message>
    <message>
        <source>font size, zoom, scale</source>
        <translation>文字大小, 縮放, 比例</translation>
    </message>
    <message>
        <source>dark mode, light mode, colours, auto</source>
        <translation>深色模式, 淺色模式, 顏色, 自動</translation>
    </message>
    <message>
        <source>light mode, bright, white, day, colours</source>
        <translation>淺色模式, 明亮, 白色, 日間, 顏色</translation>
    </message>
    <message>
        <source>dark mode, black, night, colours</source>
        <translation>深色模式, 黑色, 夜間, 顏色</translation>
    </message>
    <message>
        <source>camera, front view</source>
        <translation>攝影機, 正面, 前視</translation>
    </message>
    <message>
        <source>camera, side view, left, right, profile</source>
        <translation>攝影機, 側面, 側視, 左, 右</translation>
    </message>
    <message>
        <source>camera, top view, bird</source>
        <translation>攝影機, 俯視, 上視, 鳥瞰</translation>
    </message>
    <message>
        <source>camera, behind, third person</source>
        <translation>攝影機, 後方, 第三人稱</translation>
    </message>
    <message>
        <source>camera, track</source>
        <translation>攝影機, 追蹤</translation>
    </message>
    <message>
        <source>footsteps, feet, ground</source>
        <translation>腳步, 足部, 腳, 地面</translation>
    </message>
    <message>
        <source>trajectory, path, motion trail</source>
        <translation>軌跡, 路徑, 動態軌跡</translation>
    </message>
    <message>
        <source>com, cog, center, gravity</source>
        <translation>com, cog, 質心, 重心</translation>
    </message>
    <message>
        <source>arrow, vector, ground reaction</source>
        <translation>箭頭, 向量, 地面反作用力</translation>
    </message>
    <message>
        <source>onion skin</source>
        <translation>洋蔥皮, 殘影</translation>
    </message>
    <message>
        <source>onion skin, pose, stamp</source>
        <translation>洋蔥皮, 姿勢, 印記</translation>
    </message>
    <message>
        <source>delete ghosts, onion skin</source>
        <translation>刪除殘影, 洋蔥皮</translation>
    </message>
    <message>
        <source>distance, ruler, speed, tape</source>
        <translation>距離, 尺, 速度, 捲尺</translation>
    </message>
    <message>
        <source>screenshot, clipboard, image</source>
        <translation>螢幕截圖, 剪貼簿, 影像</translation>
    </message>
    <message>
        <source>screenshot, render, image, png, export picture, capture</source>
        <translation>螢幕截圖, 算圖, 影像, png, 匯出圖片, 擷取</translation>
    </message>
    <message>
        <source>start, stop, preview</source>
        <translation>開始, 停止, 預覽</translation>
    </message>
    <message>
        <source>jump back, skip</source>
        <translation>向後跳, 略過</translation>
    </message>
    <message>
        <source>jump forward, skip</source>
        <translation>向前跳, 略過</translation>
    </message>
    <message>
        <source>preview, result, assembled, synthesised, before, after</source>
        <translation>預覽, 結果, 組合, 合成, 之前, 之後</translation>
    </message>
    <message>
        <source>punch, kick, strike, aim, reach, target tool</source>
        <translation>出拳, 踢, 打擊, 瞄準, 搆到, 目標工具</translation>
    </message>
    <message>
        <source>insert key, new pose, keyframe, set key</source>
        <translation>插入關鍵格, 新姿勢, 關鍵影格, 設定關鍵格</translation>
    </message>
    <message>
        <source>delete key, erase</source>
        <translation>刪除關鍵格, 清除</translation>
    </message>
    <message>
        <source>previous keyframe, jump</source>
        <translation>上一個關鍵影格, 跳至</translation>
    </message>
    <message>
        <source>next keyframe, jump</source>
        <translation>下一個關鍵影格, 跳至</translation>
    </message>
    <message>
        <source>nudge left, time, shift</source>
        <translation>向左微移, 時間, 位移</translation>
    </message>
    <message>
        <source>nudge right, time, shift</source>
        <translation>向右微移, 時間, 位移</translation>
    </message>
    <message>
        <source>duplicate key, clone, paste</source>
        <translation>複製關鍵格, 再製, 貼上</translation>
    </message>
    <message>
        <source>flip, left, right, symmetry, reverse</source>
        <translation>翻轉, 左, 右, 對稱, 反轉</translation>
    </message>
    <message>
        <source>grab, capture, snapshot, recording</source>
        <translation>抓取, 擷取, 快照, 錄製</translation>
    </message>
    <message>
        <source>paste pose, browse, frame, library, import pose</source>
        <translation>貼上姿勢, 瀏覽, 影格, 資料庫, 匯入姿勢</translation>
    </message>
    <message>
        <source>rotate, gizmo, ring, fk, angle, elbow, knee</source>
        <translation>旋轉, 操縱環, 環, fk, 角度, 手肘, 膝蓋</translation>
    </message>
    <message>
        <source>rotate, gizmo, ring, fk, angle</source>
        <translation>旋轉, 操縱環, 環, fk, 角度</translation>
    </message>
    <message>
        <source>ripple, shift, time, slide left</source>
        <translation>移動, 時間, 向左</translation>
    </message>
    <message>
        <source>ripple, shift, time, slide right</source>
        <translation>移動, 時間, 向右</translation>
    </message>
    <message>
        <source>retime, faster, speed up, compress, scale time</source>
        <translation>調整時間, 加快, 加速, 壓縮, 時間比例</translation>
    </message>
    <message>
        <source>retime, slower, slow down, stretch, scale time</source>
        <translation>調整時間, 放慢, 減速, 拉長, 時間比例</translation>
    </message>
    <message>
        <source>before, after, compare, side by side, a/b, unadjusted</source>
        <translation>之前, 之後, 比較, 並排, a/b, 未調整</translation>
    </message>
    <message>
        <source>onion skin, onion skinning, ghost</source>
        <translation>洋蔥皮, 殘影</translation>
    </message>
    <message>
        <source>partial edit, swap arm, splice, layer, fix, retake</source>
        <translation>局部編輯, 換手臂, 拼接, 圖層, 修正, 重拍</translation>
    </message>
    <message>
        <source>tab, panel, joint, handle</source>
        <translation>分頁, 面板, 關節, 控制點</translation>
    </message>
    <message>
        <source>tab, panel, find similar, retrieval, sources, parts</source>
        <translation>分頁, 面板, 尋找相似, 檢索, 來源, 部位</translation>
    </message>
    <message>
        <source>lock, fix, nail, constraint, hold foot</source>
        <translation>鎖定, 固定, 釘住, 約束, 固定腳</translation>
    </message>
    <message>
        <source>effector, hand, foot, ik, select</source>
        <translation>末端效應器, 手, 腳, ik, 選取</translation>
    </message>
    <message>
        <source>raise, nudge, ik</source>
        <translation>抬高, 微移, ik</translation>
    </message>
    <message>
        <source>lower, nudge, ik</source>
        <translation>降低, 微移, ik</translation>
    </message>
    <message>
        <source>nudge, ik, left</source>
        <translation>微移, ik, 左</translation>
    </message>
    <message>
        <source>nudge, ik, right</source>
        <translation>微移, ik, 右</translation>
    </message>
    <message>
        <source>nudge, ik, back</source>
        <translation>微移, ik, 後</translation>
    </message>
    <message>
        <source>nudge, ik, forward</source>
        <translation>微移, ik, 前</translation>
    </message>
    <message>
        <source>source, automatic, best match, reset</source>
        <translation>來源, 自動, 最佳比對, 重設</translation>
    </message>
    <message>
        <source>delete all, reset, start over</source>
        <translation>全部刪除, 重設, 從頭開始</translation>
    </message>
    <message>
        <source>import, library, load, bvh</source>
        <translation>匯入, 資料庫, 載入, bvh</translation>
    </message>
    <message>
        <source>import, library, directory, bvh</source>
        <translation>匯入, 資料庫, 目錄, 資料夾, bvh</translation>
    </message>
    <message>
        <source>save, bake, new take</source>
        <translation>儲存, 烘焙, 新鏡次</translation>
    </message>
    <message>
        <source>save, bvh, gltf, glb, animation</source>
        <translation>儲存, bvh, gltf, glb, 動畫</translation>
    </message>
    <message>
        <source>beginning, rewind</source>
        <translation>開頭, 倒帶</translation>
    </message>
    <message>
        <source>repeat, cycle, endless</source>
        <translation>重複, 循環, 無限</translation>
    </message>
    <message>
        <source>play live, game, controller, real time</source>
        <translation>即時播放, 遊戲, 控制器, 即時</translation>
    </message>
    <message>
        <source>stop live, end</source>
        <translation>停止即時, 結束</translation>
    </message>
    <message>
        <source>insert, append, clip, action</source>
        <translation>插入, 附加, 片段, 動作</translation>
    </message>
    <message>
        <source>replace, exchange, other action</source>
        <translation>取代, 交換, 其他動作</translation>
    </message>
    <message>
        <source>delete, erase, cut</source>
        <translation>刪除, 清除, 剪下</translation>
    </message>
    <message>
        <source>select, jump</source>
        <translation>選取, 跳至</translation>
    </message>
    <message>
        <source>move left, reorder</source>
        <translation>左移, 重新排序</translation>
    </message>
    <message>
        <source>move right, reorder</source>
        <translation>右移, 重新排序</translation>
    </message>
    <message>
        <source>repeat, again, loop</source>
        <translation>重複, 再一次, 循環</translation>
    </message>
    <message>
        <source>repeat less</source>
        <translation>減少重複</translation>
    </message>
    <message>
        <source>trim, in point, cut start</source>
        <translation>修剪, 入點, 裁切開頭</translation>
    </message>
    <message>
        <source>trim, out point, cut end</source>
        <translation>修剪, 出點, 裁切結尾</translation>
    </message>
    <message>
        <source>untrim, reset</source>
        <translation>取消修剪, 重設</translation>
    </message>
    <message>
        <source>random, reroll, blend, other path</source>
        <translation>隨機, 重抽, 混合, 其他路徑</translation>
    </message>
    <message>
        <source>random, reroll, shuffle</source>
        <translation>隨機, 重抽, 洗牌</translation>
    </message>
    <message>
        <source>fix, hold, keep</source>
        <translation>固定, 保持, 保留</translation>
    </message>
    <message>
        <source>delete all, new, reset</source>
        <translation>全部刪除, 新增, 重設</translation>
    </message>
    <message>
        <source>search, filter, actions</source>
        <translation>搜尋, 篩選, 動作</translation>
    </message>
    <message>
        <source>library, list, show</source>
        <translation>資料庫, 清單, 顯示</translation>
    </message>
    <message>
        <source>clusters, poses, graph, space</source>
        <translation>群集, 姿勢, 圖, 空間</translation>
    </message>
    <message>
        <source>manual, documentation, guide</source>
        <translation>手冊, 文件, 指南, 使用說明</translation>
    </message>
    <message>
        <source>tutorial, introduction, start, guide</source>
        <translation>教學, 簡介, 入門, 指南</translation>
    </message>
    <message>
        <source>formula, explain, statistics, papers, sources</source>
        <translation>公式, 解說, 統計, 論文, 來源</translation>
    </message>
    <message>
        <source>tutorial, introduction, walkthrough, wizard, guide</source>
        <translation>教學, 簡介, 導覽, 精靈, 指南</translation>
    </message>
    <message>
        <source>explain, context help</source>
        <translation>解說, 情境說明, 這是什麼</translation>
    </message>
    <message>
        <source>explain, accessibility</source>
        <translation>解說, 無障礙, 協助工具</translation>
    </message>
    <message>
        <source>shortcuts, hotkeys, cheat sheet, help, manual, print</source>
        <translation>快速鍵, 熱鍵, 速查表, 說明, 手冊, 列印</translation>
    </message>
    <message>
        <source>release notes, changelog, news, version</source>
        <translation>版本說明, 更新記錄, 新功能, 最新消息, 版本</translation>
    </message>
    <message>
        <source>version, licence, license</source>
        <translation>版本, 授權</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ActionTiles</name>
    <message>
        <source>Similar actions</source>
        <translation>相似動作</translation>
    </message>
    <message>
        <source>Those that look most like the current action, side by side.</source>
        <translation>與目前動作最相似的動作，並排顯示。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ActionsModel</name>
    <message>
        <source>%1, %2 from %3
Return adds it, Shift+Return swaps it for the chosen block</source>
        <translation>%1，%2，取自 %3
Return 加入，Shift+Return 取代所選區塊</translation>
    </message>
    <message>
        <source>action</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutBar</name>
    <message>
        <source>Time of the bout</source>
        <translation>對打的時間</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>/ %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutCommands</name>
    <message>
        <source>Avatar: %1</source>
        <translation>化身：%1</translation>
    </message>
    <message>
        <source>The analysis is not finished yet.</source>
        <translation>分析尚未完成。</translation>
    </message>
    <message>
        <source>Keep the bout as a take</source>
        <translation>將對打存為鏡次</translation>
    </message>
    <message>
        <source>Recordings, NAME-1 and NAME-2 (*.bvh)</source>
        <translation>錄製檔，名稱-1 與 名稱-2 (*.bvh)</translation>
    </message>
    <message>
        <source>Keeping the bout</source>
        <translation>正在保留對打</translation>
    </message>
    <message>
        <source>The project changed while the bout was written. Its files are there; open them as a take, or keep it again under another name.</source>
        <translation>寫入對打時專案有變動。檔案已經存在；請把它們當成鏡次開啟，或換個名稱再存一次。</translation>
    </message>
    <message>
        <source>Kept as take %1. Detection alone finds %2 % and %3 % of its boundaries.</source>
        <translation>已存為鏡次 %1。單靠偵測找到其中 %2 % 和 %3 % 的邊界。</translation>
    </message>
    <message>
        <source>Writing the bout</source>
        <translation>正在寫入對打</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Export the bout</source>
        <translation>匯出對打</translation>
    </message>
    <message>
        <source>Motion of both, NAME-1 and NAME-2 (*.bvh);;glTF: skeletons and animation (*.glb);;Pictures, 30 a second (*.png);;Video, by ffmpeg (*.mp4);;Log: everything that makes it again (*.json)</source>
        <translation>雙方動態，名稱-1 與 名稱-2 (*.bvh);;glTF：骨架與動畫 (*.glb);;圖片，每秒 30 張 (*.png);;影片，由 ffmpeg 製作 (*.mp4);;記錄：重現所需的一切 (*.json)</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已寫入：%1</translation>
    </message>
    <message>
        <source>&amp;Bout</source>
        <translation>對打(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Fight or pause</source>
        <translation>開打或暫停(&amp;F)</translation>
    </message>
    <message>
        <source>Begin a&amp;new</source>
        <translation>重新開始(&amp;N)</translation>
    </message>
    <message>
        <source>Begin with the next &amp;seed</source>
        <translation>以下一個種子開始(&amp;S)</translation>
    </message>
    <message>
        <source>Go on from here with other &amp;draws</source>
        <translation>從此處以其他抽選繼續(&amp;D)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>後退一影格</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>前進一影格</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>後退一秒</translation>
    </message>
    <message>
        <source>One second on</source>
        <translation>前進一秒</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>到開頭</translation>
    </message>
    <message>
        <source>To the end of what was shown</source>
        <translation>到已播放內容的結尾</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>放慢</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>加快</translation>
    </message>
    <message>
        <source>&amp;Automatic: the model decides</source>
        <translation>自動：由模型決定(&amp;A)</translation>
    </message>
    <message>
        <source>A&amp;vatar: keys lead one fighter</source>
        <translation>化身：以按鍵操控一名選手(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Passive: one answers a captured attack</source>
        <translation>被動：一方回應錄下的攻擊(&amp;P)</translation>
    </message>
    <message>
        <source>Avatar: key %1</source>
        <translation>化身：按鍵 %1</translation>
    </message>
    <message>
        <source>Avatar: forget &amp;what was asked for</source>
        <translation>化身：取消要求(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Measure the quality</source>
        <translation>測量品質(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Keep as a take…</source>
        <translation>存為鏡次(&amp;K)…</translation>
    </message>
    <message>
        <source>E&amp;xport the bout…</source>
        <translation>匯出對打(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutExport</name>
    <message>
        <source>%1: it cannot be written there.</source>
        <translation>%1：無法寫入該處。</translation>
    </message>
    <message>
        <source>There is no ffmpeg on this computer, which a video needs: install it (on Debian and Ubuntu: sudo apt install ffmpeg), or export pictures (.png).</source>
        <translation>製作影片需要 ffmpeg，但這台電腦上沒有：請先安裝（Debian 與 Ubuntu：sudo apt install ffmpeg），或改為匯出圖片 (.png)。</translation>
    </message>
    <message>
        <source>%1 cannot be started.</source>
        <translation>無法啟動 %1。</translation>
    </message>
    <message>
        <source>ffmpeg could not write the video: %1</source>
        <translation>ffmpeg 無法寫入影片：%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutPage</name>
    <message>
        <source>Why there is no bout</source>
        <translation>沒有對打的原因</translation>
    </message>
    <message>
        <source>Anew</source>
        <translation>重來</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>保留…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>匯出…</translation>
    </message>
    <message>
        <source>A bout that goes on for ever, made from what was learnt of the labelled actions, appears here.</source>
        <translation>這裡會出現一場永不停歇的對打，由已標記動作學到的內容產生。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutPanel</name>
    <message>
        <source>foot skate</source>
        <translation>足部滑移</translation>
    </message>
    <message>
        <source>Share of frames in which a foot near the floor slides faster than 0.5 m/s</source>
        <translation>靠近地板的腳滑動超過 0.5 m/s 的影格比例</translation>
    </message>
    <message>
        <source>in the floor</source>
        <translation>陷入地板</translation>
    </message>
    <message>
        <source>Share of frames with a foot more than 5 mm in the floor</source>
        <translation>腳陷入地板超過 5 mm 的影格比例</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>重疊</translation>
    </message>
    <message>
        <source>Share of frames with the bodies more than 3 cm in each other</source>
        <translation>雙方身體互相穿入超過 3 cm 的影格比例</translation>
    </message>
    <message>
        <source>joins</source>
        <translation>接合</translation>
    </message>
    <message>
        <source>Joint accelerations where actions are joined, their 99th percentile over that inside recorded actions</source>
        <translation>動作接合處的關節加速度：第 99 百分位數相對於錄製動作內部的比值</translation>
    </message>
    <message>
        <source>facing</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Mean angle between where a fighter faces and its opponent</source>
        <translation>選手面向與對手方向之間的平均夾角</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Mean distance between both fighters</source>
        <translation>兩名選手的平均距離</translation>
    </message>
    <message>
        <source>hit timing</source>
        <translation>命中時機</translation>
    </message>
    <message>
        <source>How far reactions are from their due moment, on average</source>
        <translation>反應與應有時刻的平均差距</translation>
    </message>
    <message>
        <source>variety</source>
        <translation>多樣性</translation>
    </message>
    <message>
        <source>Share of distinct runs of three labels; falls with length</source>
        <translation>三連標籤中相異者的比例；長度越長越低</translation>
    </message>
    <message>
        <source>reacts first</source>
        <translation>先反應</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>測量</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Avatar</source>
        <translation>化身</translation>
    </message>
    <message>
        <source>Passive</source>
        <translation>被動</translation>
    </message>
    <message>
        <source>The model decides for both</source>
        <translation>由模型決定雙方</translation>
    </message>
    <message>
        <source>Keys and pointer lead one fighter, the model the other</source>
        <translation>按鍵與指標操控一名選手，模型操控另一名</translation>
    </message>
    <message>
        <source>One replays a captured attack that the model has not seen; the other answers and may not attack</source>
        <translation>一方重播模型沒看過的錄下攻擊；另一方回應，且不得攻擊</translation>
    </message>
    <message>
        <source>Under attack the avatar may answer before it does as asked</source>
        <translation>受到攻擊時，化身可以先回應，再照要求做</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>種子</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>種子</translation>
    </message>
    <message>
        <source>The same seed gives the same bout</source>
        <translation>相同的種子產生相同的對打</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>溫度</translation>
    </message>
    <message>
        <source>0: always the likeliest; 1: as learnt; above: more even</source>
        <translation>0：永遠選最可能的；1：如所學；更高：更平均</translation>
    </message>
    <message>
        <source>State of the bout</source>
        <translation>對打狀態</translation>
    </message>
    <message>
        <source>Why this?</source>
        <translation>為何選這個？</translation>
    </message>
    <message>
        <source>The choice</source>
        <translation>此選擇</translation>
    </message>
    <message>
        <source>What else it could have done</source>
        <translation>還能怎麼做</translation>
    </message>
    <message>
        <source>A click takes another one and goes on from there</source>
        <translation>按一下改選另一個，並從該處繼續</translation>
    </message>
    <message>
        <source>It cannot be taken: %1.</source>
        <translation>無法選用：%1。</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>品質</translation>
    </message>
    <message>
        <source>Measures all that was shown, beside the longest recording</source>
        <translation>測量已播放的全部內容，與最長的錄製並列</translation>
    </message>
    <message>
        <source>Quality of the bout and of the recording</source>
        <translation>對打與錄製的品質</translation>
    </message>
    <message>
        <source>bout</source>
        <translation>對打</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>錄製</translation>
    </message>
    <message>
        <source>attacker</source>
        <translation>攻擊方</translation>
    </message>
    <message>
        <source>avatar</source>
        <translation>化身</translation>
    </message>
    <message>
        <source>Who attacks</source>
        <translation>由誰攻擊</translation>
    </message>
    <message>
        <source>Who is led</source>
        <translation>操控哪一方</translation>
    </message>
    <message>
        <source>The fighter that replays a captured attack</source>
        <translation>重播錄下攻擊的選手</translation>
    </message>
    <message>
        <source>The fighter that keys and clicks on the floor lead</source>
        <translation>由按鍵與點選地板操控的選手</translation>
    </message>
    <message>
        <source>A bout is being prepared.</source>
        <translation>正在準備對打。</translation>
    </message>
    <message>
        <source>Keys 1 to 9 ask the avatar for something, a click on the floor says where to be.</source>
        <translation>按鍵 1 到 9 對化身提出要求，按一下地板指定位置。</translation>
    </message>
    <message>
        <source>Asked for: %1</source>
        <translation>已要求：%1</translation>
    </message>
    <message>
        <source>Labels or boundaries changed: begin anew to use them.</source>
        <translation>標籤或邊界已變更：重新開始即可採用。</translation>
    </message>
    <message>
        <source>Each choice, with all that could have been, appears here.</source>
        <translation>每次選擇及所有可能的選項都會出現在這裡。</translation>
    </message>
    <message>
        <source>%1 at %2, after %3, while %4</source>
        <translation>%1，於 %2，接在 %3 之後，同時 %4</translation>
    </message>
    <message>
        <source>: replayed</source>
        <translation>：重播</translation>
    </message>
    <message>
        <source>: chosen by hand</source>
        <translation>：手動選擇</translation>
    </message>
    <message>
        <source>: as asked for</source>
        <translation>：依要求</translation>
    </message>
    <message>
        <source> (no other stance was left)</source>
        <translation> （沒有其他支撐方式可選）</translation>
    </message>
    <message>
        <source>Measure (%1 s)</source>
        <translation>測量（%1 s）</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutSession</name>
    <message>
        <source>anything</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Preparing a bout</source>
        <translation>正在準備對打</translation>
    </message>
    <message>
        <source>Measuring the bout</source>
        <translation>正在測量對打</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutStrip</name>
    <message>
        <source>Actions of the bout</source>
        <translation>對打的動作</translation>
    </message>
    <message>
        <source>%1 · %2 to %3 · %4</source>
        <translation>%1 · %2 至 %3 · %4</translation>
    </message>
    <message>
        <source>   ·   as asked for</source>
        <translation>   ·   依要求</translation>
    </message>
    <message>
        <source>   ·   chosen by hand</source>
        <translation>   ·   手動選擇</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CandidatesDelegate</name>
    <message>
        <source>P %1</source>
        <translation>P %1</translation>
    </message>
    <message>
        <source>label %1</source>
        <translation>標籤 %1</translation>
    </message>
    <message>
        <source>geom. %1</source>
        <translation>幾何 %1</translation>
    </message>
    <message>
        <source>both %1</source>
        <translation>合計 %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CandidatesModel</name>
    <message>
        <source>no example</source>
        <translation>沒有範例</translation>
    </message>
    <message>
        <source>not in this mode</source>
        <translation>此模式不適用</translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation>未要求</translation>
    </message>
    <message>
        <source>other stance</source>
        <translation>支撐腳不同</translation>
    </message>
    <message>
        <source>banned</source>
        <translation>已禁用</translation>
    </message>
    <message>
        <source>%1: chance %2, label term %3, geometry term %4, product %5</source>
        <translation>%1：機率 %2，標籤項 %3，幾何項 %4，乘積 %5</translation>
    </message>
    <message>
        <source>
Sample: %1, %2</source>
        <translation>
樣本：%1，%2</translation>
    </message>
    <message>
        <source>
Could not be drawn: %1</source>
        <translation>
無法抽選：%1</translation>
    </message>
    <message>
        <source>
This was chosen</source>
        <translation>
已選用此項</translation>
    </message>
    <message>
        <source>
A click takes it instead</source>
        <translation>
按一下改用此項</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ClusterMap</name>
    <message>
        <source>Map of poses</source>
        <translation>姿勢地圖</translation>
    </message>
    <message>
        <source>A map of the poses appears here: like ones near each other, and the way that a transition takes.</source>
        <translation>這裡會出現姿勢地圖：相似的姿勢彼此靠近，並顯示轉換所走的路徑。</translation>
    </message>
    <message>
        <source>%1 kinds of poses, like ones near each other · line: what leads where</source>
        <translation>%1 種姿勢，相似者彼此靠近 · 線：可通往何處</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CommandPalette</name>
    <message>
        <source> · on</source>
        <translation> · 開啟</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>輸入想做的事</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>A name, a menu or a word for it: ↑ ↓ choose, Return runs, Esc leaves</source>
        <translation>名稱、選單或相關字詞：↑ ↓ 選擇，Return 執行，Esc 離開</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>%1 · “%2”</source>
        <translation>%1 · 「%2」</translation>
    </message>
    <message>
        <source>No command that can be run now is called “%1”.</source>
        <translation>目前可執行的命令中，沒有叫「%1」的。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CompareBox</name>
    <message>
        <source>Compare with settings B</source>
        <translation>與設定 B 比較</translation>
    </message>
    <message>
        <source> B</source>
        <translation> B</translation>
    </message>
    <message>
        <source>Use B</source>
        <translation>使用 B</translation>
    </message>
    <message>
        <source>Draw beside the project&apos;s boundaries (A) those that other settings give</source>
        <translation>在專案的邊界 (A) 旁畫出其他設定得到的邊界</translation>
    </message>
    <message>
        <source>Boundaries that differ</source>
        <translation>有差異的邊界</translation>
    </message>
    <message>
        <source>On the timeline: ○ only in A, dotted lines only in B</source>
        <translation>時間軸上：○ 僅 A 有，虛線僅 B 有</translation>
    </message>
    <message>
        <source>Cut the project by settings B</source>
        <translation>以設定 B 切割專案</translation>
    </message>
    <message>
        <source>Comparing settings</source>
        <translation>正在比較設定</translation>
    </message>
    <message>
        <source>%1: %2 in both, %3 only A, %4 only B</source>
        <translation>%1：兩者皆有 %2，僅 A %3，僅 B %4</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CompareLabelsBox</name>
    <message>
        <source>Take theirs</source>
        <translation>採用對方</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>保留我的</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>關閉</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>面向</translation>
    </message>
    <message>
        <source>both</source>
        <translation>兩者</translation>
    </message>
    <message>
        <source>same</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>κ</source>
        <translation>κ</translation>
    </message>
    <message>
        <source>Agreement per aspect</source>
        <translation>各面向的一致性</translation>
    </message>
    <message>
        <source>Both: actions of which both people said something. κ (Cohen): how much more often they say the same than by chance; 1 always, 0 as often as by chance.</source>
        <translation>兩者：兩人都有標記的動作。κ (Cohen)：兩人說法相同的程度比碰巧高多少；1 表示總是相同，0 表示與碰巧一樣。</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>差異</translation>
    </message>
    <message>
        <source>Their value, as said by a hand; goes on to the next (Enter)</source>
        <translation>採用對方的值，視為手動標記；接著到下一個 (Enter)</translation>
    </message>
    <message>
        <source>What the project says stays; goes on to the next (Backspace)</source>
        <translation>保留專案的標記；接著到下一個 (Backspace)</translation>
    </message>
    <message>
        <source>Theirs for all that are not decided, as one step of the history</source>
        <translation>所有未決定的都採用對方，在歷程中記為一步</translation>
    </message>
    <message>
        <source>Their labels where you have none, as said by a hand, in one step</source>
        <translation>你沒有標籤之處採用對方的標籤，視為手動標記，記為一步</translation>
    </message>
    <message>
        <source>The boundaries have changed. Open %1 once more to compare.</source>
        <translation>邊界已變更。請再次開啟 %1 以進行比較。</translation>
    </message>
    <message>
        <source>Another person&apos;s labels are compared here with those of the project: Label &gt; Compare with labels of… opens their file.</source>
        <translation>這裡將他人的標籤與專案的標籤比較：用「標記 &gt; 與他人的標籤比較…」開啟對方的檔案。</translation>
    </message>
    <message>
        <source>%1: 1 action labelled by both, %2 alike</source>
        <translation>%1：1 個動作雙方皆有標記，%2 個相同</translation>
    </message>
    <message>
        <source>%1: %3 actions labelled by both, %2 alike</source>
        <translation>%1：%3 個動作雙方皆有標記，%2 個相同</translation>
    </message>
    <message>
        <source>, κ %1</source>
        <translation>，κ %1</translation>
    </message>
    <message>
        <source>. No difference to decide.</source>
        <translation>。沒有待決定的差異。</translation>
    </message>
    <message>
        <source>. 1 difference to decide.</source>
        <translation>。1 處差異待決定。</translation>
    </message>
    <message>
        <source>. %1 differences to decide.</source>
        <translation>。%1 處差異待決定。</translation>
    </message>
    <message>
        <source> Only you labelled %1 more.</source>
        <translation> 只有你另外標記了 %1 個。</translation>
    </message>
    <message>
        <source>Theirs for all %1</source>
        <translation>%1 處全採用對方</translation>
    </message>
    <message>
        <source>Add the 1 that only they labelled</source>
        <translation>加入僅對方標記的 1 個</translation>
    </message>
    <message>
        <source>Add the %1 that only they labelled</source>
        <translation>加入僅對方標記的 %1 個</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ConfusionMatrix</name>
    <message>
        <source>no answer</source>
        <translation>沒有答案</translation>
    </message>
    <message>
        <source>Confusion matrix</source>
        <translation>混淆矩陣</translation>
    </message>
    <message>
        <source>by rule</source>
        <translation>依規則</translation>
    </message>
    <message>
        <source>by machine</source>
        <translation>依機器</translation>
    </message>
    <message>
        <source>%1 by hand and %2: </source>
        <translation>手動與%2皆為 %1： </translation>
    </message>
    <message>
        <source>%1 by hand, %2 %3: </source>
        <translation>手動 %1，%2 %3： </translation>
    </message>
    <message>
        <source>1 action</source>
        <translation>1 個動作</translation>
    </message>
    <message>
        <source>%1 actions</source>
        <translation>%1 個動作</translation>
    </message>
    <message>
        <source>, %1 of %2</source>
        <translation>，%1 / %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DetectionBox</name>
    <message>
        <source>Warning about the cutoff</source>
        <translation>關於截止頻率的警告</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DifferencesModel</name>
    <message>
        <source>%1, %2, %3: mine %4, theirs %5</source>
        <translation>%1，%2，%3：我的 %4，對方 %5</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>面向</translation>
    </message>
    <message>
        <source>mine</source>
        <translation>我的</translation>
    </message>
    <message>
        <source>theirs</source>
        <translation>對方</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DistanceGridView</name>
    <message>
        <source>Distances of poses where motions are joined</source>
        <translation>動態接合處的姿勢距離</translation>
    </message>
    <message>
        <source>How far the poses are from each other: the last frames of what was there down, the first frames of what comes in to the right. The stronger the colour, the nearer they are; the ring is where both were joined.</source>
        <translation>姿勢彼此的差距：直向為原有動態的最後幾影格，橫向為接入動態的最初幾影格。顏色越深越接近；圓圈是兩者接合之處。</translation>
    </message>
    <message>
        <source>frames that come in →</source>
        <translation>接入的影格 →</translation>
    </message>
    <message>
        <source>← frames there</source>
        <translation>← 原有的影格</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Document</name>
    <message>
        <source>The force curves are still being computed; try again in a moment.</source>
        <translation>力曲線仍在計算中；請稍後再試。</translation>
    </message>
    <message>
        <source>Computing force curves</source>
        <translation>正在計算力曲線</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DocumentPanel</name>
    <message>
        <source>Add recordings to begin a take.</source>
        <translation>加入錄製檔以建立鏡次。</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>鏡次</translation>
    </message>
    <message>
        <source>Fighters</source>
        <translation>選手</translation>
    </message>
    <message>
        <source>History</source>
        <translation>歷程</translation>
    </message>
    <message>
        <source> (missing)</source>
        <translation> （遺失）</translation>
    </message>
    <message>
        <source>%1: %2
%3 Hz, %4 frames
Double-click: start, place, floor, joints</source>
        <translation>%1：%2
%3 Hz，%4 影格
按兩下：起點、位置、地板、關節</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FighterProperties</name>
    <message>
        <source>Fighter properties</source>
        <translation>選手屬性</translation>
    </message>
    <message>
        <source>Fighter</source>
        <translation>選手</translation>
    </message>
    <message>
        <source>Whose properties are shown: the active fighter&apos;s (Tab)</source>
        <translation>顯示哪位選手的屬性：目前選手 (Tab)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Start in seconds</source>
        <translation>起點（秒）</translation>
    </message>
    <message>
        <source>When its first frame stands on the clock of the take; puts the fighters in step.</source>
        <translation>第一影格在鏡次時間上的位置；用來讓兩名選手同步。</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Starts at</source>
        <translation>起始於</translation>
    </message>
    <message>
        <source>Place in the bout</source>
        <translation>對打中的位置</translation>
    </message>
    <message>
        <source>x in metres</source>
        <translation>x（公尺）</translation>
    </message>
    <message>
        <source>Shifts the fighter to the side.</source>
        <translation>將選手向側面移動。</translation>
    </message>
    <message>
        <source>z in metres</source>
        <translation>z（公尺）</translation>
    </message>
    <message>
        <source>Shifts the fighter forward or back.</source>
        <translation>將選手向前或向後移動。</translation>
    </message>
    <message>
        <source>Turn in degrees</source>
        <translation>旋轉（度）</translation>
    </message>
    <message>
        <source>Turns the fighter about the origin of its recording, before it is shifted.</source>
        <translation>在移動之前，繞錄製的原點旋轉選手。</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>旋轉角度</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>地板</translation>
    </message>
    <message>
        <source>found from the feet</source>
        <translation>由腳部求得</translation>
    </message>
    <message>
        <source>The height at which the feet rest; switch it off to set the floor by hand.</source>
        <translation>腳站定時的高度；關閉後可手動設定地板。</translation>
    </message>
    <message>
        <source>Height of the floor in metres</source>
        <translation>地板高度（公尺）</translation>
    </message>
    <message>
        <source>Where the floor is in the space of the recording.</source>
        <translation>地板在錄製空間中的位置。</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Body model of the project</source>
        <translation>專案的身體模型</translation>
    </message>
    <message>
        <source>Body model</source>
        <translation>身體模型</translation>
    </message>
    <message>
        <source>How the mass is spread over the body: what the centre of mass and with it the contact force are made of.</source>
        <translation>質量在身體上的分布：質心及由此得出的接觸力都以此計算。</translation>
    </message>
    <message>
        <source>Which joint is what</source>
        <translation>關節對應</translation>
    </message>
    <message>
        <source>Joint of the role %1</source>
        <translation>角色%1的關節</translation>
    </message>
    <message>
        <source>The joint of the recording that is the %1 of the body.</source>
        <translation>錄製中作為身體%1的關節。</translation>
    </message>
    <message>
        <source>Start, place, floor and joints of a fighter appear here as soon as there is a take.</source>
        <translation>一有鏡次，選手的起點、位置、地板與關節就會出現在這裡。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 Hz, frames %2 to %3 of %4, %5 joints</source>
        <translation>%1 Hz，影格 %2 至 %3，共 %4，%5 個關節</translation>
    </message>
    <message>
        <source>one unit is %1 m, %2 is up</source>
        <translation>一單位為 %1 m，%2 朝上</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>The recording is missing: File, Find recording.</source>
        <translation>錄製檔遺失：檔案 &gt; 尋找錄製檔。</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>從檔案…</translation>
    </message>
    <message>
        <source>none</source>
        <translation>無</translation>
    </message>
    <message>
        <source>1 role has no joint.</source>
        <translation>1 個角色沒有關節。</translation>
    </message>
    <message>
        <source>%1 roles have no joint.</source>
        <translation>%1 個角色沒有關節。</translation>
    </message>
    <message>
        <source>Open a body model</source>
        <translation>開啟身體模型</translation>
    </message>
    <message>
        <source>Body models (*.json)</source>
        <translation>身體模型 (*.json)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FileActions</name>
    <message>
        <source>A project opens alone: choose one .kumite file, or one or two recordings.</source>
        <translation>專案須單獨開啟：請選一個 .kumite 檔案，或一到兩個錄製檔。</translation>
    </message>
    <message>
        <source>A take has one or two fighters: choose one or two recordings, not %1.</source>
        <translation>一個鏡次有一或兩名選手：請選一到兩個錄製檔，而不是 %1 個。</translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation>已在別處開啟</translation>
    </message>
    <message>
        <source>%1 is open in another studio.</source>
        <translation>%1 已在另一個視窗中開啟。</translation>
    </message>
    <message>
        <source>A copy can be changed and saved under another name. Taking over, you save into this file, and so may the other.</source>
        <translation>副本可以修改並以其他名稱儲存。若接管，你會存入這個檔案，而對方也可能會。</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>開啟副本</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>接管</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>正在開啟 %1</translation>
    </message>
    <message>
        <source>Found in %1</source>
        <translation>%1 中的發現事項</translation>
    </message>
    <message>
        <source>Making the demo bout</source>
        <translation>正在製作示範對打</translation>
    </message>
    <message>
        <source>The demo bout: two made fighters. Save it to keep what you change.</source>
        <translation>示範對打：兩名虛構的選手。儲存後才會保留變更。</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>正在救回 %1</translation>
    </message>
    <message>
        <source>Found while recovering</source>
        <translation>救回時的發現事項</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在讀取 %1</translation>
    </message>
    <message>
        <source>Found in the recordings</source>
        <translation>錄製檔中的發現事項</translation>
    </message>
    <message>
        <source>Open one or two recordings</source>
        <translation>開啟一到兩個錄製檔</translation>
    </message>
    <message>
        <source>Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)</source>
        <translation>錄製檔 (*.bvh *.BVH *.amc *.AMC);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>開啟專案</translation>
    </message>
    <message>
        <source>Kumite projects (*.kumite)</source>
        <translation>Kumite 專案 (*.kumite)</translation>
    </message>
    <message>
        <source>Where is %1 of %2?</source>
        <translation>%2 的 %1 在哪裡？</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>儲存專案</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>正在儲存 %1</translation>
    </message>
    <message>
        <source>Found while saving</source>
        <translation>儲存時的發現事項</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已儲存 %1。</translation>
    </message>
    <message>
        <source>Save all the same</source>
        <translation>仍要儲存</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存新檔…</translation>
    </message>
    <message>
        <source>Changed on the disk</source>
        <translation>磁碟上已變更</translation>
    </message>
    <message>
        <source>%1 was changed outside this window since you opened it.</source>
        <translation>你開啟 %1 之後，它在此視窗之外被變更過。</translation>
    </message>
    <message>
        <source>It was written %1. If you save over it, what it holds now is kept as a version.</source>
        <translation>寫入時間：%1。若覆寫儲存，目前的內容會保留為一個版本。</translation>
    </message>
    <message>
        <source>Save over it</source>
        <translation>覆寫儲存</translation>
    </message>
    <message>
        <source>Export the actions of this take</source>
        <translation>匯出此鏡次的動作</translation>
    </message>
    <message>
        <source>Table of actions (*.csv);;Segmentation (*.json)</source>
        <translation>動作表格 (*.csv);;分段 (*.json)</translation>
    </message>
    <message>
        <source>Export the motion of this take</source>
        <translation>匯出此鏡次的動態</translation>
    </message>
    <message>
        <source>Motion, one file per fighter (*.bvh)</source>
        <translation>動態，每位選手一個檔案 (*.bvh)</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>正在匯出 %1</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>已匯出 %1。</translation>
    </message>
    <message>
        <source> and </source>
        <translation> 和 </translation>
    </message>
    <message>
        <source>Reading the version of %1</source>
        <translation>正在讀取 %1 的版本</translation>
    </message>
    <message>
        <source>Found in the version</source>
        <translation>版本中的發現事項</translation>
    </message>
    <message>
        <source>Restored the version of %1; Ctrl+Z takes it back.</source>
        <translation>已還原 %1 的版本；Ctrl+Z 可復原。</translation>
    </message>
    <message>
        <source>That version is what is open.</source>
        <translation>目前開啟的就是該版本。</translation>
    </message>
    <message>
        <source>The version of %1 is open as a copy.</source>
        <translation>%1 的版本已開啟為副本。</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未儲存的變更</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>要將變更儲存到 %1 嗎？</translation>
    </message>
    <message>
        <source>What is not saved is lost.</source>
        <translation>未儲存的內容將會遺失。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FindBox</name>
    <message>
        <source>Actions found</source>
        <translation>找到的動作</translation>
    </message>
    <message>
        <source>right kick up, machine, below 0.6</source>
        <translation>例：right kick up, machine, below 0.6</translation>
    </message>
    <message>
        <source>Find actions</source>
        <translation>尋找動作</translation>
    </message>
    <message>
        <source>Aspects and qualifiers (kick, right punch fwd, jump none), who said it (by hand, machine, rule), how surely (uncertain, below 0.6), which fighter or take, when (after 1:20, longer than 1 s), unlabelled. All must hold; &quot;or&quot; joins two, &quot;not&quot; turns one round. Source and confidence are those of the aspects that are named.</source>
        <translation>面向與修飾詞（kick、right punch fwd、jump none）、由誰標記（by hand、machine、rule）、把握程度（uncertain、below 0.6）、哪位選手或鏡次、何時（after 1:20、longer than 1 s）、未標記 (unlabelled)。須全部符合；「or」連接兩者，「not」表示相反。來源與信心以所提到的面向為準。</translation>
    </message>
    <message>
        <source>What was understood</source>
        <translation>理解的內容</translation>
    </message>
    <message>
        <source>Choose all that were found in this take: the next label goes to all of them, as one step</source>
        <translation>選取此鏡次中找到的全部動作：下一個標籤會一步套用到全部</translation>
    </message>
    <message>
        <source>1 action</source>
        <translation>1 個動作</translation>
    </message>
    <message>
        <source>%1 actions</source>
        <translation>%1 個動作</translation>
    </message>
    <message>
        <source>Choose all %1</source>
        <translation>全選 %1 個</translation>
    </message>
    <message>
        <source>The actions of the bout appear here once a recording is cut.</source>
        <translation>錄製切割之後，對打的動作會出現在這裡。</translation>
    </message>
    <message>
        <source>No action is like that.</source>
        <translation>沒有這樣的動作。</translation>
    </message>
    <message>
        <source>Choose all</source>
        <translation>全選</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FindingsPage</name>
    <message>
        <source>Findings in the recordings</source>
        <translation>錄製檔中的發現事項</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>關閉此頁 (Esc)</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>備註</translation>
    </message>
    <message>
        <source>What is odd or worth knowing about the recordings of a project is listed here. There is nothing.</source>
        <translation>專案錄製檔中異常或值得知道之處會列在這裡。目前沒有。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FoundModel</name>
    <message>
        <source>%1, %2: %3, %4</source>
        <translation>%1，%2：%3，%4</translation>
    </message>
    <message>
        <source>, p %1</source>
        <translation>，p %1</translation>
    </message>
    <message>
        <source>Who says it; of several aspects the least sure</source>
        <translation>由誰標記；多個面向時取最不確定者</translation>
    </message>
    <message>
        <source>Confidence; of several aspects the least</source>
        <translation>信心；多個面向時取最低者</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>label</source>
        <translation>標籤</translation>
    </message>
    <message>
        <source>by</source>
        <translation>來源</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphCentre</name>
    <message>
        <source>Matrix</source>
        <translation>矩陣</translation>
    </message>
    <message>
        <source>Transitions as a matrix (V)</source>
        <translation>以矩陣顯示轉換 (V)</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>轉換圖</translation>
    </message>
    <message>
        <source>Transitions as circles and edges (V)</source>
        <translation>以圓圈與邊顯示轉換 (V)</translation>
    </message>
    <message>
        <source>What %1 does next (Tab)</source>
        <translation>%1 接下來做什麼 (Tab)</translation>
    </message>
    <message>
        <source>compared with nothing</source>
        <translation>不比較</translation>
    </message>
    <message>
        <source>with the other fighter</source>
        <translation>與另一位選手比較</translation>
    </message>
    <message>
        <source>with labels by hand alone</source>
        <translation>與僅手動標籤比較</translation>
    </message>
    <message>
        <source>with EQU7</source>
        <translation>與 EQU7 比較</translation>
    </message>
    <message>
        <source>with EQU6</source>
        <translation>與 EQU6 比較</translation>
    </message>
    <message>
        <source>with EQU5</source>
        <translation>與 EQU5 比較</translation>
    </message>
    <message>
        <source>What it is compared with</source>
        <translation>比較對象</translation>
    </message>
    <message>
        <source>Compares with another, side by side or as a difference</source>
        <translation>與另一個比較，並列或以差異顯示</translation>
    </message>
    <message>
        <source>What each fighter tends to do next</source>
        <translation>每位選手接下來傾向做什麼</translation>
    </message>
    <message>
        <source>Why nothing is shown</source>
        <translation>沒有顯示內容的原因</translation>
    </message>
    <message>
        <source>Transitions are being learnt from the labels.</source>
        <translation>正在從標籤學習轉換。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphCommands</name>
    <message>
        <source>Export transitions</source>
        <translation>匯出轉換</translation>
    </message>
    <message>
        <source>Edges as a table (*.csv);;Graph and model (*.json);;Graph (*.graphml);;Picture (*.png);;Picture of lines (*.svg)</source>
        <translation>邊的表格 (*.csv);;圖與模型 (*.json);;圖 (*.graphml);;圖片 (*.png);;向量圖 (*.svg)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已寫入：%1</translation>
    </message>
    <message>
        <source>&amp;Graph</source>
        <translation>轉換圖(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Matrix or graph</source>
        <translation>矩陣或圖(&amp;M)</translation>
    </message>
    <message>
        <source>Graph in &amp;space</source>
        <translation>立體的圖(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Play what is behind it, the next each time</source>
        <translation>播放背後的片刻，每次換下一個(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next surprise</source>
        <translation>下一個意外(&amp;N)</translation>
    </message>
    <message>
        <source>Pre&amp;vious surprise</source>
        <translation>上一個意外(&amp;V)</translation>
    </message>
    <message>
        <source>Surprise of bo&amp;th terms</source>
        <translation>兩項的意外度(&amp;T)</translation>
    </message>
    <message>
        <source>S&amp;urprise of the label term</source>
        <translation>標籤項的意外度(&amp;D)</translation>
    </message>
    <message>
        <source>Su&amp;rprise of the geometry term</source>
        <translation>幾何項的意外度(&amp;F)</translation>
    </message>
    <message>
        <source>Rows by &amp;own label</source>
        <translation>列依自己的標籤(&amp;O)</translation>
    </message>
    <message>
        <source>Ro&amp;ws by opponent&apos;s label</source>
        <translation>列依對手的標籤(&amp;H)</translation>
    </message>
    <message>
        <source>Rows by &amp;both labels</source>
        <translation>列依雙方標籤(&amp;B)</translation>
    </message>
    <message>
        <source>Sort by &amp;count</source>
        <translation>依次數排序(&amp;C)</translation>
    </message>
    <message>
        <source>Sort by n&amp;ame</source>
        <translation>依名稱排序(&amp;A)</translation>
    </message>
    <message>
        <source>Sort by &amp;likeness</source>
        <translation>依相似度排序(&amp;L)</translation>
    </message>
    <message>
        <source>Lar&amp;ger cells</source>
        <translation>放大格子(&amp;G)</translation>
    </message>
    <message>
        <source>Smaller cells</source>
        <translation>縮小格子</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>顯示全部(&amp;E)</translation>
    </message>
    <message>
        <source>E&amp;xport transitions…</source>
        <translation>匯出轉換(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphExport</name>
    <message>
        <source>Transitions</source>
        <translation>轉換</translation>
    </message>
    <message>
        <source>%1: the name must end in .csv, .json, .graphml, .png or .svg.</source>
        <translation>%1：名稱必須以 .csv、.json、.graphml、.png 或 .svg 結尾。</translation>
    </message>
    <message>
        <source>%1: it cannot be written there.</source>
        <translation>%1：無法寫入該處。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphPanel</name>
    <message>
        <source>What a fighter does next, given what both are doing, and the moments of the recording behind each probability appear here.</source>
        <translation>這裡會出現選手在雙方各做某事時接下來的動作，以及每個機率背後的錄製片刻。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphSession</name>
    <message>
        <source>%1: more often</source>
        <translation>%1：較常</translation>
    </message>
    <message>
        <source>others</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>label</source>
        <translation>標籤</translation>
    </message>
    <message>
        <source>geometry</source>
        <translation>幾何</translation>
    </message>
    <message>
        <source>both</source>
        <translation>兩者</translation>
    </message>
    <message>
        <source>P &lt;0.001</source>
        <translation>P &lt;0.001</translation>
    </message>
    <message>
        <source>P %1</source>
        <translation>P %1</translation>
    </message>
    <message>
        <source>surprise %1 (%2 seen the motion): label %3 (%4), geometry %5</source>
        <translation>意外度 %1（看過動態後 %2）：標籤 %3 (%4)，幾何 %5</translation>
    </message>
    <message>
        <source>Learning transitions</source>
        <translation>正在學習轉換</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>all labels</source>
        <translation>所有標籤</translation>
    </message>
    <message>
        <source>labels by hand</source>
        <translation>手動標籤</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphView</name>
    <message>
        <source>Graph of transitions</source>
        <translation>轉換的圖</translation>
    </message>
    <message>
        <source>A node is a label, an edge leads to what follows. A click shows the moments behind it.</source>
        <translation>節點是標籤，邊通往接下來的標籤。按一下可顯示背後的片刻。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Help</name>
    <message>
        <source>&amp;Help on this workspace</source>
        <translation>此工作區的說明(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>入門(&amp;F)</translation>
    </message>
    <message>
        <source>What the &amp;numbers mean</source>
        <translation>數字的意義(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;What is this? Click on it</source>
        <translation>這是什麼？請點選(&amp;W)</translation>
    </message>
    <message>
        <source>What has the f&amp;ocus?</source>
        <translation>焦點在哪裡？(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>按鍵與滑鼠(&amp;K)</translation>
    </message>
    <message>
        <source>What is n&amp;ew</source>
        <translation>新功能(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;About Kumite</source>
        <translation>關於 Kumite(&amp;A)</translation>
    </message>
    <message>
        <source>About Kumite</source>
        <translation>關於 Kumite</translation>
    </message>
    <message>
        <source>Kumite %1

A studio for annotating two-player martial-arts motion capture.</source>
        <translation>Kumite %1

為雙人武術動作捕捉加註的工作室。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HelpWindow</name>
    <message>
        <source>The page before</source>
        <translation>上一頁</translation>
    </message>
    <message>
        <source>On again</source>
        <translation>再往前</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>說明</translation>
    </message>
    <message>
        <source>Close the help (Esc)</source>
        <translation>關閉說明 (Esc)</translation>
    </message>
    <message>
        <source>Search all pages</source>
        <translation>搜尋所有頁面</translation>
    </message>
    <message>
        <source>Shows the pages that hold all of these words. Return: the next place; Shift+Return: the one before. (Ctrl+F)</source>
        <translation>顯示含有所有這些字詞的頁面。Return：下一處；Shift+Return：上一處。(Ctrl+F)</translation>
    </message>
    <message>
        <source>How often the words were found</source>
        <translation>找到字詞的次數</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目錄</translation>
    </message>
    <message>
        <source>The pages of the help</source>
        <translation>說明的頁面</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>此頁</translation>
    </message>
    <message>
        <source>Tab leads from link to link, Return follows one.</source>
        <translation>Tab 在連結間移動，Return 開啟連結。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Found %1 times on this page</source>
        <translation>此頁找到 %1 次</translation>
    </message>
    <message>
        <source>Show this page</source>
        <translation>顯示此頁</translation>
    </message>
    <message>
        <source>No page holds these words.</source>
        <translation>沒有頁面含有這些字詞。</translation>
    </message>
    <message>
        <source>%1 of %2 on this page</source>
        <translation>此頁第 %1 / %2 處</translation>
    </message>
    <message>
        <source>%1 — Help</source>
        <translation>%1 — 說明</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HistoryModel</name>
    <message>
        <source>%1
The project as it is now.</source>
        <translation>%1
專案目前的狀態。</translation>
    </message>
    <message>
        <source>%1
Click to go back to this state.</source>
        <translation>%1
按一下回到這個狀態。</translation>
    </message>
    <message>
        <source>%1
Undone. Click to redo up to here.</source>
        <translation>%1
已復原。按一下重做到這裡。</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1，已復原</translation>
    </message>
    <message>
        <source>%1, now</source>
        <translation>%1，目前</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HitBox</name>
    <message>
        <source>Hit a target</source>
        <translation>擊中目標</translation>
    </message>
    <message>
        <source>Drag the target in the 3D view: the strike follows it. Dots: where whole examples hit; the box: what is reached.</source>
        <translation>在 3D 檢視中拖曳目標，招式會跟隨。點：整段範例擊中之處；方框：可及範圍。</translation>
    </message>
    <message>
        <source>Strike</source>
        <translation>打擊</translation>
    </message>
    <message>
        <source>Which strike; its examples are the actions with that label</source>
        <translation>選哪種打擊；其範例是帶有該標籤的動作</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>一個位置</translation>
    </message>
    <message>
        <source>Aim at</source>
        <translation>瞄準</translation>
    </message>
    <message>
        <source>A place in space, or the opponent as the recording&apos;s playhead shows it; a click on its marks in the 3D view aims there</source>
        <translation>空間中的位置，或播放位置所示的對手；在 3D 檢視中點按其標記即瞄準該處</translation>
    </message>
    <message>
        <source>Distance of the opponent, metres</source>
        <translation>對手的距離，公尺</translation>
    </message>
    <message>
        <source>How far ahead the opponent stands, from pelvis to pelvis</source>
        <translation>對手站在前方多遠，由骨盆到骨盆</translation>
    </message>
    <message>
        <source>Away, m</source>
        <translation>距離，m</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>向左</translation>
    </message>
    <message>
        <source>up</source>
        <translation>向上</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>向前</translation>
    </message>
    <message>
        <source>Target, metres %1</source>
        <translation>目標，公尺，%1</translation>
    </message>
    <message>
        <source>Target, m</source>
        <translation>目標，m</translation>
    </message>
    <message>
        <source>How well it is hit</source>
        <translation>命中程度</translation>
    </message>
    <message>
        <source>The strikes are being aligned.</source>
        <translation>正在對齊打擊。</translation>
    </message>
    <message>
        <source>A blend of whole examples reaches it.</source>
        <translation>混合完整範例即可達到。</translation>
    </message>
    <message>
        <source>No blend of whole examples reaches it: parts of the body are blended and turned.</source>
        <translation>混合完整範例無法達到：改為混合並轉動身體各部分。</translation>
    </message>
    <message>
        <source>It is outside of the box that is reached.</source>
        <translation>位於可達範圍之外。</translation>
    </message>
    <message>
        <source>Hit, %1 cm off. %2 %3 examples.</source>
        <translation>命中，差 %1 cm。%2 %3 個範例。</translation>
    </message>
    <message>
        <source>Missed by %1 cm: the nearest that can be reached. %2 %3 examples.</source>
        <translation>差 %1 cm 未中：這是可達的最近處。%2 %3 個範例。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HitSession</name>
    <message>
        <source>Aim at the opponent</source>
        <translation>瞄準對手</translation>
    </message>
    <message>
        <source>Aim at a place</source>
        <translation>瞄準一個位置</translation>
    </message>
    <message>
        <source>Opponent %1 m away</source>
        <translation>對手距離 %1 m</translation>
    </message>
    <message>
        <source>Strike with %1</source>
        <translation>以%1打擊</translation>
    </message>
    <message>
        <source>Aligning the strikes</source>
        <translation>正在對齊打擊</translation>
    </message>
    <message>
        <source>Move the target</source>
        <translation>移動目標</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ImportDialog</name>
    <message>
        <source>Open recordings</source>
        <translation>開啟錄製檔</translation>
    </message>
    <message>
        <source>Not read. Choose the file again to read it.</source>
        <translation>未讀取。請再次選擇檔案來讀取。</translation>
    </message>
    <message>
        <source>Choose a recording</source>
        <translation>選擇錄製檔</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>正在讀取…</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>正在讀取</translation>
    </message>
    <message>
        <source>Start, place and floor of %1 must be numbers, such as 0.25.</source>
        <translation>%1 的起點、位置與地板必須是數字，例如 0.25。</translation>
    </message>
    <message>
        <source>Choose a recording for fighter 1.</source>
        <translation>請為選手 1 選擇錄製檔。</translation>
    </message>
    <message>
        <source>The rate must be a positive number of frames per second, such as 60.</source>
        <translation>速率必須是正的每秒影格數，例如 60。</translation>
    </message>
    <message>
        <source>Frames read begin:end, such as 120:900; either may be left out.</source>
        <translation>影格寫成 起:迄，例如 120:900；兩者皆可省略。</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>正在檢視</translation>
    </message>
    <message>
        <source>Roles, %1 missing</source>
        <translation>角色，缺 %1 個</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>&lt;b&gt;Check:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;請檢查：&lt;/b&gt;%1</translation>
    </message>
    <message>
        <source>%1 (found)</source>
        <translation>%1（求得）</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>依求得</translation>
    </message>
    <message>
        <source>%1:%2 of %3</source>
        <translation>%1:%2，共 %3</translation>
    </message>
    <message>
        <source>Hz; header: %1</source>
        <translation>Hz；檔頭：%1</translation>
    </message>
    <message>
        <source> and </source>
        <translation> 和 </translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>begin:end</source>
        <translation>起:迄</translation>
    </message>
    <message>
        <source>Fighter %1</source>
        <translation>選手 %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>錄製檔</translation>
    </message>
    <message>
        <source>Path of the recording; the button beside it, or a drop, chooses one</source>
        <translation>錄製檔的路徑；用旁邊的按鈕或拖放來選擇</translation>
    </message>
    <message>
        <source>a .bvh or .amc file</source>
        <translation>.bvh 或 .amc 檔案</translation>
    </message>
    <message>
        <source>none: a single fighter</source>
        <translation>無：單一選手</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>骨架</translation>
    </message>
    <message>
        <source>Which skeleton of a file that holds several</source>
        <translation>檔案含多個骨架時用哪一個</translation>
    </message>
    <message>
        <source>ASF skeleton</source>
        <translation>ASF 骨架</translation>
    </message>
    <message>
        <source>the one beside it</source>
        <translation>旁邊的那個</translation>
    </message>
    <message>
        <source>The .asf file that belongs to the .amc</source>
        <translation>屬於該 .amc 的 .asf 檔案</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>長度單位</translation>
    </message>
    <message>
        <source>What one unit of the file is</source>
        <translation>檔案中一單位的意義</translation>
    </message>
    <message>
        <source>found</source>
        <translation>求得</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>朝上的軸</translation>
    </message>
    <message>
        <source>The file&apos;s axis that points up</source>
        <translation>檔案中指向上方的軸</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起點</translation>
    </message>
    <message>
        <source>Seconds on the take&apos;s clock at which its first frame stands</source>
        <translation>第一影格在鏡次時間上的秒數</translation>
    </message>
    <message>
        <source>Place x</source>
        <translation>位置 x</translation>
    </message>
    <message>
        <source>Metres along x from where the file stands</source>
        <translation>從檔案原位置沿 x 的公尺數</translation>
    </message>
    <message>
        <source>Place z</source>
        <translation>位置 z</translation>
    </message>
    <message>
        <source>Metres along z from where the file stands</source>
        <translation>從檔案原位置沿 z 的公尺數</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋轉</translation>
    </message>
    <message>
        <source>Degrees about the vertical, about the file&apos;s origin</source>
        <translation>繞垂直軸、以檔案原點為中心的度數</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>地板</translation>
    </message>
    <message>
        <source>Height of the floor in the file, metres</source>
        <translation>檔案中地板的高度，公尺</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選擇…</translation>
    </message>
    <message>
        <source>Choose the recording of %1</source>
        <translation>選擇 %1 的錄製檔</translation>
    </message>
    <message>
        <source>BVH, or AMC with its ASF; others go through Blender</source>
        <translation>BVH，或 AMC 搭配其 ASF；其他格式透過 Blender 轉換</translation>
    </message>
    <message>
        <source>Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)</source>
        <translation>錄製檔 (*.bvh *.BVH *.amc *.AMC);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>S&amp;wap</source>
        <translation>對調(&amp;W)</translation>
    </message>
    <message>
        <source>Swap fighters</source>
        <translation>對調選手</translation>
    </message>
    <message>
        <source>Fighter 1 becomes fighter 2, with all that is said of them (Alt+W)</source>
        <translation>選手 1 變成選手 2，連同所有設定 (Alt+W)</translation>
    </message>
    <message>
        <source>Take name</source>
        <translation>鏡次名稱</translation>
    </message>
    <message>
        <source>How the take is called in the project</source>
        <translation>鏡次在專案中的名稱</translation>
    </message>
    <message>
        <source>Rate in Hz</source>
        <translation>速率（Hz）</translation>
    </message>
    <message>
        <source>as the header</source>
        <translation>依檔頭</translation>
    </message>
    <message>
        <source>True frame rate, where the header is wrong: the preview shows it</source>
        <translation>檔頭有誤時的真正影格率：預覽會顯示</translation>
    </message>
    <message>
        <source>Frames, begin:end</source>
        <translation>影格，起:迄</translation>
    </message>
    <message>
        <source>Frames of the files; the end is the first frame left out. Empty: all, without a leading T-pose.</source>
        <translation>檔案的影格；迄為第一個不含的影格。空白：全部，但不含開頭的 T 字姿勢。</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>鏡次</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>影格</translation>
    </message>
    <message>
        <source>ASF file</source>
        <translation>ASF 檔案</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>單位</translation>
    </message>
    <message>
        <source>Starts at, s</source>
        <translation>起始於，s</translation>
    </message>
    <message>
        <source>Place x, m</source>
        <translation>位置 x，m</translation>
    </message>
    <message>
        <source>Place z, m</source>
        <translation>位置 z，m</translation>
    </message>
    <message>
        <source>Turned, °</source>
        <translation>旋轉，°</translation>
    </message>
    <message>
        <source>Floor, m</source>
        <translation>地板，m</translation>
    </message>
    <message>
        <source>Add as a take to %1</source>
        <translation>加入 %1 作為鏡次</translation>
    </message>
    <message>
        <source>Otherwise it becomes a project of its own</source>
        <translation>否則會成為獨立的專案</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>Play or pause (Space in the preview, Alt+P)</source>
        <translation>播放或暫停（預覽中按空白鍵，Alt+P）</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暫停(&amp;P)</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>預覽</translation>
    </message>
    <message>
        <source>What was found in the recordings</source>
        <translation>錄製檔中的發現事項</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Open nothing (Esc)</source>
        <translation>什麼都不開啟 (Esc)</translation>
    </message>
    <message>
        <source>Open bout</source>
        <translation>開啟對打</translation>
    </message>
    <message>
        <source>Make a take of these recordings (Enter)</source>
        <translation>以這些錄製檔建立鏡次 (Enter)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ImportPreview</name>
    <message>
        <source>Preview of both fighters</source>
        <translation>雙方選手的預覽</translation>
    </message>
    <message>
        <source>From above, from the side, and their distance over time</source>
        <translation>俯視、側視，以及兩人距離隨時間的變化</translation>
    </message>
    <message>
        <source>Space plays, ← → steps, a drag on the distance scrubs</source>
        <translation>空白鍵播放，← → 逐格，在距離圖上拖曳可快速瀏覽</translation>
    </message>
    <message>
        <source>from above, grid %1 m</source>
        <translation>俯視，格線 %1 m</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>側視</translation>
    </message>
    <message>
        <source>%1   distance %2 m</source>
        <translation>%1   距離 %2 m</translation>
    </message>
    <message>
        <source>distance of the pelvises, m</source>
        <translation>骨盆間距離，m</translation>
    </message>
    <message>
        <source>Both fighters move here once their recordings are read. Choose them above, or drop them here.</source>
        <translation>錄製檔讀取後，雙方選手會在這裡活動。請在上方選擇，或拖放到這裡。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JobBar</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進度</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JobRunner</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>記憶體不足，無法執行。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JointBox</name>
    <message>
        <source>Joint</source>
        <translation>關節</translation>
    </message>
    <message>
        <source>Joint to turn</source>
        <translation>要轉動的關節</translation>
    </message>
    <message>
        <source>Which joint has rings in the 3D view; J chooses the next one</source>
        <translation>3D 檢視中哪個關節有環；J 選擇下一個</translation>
    </message>
    <message>
        <source>Turn about %1, degrees</source>
        <translation>繞 %1 轉動，度</translation>
    </message>
    <message>
        <source>About the parent&apos;s %1, degrees; turned about y first, then x, then z</source>
        <translation>繞上層關節的 %1，度；先繞 y，再 x，再 z</translation>
    </message>
    <message>
        <source>x y z, °</source>
        <translation>x y z，°</translation>
    </message>
    <message>
        <source>How much of the joint&apos;s limits that takes</source>
        <translation>用去關節限度的多少</translation>
    </message>
    <message>
        <source>none</source>
        <translation>無</translation>
    </message>
    <message>
        <source>Bent by %1° of %2°, twisted by %3° of %4° from rest.</source>
        <translation>彎曲 %1°（限度 %2°），扭轉 %3°（限度 %4°）。</translation>
    </message>
    <message>
        <source>This joint has no limits.</source>
        <translation>這個關節沒有限度。</translation>
    </message>
    <message>
        <source>A chosen joint has rings in the 3D view: drag one to turn it.</source>
        <translation>選定的關節在 3D 檢視中有環：拖曳即可轉動。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyBar</name>
    <message>
        <source>Time of the keys</source>
        <translation>關鍵姿勢的時間</translation>
    </message>
    <message>
        <source>the strike</source>
        <translation>打擊</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>影格 %1</translation>
    </message>
    <message>
        <source> · the motion</source>
        <translation> · 動態</translation>
    </message>
    <message>
        <source> · the keys</source>
        <translation> · 關鍵姿勢</translation>
    </message>
    <message>
        <source> · beside it without adjustment</source>
        <translation> · 旁邊是未調整的</translation>
    </message>
    <message>
        <source> · out of reach by %1 cm</source>
        <translation> · 搆不到，差 %1 cm</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyCommands</name>
    <message>
        <source>Ke&amp;yframe</source>
        <translation>關鍵影格(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>播放或暫停(&amp;P)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>後退一影格</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>前進一影格</translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation>後退十影格</translation>
    </message>
    <message>
        <source>Ten frames on</source>
        <translation>前進十影格</translation>
    </message>
    <message>
        <source>To the first key</source>
        <translation>到第一個關鍵姿勢</translation>
    </message>
    <message>
        <source>To the last key</source>
        <translation>到最後一個關鍵姿勢</translation>
    </message>
    <message>
        <source>Show the &amp;motion instead of the keys</source>
        <translation>改為顯示動態，不顯示關鍵姿勢(&amp;M)</translation>
    </message>
    <message>
        <source>Beside it the motion without a&amp;djustment</source>
        <translation>旁邊顯示未調整的動態(&amp;D)</translation>
    </message>
    <message>
        <source>Keys before and after as &amp;ghosts</source>
        <translation>前後關鍵姿勢顯示為殘影(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Hit a target</source>
        <translation>擊中目標(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Add a key here</source>
        <translation>在此加入關鍵姿勢(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove the key</source>
        <translation>移除關鍵姿勢(&amp;R)</translation>
    </message>
    <message>
        <source>Key before</source>
        <translation>上一個關鍵姿勢</translation>
    </message>
    <message>
        <source>Key after</source>
        <translation>下一個關鍵姿勢</translation>
    </message>
    <message>
        <source>Move the key earlier</source>
        <translation>關鍵姿勢提前</translation>
    </message>
    <message>
        <source>Move the key later</source>
        <translation>關鍵姿勢延後</translation>
    </message>
    <message>
        <source>Move the key and later ones earlier</source>
        <translation>此關鍵姿勢及之後的提早</translation>
    </message>
    <message>
        <source>Move the key and later ones later</source>
        <translation>此關鍵姿勢及之後的延後</translation>
    </message>
    <message>
        <source>Later keys closer together</source>
        <translation>之後的關鍵姿勢更緊密</translation>
    </message>
    <message>
        <source>Later keys farther apart</source>
        <translation>之後的關鍵姿勢更分散</translation>
    </message>
    <message>
        <source>&amp;Copy the key to the playhead, or behind the last</source>
        <translation>複製關鍵姿勢到播放頭或最後一個之後(&amp;C)</translation>
    </message>
    <message>
        <source>M&amp;irror the pose</source>
        <translation>鏡射姿勢(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Take the pose that the recording shows</source>
        <translation>取用錄製顯示的姿勢(&amp;T)</translation>
    </message>
    <message>
        <source>Copy the pose from an&amp;y take or clip…</source>
        <translation>從鏡次或片段複製姿勢(&amp;Y)…</translation>
    </message>
    <message>
        <source>The handle &amp;stays where it is, or not</source>
        <translation>控點固定在原處或放開(&amp;S)</translation>
    </message>
    <message>
        <source>Next handle</source>
        <translation>下一個控點</translation>
    </message>
    <message>
        <source>Next &amp;joint to turn</source>
        <translation>下一個要轉動的關節(&amp;J)</translation>
    </message>
    <message>
        <source>Joint before</source>
        <translation>上一個關節</translation>
    </message>
    <message>
        <source>Handle up</source>
        <translation>控點向上</translation>
    </message>
    <message>
        <source>Handle down</source>
        <translation>控點向下</translation>
    </message>
    <message>
        <source>Handle toward −x</source>
        <translation>控點朝 −x</translation>
    </message>
    <message>
        <source>Handle toward +x</source>
        <translation>控點朝 +x</translation>
    </message>
    <message>
        <source>Handle toward −z</source>
        <translation>控點朝 −z</translation>
    </message>
    <message>
        <source>Handle toward +z</source>
        <translation>控點朝 +z</translation>
    </message>
    <message>
        <source>The body from anywhere again</source>
        <translation>身體再從任意處取用</translation>
    </message>
    <message>
        <source>Take the body from anywhere</source>
        <translation>身體從任意處取用</translation>
    </message>
    <message>
        <source>Remove all keys</source>
        <translation>移除所有關鍵姿勢</translation>
    </message>
    <message>
        <source>Add clips of &amp;files…</source>
        <translation>加入檔案的片段(&amp;F)…</translation>
    </message>
    <message>
        <source>Add cl&amp;ips of a folder…</source>
        <translation>加入資料夾的片段(&amp;H)…</translation>
    </message>
    <message>
        <source>R&amp;eplace a part of a take…</source>
        <translation>取代鏡次的一部分(&amp;B)…</translation>
    </message>
    <message>
        <source>&amp;Keep as a take…</source>
        <translation>存為鏡次(&amp;K)…</translation>
    </message>
    <message>
        <source>E&amp;xport the motion…</source>
        <translation>匯出動態(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyEditor</name>
    <message>
        <source>Remove keys</source>
        <translation>移除按鍵</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重設</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>重設所有按鍵</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>搜尋命令</translation>
    </message>
    <message>
        <source>Shows the commands whose name, menu or key holds these letters.</source>
        <translation>顯示名稱、選單或按鍵含有這些字的命令。</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>命令及其按鍵</translation>
    </message>
    <message>
        <source>Choose a command, then press its key in the field below</source>
        <translation>選擇命令，再到下方欄位按下按鍵</translation>
    </message>
    <message>
        <source>command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>選單</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>按鍵</translation>
    </message>
    <message>
        <source>The chosen command gets the key in the field.</source>
        <translation>所選命令會使用欄位中的按鍵。</translation>
    </message>
    <message>
        <source>The chosen command is run from menus and the palette only.</source>
        <translation>所選命令將只能從選單與命令面板執行。</translation>
    </message>
    <message>
        <source>The chosen command gets back the keys that the studio brings.</source>
        <translation>所選命令恢復為程式預設的按鍵。</translation>
    </message>
    <message>
        <source>All commands get back the keys that the studio brings.</source>
        <translation>所有命令恢復為程式預設的按鍵。</translation>
    </message>
    <message>
        <source>Your own; the studio brings: %1</source>
        <translation>你自訂的；程式預設：%1</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>指定</translation>
    </message>
    <message>
        <source>Choose a command to give it another key.</source>
        <translation>選擇命令以指定其他按鍵。</translation>
    </message>
    <message>
        <source>Press the new key for “%1” in the field.</source>
        <translation>在欄位中按下「%1」的新按鍵。</translation>
    </message>
    <message>
        <source>%1 is its key already.</source>
        <translation>%1 已是它的按鍵。</translation>
    </message>
    <message>
        <source>%1 is free.</source>
        <translation>%1 未被使用。</translation>
    </message>
    <message>
        <source>Take it over</source>
        <translation>改用於此</translation>
    </message>
    <message>
        <source>%1 is the key of %2. Taking it over leaves that command without it.</source>
        <translation>%1 是「%2」的按鍵。改用於此後，該命令就沒有按鍵了。</translation>
    </message>
    <message>
        <source> and </source>
        <translation> 和 </translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyField</name>
    <message>
        <source>Press a key</source>
        <translation>按下按鍵</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>新按鍵</translation>
    </message>
    <message>
        <source>Press the key here, alone or with Ctrl, Shift, Alt; then Tab goes on, and Shift+Tab always goes back</source>
        <translation>在此按下按鍵，可單獨或搭配 Ctrl、Shift、Alt；之後按 Tab 前進，Shift+Tab 一律後退</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyPanel</name>
    <message>
        <source>What appears here</source>
        <translation>這裡會出現什麼</translation>
    </message>
    <message>
        <source>Key pose</source>
        <translation>關鍵姿勢</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>動態</translation>
    </message>
    <message>
        <source>Hit a target</source>
        <translation>擊中目標</translation>
    </message>
    <message>
        <source>A strike of the takes and clips that follows a target, instead of keys</source>
        <translation>以鏡次與片段中跟隨目標的打擊，代替關鍵姿勢</translation>
    </message>
    <message>
        <source>Back to the keys</source>
        <translation>回到關鍵姿勢</translation>
    </message>
    <message>
        <source>Sho&amp;w the key pose</source>
        <translation>顯示關鍵姿勢(&amp;E)</translation>
    </message>
    <message>
        <source>Show the motio&amp;n</source>
        <translation>顯示動態(&amp;L)</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>片段…</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>保留…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>匯出…</translation>
    </message>
    <message>
        <source>A few key poses become a motion that is put together from the takes and clips: it appears here.</source>
        <translation>幾個關鍵姿勢就能成為動態，由鏡次與片段組合而成：會出現在這裡。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeySession</name>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2 至 %3</translation>
    </message>
    <message>
        <source>Preparing the clips</source>
        <translation>正在準備片段</translation>
    </message>
    <message>
        <source>Making the motion</source>
        <translation>正在製作動態</translation>
    </message>
    <message>
        <source>Add a key at frame %1</source>
        <translation>在影格 %1 加入關鍵姿勢</translation>
    </message>
    <message>
        <source>Take the pose of the recording</source>
        <translation>取用錄製的姿勢</translation>
    </message>
    <message>
        <source>Remove the key at frame %1</source>
        <translation>移除影格 %1 的關鍵姿勢</translation>
    </message>
    <message>
        <source>A key stands at frame %1 already.</source>
        <translation>影格 %1 已有關鍵姿勢。</translation>
    </message>
    <message>
        <source>Move the key to frame %1</source>
        <translation>移動關鍵姿勢到影格 %1</translation>
    </message>
    <message>
        <source>Move the key and later ones to frame %1</source>
        <translation>將此關鍵姿勢及之後的移到影格 %1</translation>
    </message>
    <message>
        <source>Later keys %1 times as far</source>
        <translation>之後的關鍵姿勢間隔變為 %1 倍</translation>
    </message>
    <message>
        <source>Copy the key to frame %1</source>
        <translation>複製關鍵姿勢到影格 %1</translation>
    </message>
    <message>
        <source>Mirror the key</source>
        <translation>鏡射關鍵姿勢</translation>
    </message>
    <message>
        <source>Change the way to the next key</source>
        <translation>變更到下一個關鍵姿勢的方式</translation>
    </message>
    <message>
        <source>Remove all keys</source>
        <translation>移除所有關鍵姿勢</translation>
    </message>
    <message>
        <source>Drag the %1</source>
        <translation>拖曳%1</translation>
    </message>
    <message>
        <source>Turn the %1</source>
        <translation>轉動%1</translation>
    </message>
    <message>
        <source>Move the %1 a little</source>
        <translation>稍微移動%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyStrip</name>
    <message>
        <source>Key poses over time</source>
        <translation>時間上的關鍵姿勢</translation>
    </message>
    <message>
        <source>The strike over time</source>
        <translation>時間上的打擊</translation>
    </message>
    <message>
        <source>The strikes are being aligned.</source>
        <translation>正在對齊打擊。</translation>
    </message>
    <message>
        <source>No strike to bring to a target.</source>
        <translation>沒有可帶往目標的打擊。</translation>
    </message>
    <message>
        <source>hit, %1</source>
        <translation>命中，%1</translation>
    </message>
    <message>
        <source>No key poses yet. Return makes the first one, of the pose that the take shows now.</source>
        <translation>還沒有關鍵姿勢。Return 會用鏡次目前顯示的姿勢建立第一個。</translation>
    </message>
    <message>
        <source>key at frame %1 · drag to move it</source>
        <translation>影格 %1 的關鍵姿勢 · 拖曳以移動</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeysPage</name>
    <message>
        <source>Mouse on the timeline</source>
        <translation>時間軸上的滑鼠</translation>
    </message>
    <message>
        <source>click, double-click</source>
        <translation>按一下，按兩下</translation>
    </message>
    <message>
        <source>select a boundary; remove or restore it</source>
        <translation>選取邊界；移除或還原邊界</translation>
    </message>
    <message>
        <source>× over a boundary</source>
        <translation>邊界上方的 ×</translation>
    </message>
    <message>
        <source>remove it at once</source>
        <translation>立即移除</translation>
    </message>
    <message>
        <source>drag a boundary</source>
        <translation>拖曳邊界</translation>
    </message>
    <message>
        <source>move it; Ctrl or Alt: without snapping; Esc: leave it</source>
        <translation>移動邊界；Ctrl 或 Alt：不貼齊；Esc：取消</translation>
    </message>
    <message>
        <source>drag elsewhere</source>
        <translation>在其他處拖曳</translation>
    </message>
    <message>
        <source>scrub</source>
        <translation>快速瀏覽</translation>
    </message>
    <message>
        <source>drag a loop end on the ruler</source>
        <translation>在尺規上拖曳循環端點</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>click, double-click an action</source>
        <translation>按一下、按兩下動作</translation>
    </message>
    <message>
        <source>select it; show and loop it</source>
        <translation>選取動作；顯示並循環播放</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>按右鍵</translation>
    </message>
    <message>
        <source>what can be done there</source>
        <translation>該處可做的事</translation>
    </message>
    <message>
        <source>wheel, Shift+wheel, middle drag</source>
        <translation>滾輪，Shift+滾輪，中鍵拖曳</translation>
    </message>
    <message>
        <source>scroll</source>
        <translation>捲動</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+滾輪</translation>
    </message>
    <message>
        <source>zoom about the pointer</source>
        <translation>以指標為中心縮放</translation>
    </message>
    <message>
        <source>Mouse in the 3D view</source>
        <translation>3D 檢視中的滑鼠</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>拖曳</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>旋轉</translation>
    </message>
    <message>
        <source>middle or Shift+drag</source>
        <translation>中鍵或 Shift+拖曳</translation>
    </message>
    <message>
        <source>move</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>滾輪</translation>
    </message>
    <message>
        <source>click a fighter</source>
        <translation>按一下選手</translation>
    </message>
    <message>
        <source>make it the active one</source>
        <translation>設為目前選手</translation>
    </message>
    <message>
        <source>measuring: click joints</source>
        <translation>測量時：按一下關節</translation>
    </message>
    <message>
        <source>distance; over a joint: its speed</source>
        <translation>距離；指在關節上：其速度</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>按鍵與滑鼠</translation>
    </message>
    <message>
        <source>Search keys and commands</source>
        <translation>搜尋按鍵與命令</translation>
    </message>
    <message>
        <source>Shows the lines that hold these letters</source>
        <translation>顯示含有這些字的列</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>列印…</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>另存為 PDF…</translation>
    </message>
    <message>
        <source>Change keys…</source>
        <translation>變更按鍵…</translation>
    </message>
    <message>
        <source>The keys of all workspaces, on paper. (Ctrl+P)</source>
        <translation>所有工作區的按鍵，印在紙上。(Ctrl+P)</translation>
    </message>
    <message>
        <source>The keys of all workspaces, as a file.</source>
        <translation>所有工作區的按鍵，存成檔案。</translation>
    </message>
    <message>
        <source>Gives commands other keys, in the preferences.</source>
        <translation>在偏好設定中為命令指定其他按鍵。</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>關閉此頁 (Esc)</translation>
    </message>
    <message>
        <source>No key and no command holds these letters.</source>
        <translation>沒有按鍵或命令含有這些字。</translation>
    </message>
    <message>
        <source>Nobody is here to choose a printer.</source>
        <translation>沒有人可選擇印表機。</translation>
    </message>
    <message>
        <source>Print the sheet of keys</source>
        <translation>列印按鍵表</translation>
    </message>
    <message>
        <source>%1 does not take the sheet.</source>
        <translation>%1 不接受這張表。</translation>
    </message>
    <message>
        <source>Save the sheet of keys</source>
        <translation>儲存按鍵表</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF 文件 (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written there.</source>
        <translation>無法將 %1 寫入該處。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelExchange</name>
    <message>
        <source>Labels (*.csv *.json *.eaf);;All files (*)</source>
        <translation>標籤 (*.csv *.json *.eaf);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>帶入標籤</translation>
    </message>
    <message>
        <source>Compare with another person&apos;s labels</source>
        <translation>與他人的標籤比較</translation>
    </message>
    <message>
        <source>Use another vocabulary</source>
        <translation>使用其他詞彙</translation>
    </message>
    <message>
        <source>Vocabularies (*.json)</source>
        <translation>詞彙 (*.json)</translation>
    </message>
    <message>
        <source>Write labels</source>
        <translation>寫出標籤</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json);;ELAN, the shown take (*.eaf)</source>
        <translation>表格 (*.csv);;JSON (*.json);;ELAN，顯示的鏡次 (*.eaf)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在讀取 %1</translation>
    </message>
    <message>
        <source>%1: %2 of %3 labels found their action.</source>
        <translation>%1：%3 個標籤中有 %2 個找到對應動作。</translation>
    </message>
    <message>
        <source>Labels written to %1.</source>
        <translation>標籤已寫入 %1。</translation>
    </message>
    <message>
        <source>The vocabulary that the studio brings</source>
        <translation>程式內建的詞彙</translation>
    </message>
    <message>
        <source>It has no word for these labels, which would be dropped (undo brings them back):</source>
        <translation>其中沒有這些標籤的詞，標籤將被捨棄（復原可找回）：</translation>
    </message>
    <message>
        <source>The vocabulary is %1 now.</source>
        <translation>目前的詞彙為 %1。</translation>
    </message>
    <message>
        <source>%1: %2, %3 aspects.</source>
        <translation>%1：%2，%3 個面向。</translation>
    </message>
    <message>
        <source>Use vocabulary</source>
        <translation>使用詞彙</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelLanes</name>
    <message>
        <source>%1 · action %2</source>
        <translation>%1 · 動作 %2</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>註記：%1</translation>
    </message>
    <message>
        <source>the machine would say %1</source>
        <translation>機器會標為%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelLearning</name>
    <message>
        <source>Comparing actions</source>
        <translation>正在比較動作</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>正在學習</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>正在校準</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelPalette</name>
    <message>
        <source>Classes and their keys</source>
        <translation>類別及其按鍵</translation>
    </message>
    <message>
        <source>For two strikes in one action: this, then a class of another lane</source>
        <translation>一個動作含兩次打擊時：按這個，再按另一軌的類別</translation>
    </message>
    <message>
        <source>
Right click: paint with it over actions of the timeline</source>
        <translation>
按右鍵：在時間軸的動作上塗抹此類別</translation>
    </message>
    <message>
        <source>first, then two classes: both</source>
        <translation>先按，再按兩個類別：兩者並列</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelPanel</name>
    <message>
        <source>Go on after an answer</source>
        <translation>回答後繼續</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按鍵</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>佇列</translation>
    </message>
    <message>
        <source>Current action</source>
        <translation>目前動作</translation>
    </message>
    <message>
        <source>Accept what is proposed</source>
        <translation>接受建議</translation>
    </message>
    <message>
        <source>Take the second best instead; of what a hand said, nothing any more</source>
        <translation>改用次佳選項；若是手動標記則清空</translation>
    </message>
    <message>
        <source>Why rules say so</source>
        <translation>規則的理由</translation>
    </message>
    <message>
        <source>Most useful first</source>
        <translation>最有用的優先</translation>
    </message>
    <message>
        <source>Least sure first</source>
        <translation>最沒把握的優先</translation>
    </message>
    <message>
        <source>In order of time</source>
        <translation>依時間順序</translation>
    </message>
    <message>
        <source>Order of the queue</source>
        <translation>佇列的順序</translation>
    </message>
    <message>
        <source>Most useful: where the machine is torn, spread over different-looking actions</source>
        <translation>最有用：機器猶豫不決之處，並分散到外觀不同的動作</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>Sure from %1 on: %2</source>
        <translation>從 %1 起算有把握：%2</translation>
    </message>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>%n 個動作</numerusform>
        </translation>
    </message>
    <message>
        <source>No action</source>
        <translation>沒有動作</translation>
    </message>
    <message>
        <source>Actions appear here once a recording is open and cut.</source>
        <translation>開啟並切割錄製後，動作會出現在這裡。</translation>
    </message>
    <message>
        <source>%1 leads to the first question; or click an action.</source>
        <translation>%1 前往第一個問題；或按一下動作。</translation>
    </message>
    <message>
        <source>%1 actions chosen</source>
        <translation>已選取 %1 個動作</translation>
    </message>
    <message>
        <source>%1 · action %2 · %3</source>
        <translation>%1 · 動作 %2 · %3</translation>
    </message>
    <message>
        <source>%1 · by hand</source>
        <translation>%1 · 手動</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>收回</translation>
    </message>
    <message>
        <source>the only class so far</source>
        <translation>目前唯一的類別</translation>
    </message>
    <message>
        <source>Nothing is proposed yet</source>
        <translation>尚無建議</translation>
    </message>
    <message>
        <source>Something else: a class key</source>
        <translation>是別的：按類別鍵</translation>
    </message>
    <message>
        <source>Say what it is by a class key</source>
        <translation>用類別鍵說明它是什麼</translation>
    </message>
    <message>
        <source>%1  %2  %3</source>
        <translation>%1  %2  %3</translation>
    </message>
    <message>
        <source>Queue %1</source>
        <translation>佇列 %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelReview</name>
    <message>
        <source>There is no action to label.</source>
        <translation>沒有可標記的動作。</translation>
    </message>
    <message>
        <source>No question is left. Accept what rules and machine say of the rest.</source>
        <translation>沒有問題了。請接受規則與機器對其餘動作的說法。</translation>
    </message>
    <message>
        <source>No question was shown before.</source>
        <translation>之前沒有顯示過問題。</translation>
    </message>
    <message>
        <source>Said: %1. This is the next question.</source>
        <translation>已標記：%1。這是下一個問題。</translation>
    </message>
    <message>
        <source>That is what a hand has said already.</source>
        <translation>這已經是手動標記的內容。</translation>
    </message>
    <message>
        <source>The machine proposes nothing yet: say what it is by a class key.</source>
        <translation>機器尚無建議：請用類別鍵說明。</translation>
    </message>
    <message>
        <source>There is no second best: say what it is by a class key.</source>
        <translation>沒有次佳選項：請用類別鍵說明。</translation>
    </message>
    <message>
        <source>%1 has no class %2.</source>
        <translation>%1 沒有類別 %2。</translation>
    </message>
    <message>
        <source>The next class key adds to the label.</source>
        <translation>下一個類別鍵會加到標籤上。</translation>
    </message>
    <message>
        <source>Accepted as soon as the machine knows how sure it is.</source>
        <translation>機器算出把握程度後就會接受。</translation>
    </message>
    <message>
        <source>Every action is labelled, all of them by hand.</source>
        <translation>每個動作都有標籤，全部是手動標記。</translation>
    </message>
    <message>
        <source>Every action is labelled; of these the machine was least sure. Return says that it is right.</source>
        <translation>每個動作都有標籤；這些是機器最沒把握的。正確時請按 Enter。</translation>
    </message>
    <message>
        <source>Said: %1. Now the class beside it.</source>
        <translation>已回答：%1。請再選並列的類別。</translation>
    </message>
    <message numerus="yes">
        <source>Accepted: %n action(s). Ctrl+Z takes all of it back.</source>
        <translation>
            <numerusform>已接受：%n 個動作。Ctrl+Z 可全部收回。</numerusform>
        </translation>
    </message>
    <message>
        <source>Accepted what rules say.</source>
        <translation>已接受規則的建議。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelViews</name>
    <message>
        <source>Palette and questions</source>
        <translation>面板與問題</translation>
    </message>
    <message>
        <source>Find actions by what is said of them</source>
        <translation>依標記內容尋找動作</translation>
    </message>
    <message>
        <source>Actions that look like the current one, side by side</source>
        <translation>將與目前動作相似的動作並排</translation>
    </message>
    <message>
        <source>How well the machine knows the bout: confusion matrix and learning curve</source>
        <translation>機器對這場對打掌握多少：混淆矩陣與學習曲線</translation>
    </message>
    <message>
        <source>Thresholds of the rules for move and react</source>
        <translation>移動與反應規則的門檻</translation>
    </message>
    <message>
        <source>Another person&apos;s labels beside these</source>
        <translation>將他人的標籤與這些並列</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>標記</translation>
    </message>
    <message>
        <source>Find actions</source>
        <translation>尋找動作</translation>
    </message>
    <message>
        <source>Similar actions</source>
        <translation>相似動作</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>品質</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>規則</translation>
    </message>
    <message>
        <source>Two people</source>
        <translation>兩人比較</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelWords</name>
    <message>
        <source>%1 open</source>
        <translation>%1未定</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>無%1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>無</translation>
    </message>
    <message>
        <source>open</source>
        <translation>未定</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>手動</translation>
    </message>
    <message>
        <source>rule</source>
        <translation>規則</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手動</translation>
    </message>
    <message>
        <source>accepted from a rule</source>
        <translation>接受自規則</translation>
    </message>
    <message>
        <source>accepted from the machine, %1</source>
        <translation>接受自機器，%1</translation>
    </message>
    <message>
        <source>proposed by a rule</source>
        <translation>規則建議</translation>
    </message>
    <message>
        <source>proposed by a rule, %1</source>
        <translation>規則建議，%1</translation>
    </message>
    <message>
        <source>proposed: the only one seen so far</source>
        <translation>建議：目前唯一見過的</translation>
    </message>
    <message>
        <source>proposed by the machine, %1</source>
        <translation>機器建議，%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LaneSource</name>
    <message>
        <source>labels</source>
        <translation>標籤</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LearningPlot</name>
    <message>
        <source>Learning curve</source>
        <translation>學習曲線</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>預期 %1</translation>
    </message>
    <message>
        <source>as asked %1</source>
        <translation>依提問 %1</translation>
    </message>
    <message>
        <source>random %1</source>
        <translation>隨機 %1</translation>
    </message>
    <message>
        <source>%1 labels: %2</source>
        <translation>%1 個標籤：%2</translation>
    </message>
    <message>
        <source>labels by hand</source>
        <translation>手動標籤</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>預期</translation>
    </message>
    <message>
        <source>as asked</source>
        <translation>依提問</translation>
    </message>
    <message>
        <source>random</source>
        <translation>隨機</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MadeMotion</name>
    <message>
        <source>Keep the motion as a take</source>
        <translation>將動態存為鏡次</translation>
    </message>
    <message>
        <source>Recordings (*.bvh)</source>
        <translation>錄製檔 (*.bvh)</translation>
    </message>
    <message>
        <source>Keeping the motion</source>
        <translation>正在保留動態</translation>
    </message>
    <message>
        <source>Kept as take %1.</source>
        <translation>已存為鏡次 %1。</translation>
    </message>
    <message>
        <source>Export the motion</source>
        <translation>匯出動態</translation>
    </message>
    <message>
        <source>Motion (*.bvh);;glTF: skeleton and animation (*.glb)</source>
        <translation>動態 (*.bvh);;glTF：骨架與動畫 (*.glb)</translation>
    </message>
    <message>
        <source>Writing the motion</source>
        <translation>正在寫入動態</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已寫入：%1</translation>
    </message>
    <message>
        <source>Add clips</source>
        <translation>加入片段</translation>
    </message>
    <message>
        <source>Motion and projects (*.bvh *.amc *.kumite)</source>
        <translation>動態與專案 (*.bvh *.amc *.kumite)</translation>
    </message>
    <message>
        <source>Add all clips of a folder</source>
        <translation>加入資料夾中的所有片段</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MainWindow</name>
    <message>
        <source>&amp;Segment</source>
        <translation>分段(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Remove or restore boundary</source>
        <translation>移除或還原邊界(&amp;R)</translation>
    </message>
    <message>
        <source>Split here: &amp;add a boundary</source>
        <translation>在此分割：加入邊界(&amp;A)</translation>
    </message>
    <message>
        <source>Join with the action &amp;before</source>
        <translation>與前一個動作合併(&amp;B)</translation>
    </message>
    <message>
        <source>Join with the action af&amp;ter</source>
        <translation>與後一個動作合併(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Previous boundary</source>
        <translation>上一個邊界(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next boundary</source>
        <translation>下一個邊界(&amp;N)</translation>
    </message>
    <message>
        <source>Move boundary one frame &amp;earlier</source>
        <translation>邊界提前一影格(&amp;E)</translation>
    </message>
    <message>
        <source>Move boundary one frame &amp;later</source>
        <translation>邊界延後一影格(&amp;L)</translation>
    </message>
    <message>
        <source>Select the action before</source>
        <translation>選取前一個動作</translation>
    </message>
    <message>
        <source>Select the action after</source>
        <translation>選取後一個動作</translation>
    </message>
    <message>
        <source>Sho&amp;w and loop the action</source>
        <translation>顯示並循環播放動作(&amp;W)</translation>
    </message>
    <message>
        <source>N&amp;ote on the action…</source>
        <translation>為動作加註記(&amp;O)…</translation>
    </message>
    <message>
        <source>Ne&amp;xt suspect</source>
        <translation>下一個可疑點(&amp;X)</translation>
    </message>
    <message>
        <source>Pre&amp;vious suspect</source>
        <translation>上一個可疑點(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Keep: it is a boundary</source>
        <translation>保留：這是邊界(&amp;K)</translation>
    </message>
    <message>
        <source>Re&amp;move: it is spurious</source>
        <translation>移除：這是假的(&amp;M)</translation>
    </message>
    <message>
        <source>De&amp;cide anew</source>
        <translation>重新決定(&amp;C)</translation>
    </message>
    <message>
        <source>Compare with settings B</source>
        <translation>與設定 B 比較</translation>
    </message>
    <message>
        <source>T&amp;imeline</source>
        <translation>時間軸(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Height of the centre of mass</source>
        <translation>質心高度(&amp;H)</translation>
    </message>
    <message>
        <source>Force without &amp;smoothing</source>
        <translation>未平滑的力(&amp;S)</translation>
    </message>
    <message>
        <source>Speeds of the h&amp;ands</source>
        <translation>手部速度(&amp;A)</translation>
    </message>
    <message>
        <source>Speeds of the &amp;feet</source>
        <translation>足部速度(&amp;F)</translation>
    </message>
    <message>
        <source>Ruler in &amp;time and frames</source>
        <translation>尺規以時間與影格(&amp;T)</translation>
    </message>
    <message>
        <source>Ruler in time</source>
        <translation>尺規以時間</translation>
    </message>
    <message>
        <source>Ruler in frames</source>
        <translation>尺規以影格</translation>
    </message>
    <message>
        <source>Next &amp;unit of the ruler</source>
        <translation>尺規的下一種單位(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>標記(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Next question</source>
        <translation>下一個問題(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Previous question</source>
        <translation>上一個問題(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Accept what is proposed</source>
        <translation>接受建議(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Reject: the second best instead</source>
        <translation>拒絕：改用次佳選項(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Take back what is said of the action</source>
        <translation>收回對動作的標記(&amp;T)</translation>
    </message>
    <message>
        <source>Accept the &amp;sure rest</source>
        <translation>接受其餘有把握的(&amp;S)</translation>
    </message>
    <message>
        <source>Less sure is sure eno&amp;ugh</source>
        <translation>放寬把握門檻(&amp;U)</translation>
    </message>
    <message>
        <source>On&amp;ly surer is sure enough</source>
        <translation>提高把握門檻(&amp;L)</translation>
    </message>
    <message>
        <source>Answers &amp;go on to the next question</source>
        <translation>回答後前往下一個問題(&amp;G)</translation>
    </message>
    <message>
        <source>Lane abo&amp;ve</source>
        <translation>上一軌(&amp;V)</translation>
    </message>
    <message>
        <source>Lane belo&amp;w</source>
        <translation>下一軌(&amp;W)</translation>
    </message>
    <message>
        <source>Nothing of the lane&apos;s aspect</source>
        <translation>此軌的面向皆無</translation>
    </message>
    <message>
        <source>Class %1 of the lane</source>
        <translation>此軌的類別 %1</translation>
    </message>
    <message>
        <source>Next class &amp;besides: a composite</source>
        <translation>再加下一個類別：複合(&amp;B)</translation>
    </message>
    <message>
        <source>Choose the action before as well</source>
        <translation>一併選取前一個動作</translation>
    </message>
    <message>
        <source>Choose the action after as well</source>
        <translation>一併選取後一個動作</translation>
    </message>
    <message>
        <source>Quick label %1</source>
        <translation>快速標籤 %1</translation>
    </message>
    <message>
        <source>Label: %1</source>
        <translation>標籤：%1</translation>
    </message>
    <message>
        <source>Show pal&amp;ette and questions</source>
        <translation>顯示面板與問題(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Find actions</source>
        <translation>尋找動作(&amp;F)</translation>
    </message>
    <message>
        <source>Show si&amp;milar actions</source>
        <translation>顯示相似動作(&amp;J)</translation>
    </message>
    <message>
        <source>Show &amp;quality</source>
        <translation>顯示品質(&amp;Q)</translation>
    </message>
    <message>
        <source>Show &amp;rules</source>
        <translation>顯示規則(&amp;M)</translation>
    </message>
    <message>
        <source>Show &amp;two people&apos;s labels</source>
        <translation>顯示兩人的標籤(&amp;X)</translation>
    </message>
    <message>
        <source>Ne&amp;xt action found</source>
        <translation>下一個找到的動作(&amp;Y)</translation>
    </message>
    <message>
        <source>Pre&amp;vious action found</source>
        <translation>上一個找到的動作(&amp;Z)</translation>
    </message>
    <message>
        <source>Choose &amp;all that were found</source>
        <translation>選取所有找到的動作(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Give similar actions the same label</source>
        <translation>給相似動作相同標籤(&amp;G)</translation>
    </message>
    <message>
        <source>Take t&amp;heirs</source>
        <translation>採用對方(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>保留我的(&amp;K)</translation>
    </message>
    <message>
        <source>Take theirs for all that are &amp;open</source>
        <translation>所有未定的採用對方(&amp;O)</translation>
    </message>
    <message>
        <source>Add what onl&amp;y they labelled</source>
        <translation>加入僅對方標記的(&amp;A)</translation>
    </message>
    <message>
        <source>Next &amp;difference</source>
        <translation>下一處差異(&amp;D)</translation>
    </message>
    <message>
        <source>Take &amp;over labels…</source>
        <translation>帶入標籤(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Write labels…</source>
        <translation>寫出標籤(&amp;W)…</translation>
    </message>
    <message>
        <source>&amp;Compare with labels of…</source>
        <translation>與他人的標籤比較(&amp;C)…</translation>
    </message>
    <message>
        <source>Use another voca&amp;bulary…</source>
        <translation>使用其他詞彙(&amp;B)…</translation>
    </message>
    <message>
        <source>Use the built-&amp;in vocabulary</source>
        <translation>使用內建詞彙(&amp;I)</translation>
    </message>
    <message>
        <source>%1[*] — Kumite</source>
        <translation>%1[*] — Kumite</translation>
    </message>
    <message>
        <source>Kumite</source>
        <translation>Kumite</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>檔案(&amp;F)</translation>
    </message>
    <message>
        <source>Open the &amp;demo bout</source>
        <translation>開啟示範對打(&amp;D)</translation>
    </message>
    <message>
        <source>Open &amp;recordings…</source>
        <translation>開啟錄製檔(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>開啟專案(&amp;O)…</translation>
    </message>
    <message>
        <source>Opened &amp;lately</source>
        <translation>最近開啟(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>儲存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存新檔(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Versions…</source>
        <translation>版本(&amp;V)…</translation>
    </message>
    <message>
        <source>&amp;Export actions…</source>
        <translation>匯出動作(&amp;E)…</translation>
    </message>
    <message>
        <source>Export &amp;motion…</source>
        <translation>匯出動態(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Find recording…</source>
        <translation>尋找錄製檔(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>結束(&amp;Q)</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>尚無項目</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編輯(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>復原(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Run a &amp;command by name…</source>
        <translation>以名稱執行命令(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>偏好設定(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>播放或暫停(&amp;P)</translation>
    </message>
    <message>
        <source>Play &amp;backward, faster</source>
        <translation>倒轉播放，更快(&amp;B)</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>Play &amp;forward, faster</source>
        <translation>正向播放，更快(&amp;F)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>後退一影格</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>前進一影格</translation>
    </message>
    <message>
        <source>Leap</source>
        <translation>跳格</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>到開頭</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>到結尾</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>放慢</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>加快</translation>
    </message>
    <message>
        <source>Loop begins here</source>
        <translation>循環從這裡開始</translation>
    </message>
    <message>
        <source>Loop ends here</source>
        <translation>循環到這裡結束</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>循環(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>檢視(&amp;V)</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>顯示全部(&amp;A)</translation>
    </message>
    <message>
        <source>Show the &amp;fighter and what is selected</source>
        <translation>顯示選手與選取項目(&amp;F)</translation>
    </message>
    <message>
        <source>Hide &amp;panels</source>
        <translation>隱藏面板(&amp;P)</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>全螢幕(&amp;U)</translation>
    </message>
    <message>
        <source>Theme as the system</source>
        <translation>佈景主題依系統</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>淺色佈景主題</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>深色佈景主題</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>放大文字</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>縮小文字</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>說明(&amp;H)</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>分段</translation>
    </message>
    <message>
        <source>Correct the boundaries that cut the bout into actions.</source>
        <translation>修正將對打切成動作的邊界。</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>標記</translation>
    </message>
    <message>
        <source>Say what a few actions are; the machine says it of the rest.</source>
        <translation>說明少數動作是什麼；其餘由機器標記。</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>轉換圖</translation>
    </message>
    <message>
        <source>What each fighter tends to do next, and the moments behind it.</source>
        <translation>每位選手接下來傾向做什麼，以及背後的片刻。</translation>
    </message>
    <message>
        <source>Label actions</source>
        <translation>標記動作</translation>
    </message>
    <message>
        <source>Go to the Label workspace</source>
        <translation>前往「標記」工作區</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>帶入標籤</translation>
    </message>
    <message>
        <source>From a table of labels; of a made bout at once its truth</source>
        <translation>取自標籤表格；虛構的對打則直接取其正確答案</translation>
    </message>
    <message>
        <source>Bout</source>
        <translation>對打</translation>
    </message>
    <message>
        <source>Let both fight on from what was learnt, or fight yourself.</source>
        <translation>讓雙方依所學繼續對打，或自己下場。</translation>
    </message>
    <message>
        <source>Clips of sequences</source>
        <translation>序列的片段</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Play actions in any order, led over to each other.</source>
        <translation>以任意順序播放動作，彼此銜接。</translation>
    </message>
    <message>
        <source>Add clips…</source>
        <translation>加入片段…</translation>
    </message>
    <message>
        <source>Of motion files or other projects</source>
        <translation>取自動態檔案或其他專案</translation>
    </message>
    <message>
        <source>Keyframe</source>
        <translation>關鍵影格</translation>
    </message>
    <message>
        <source>A few key poses become a motion made of the recorded ones.</source>
        <translation>幾個關鍵姿勢即可用錄製的動態組成新動態。</translation>
    </message>
    <message>
        <source>%1 frames back</source>
        <translation>後退 %1 影格</translation>
    </message>
    <message>
        <source>%1 frames on</source>
        <translation>前進 %1 影格</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>關節</translation>
    </message>
    <message>
        <source>measure from or to it</source>
        <translation>從此量起或量到此</translation>
    </message>
    <message>
        <source>other fighter</source>
        <translation>另一位選手</translation>
    </message>
    <message>
        <source>leave measuring</source>
        <translation>離開測量</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>暫停</translation>
    </message>
    <message>
        <source>play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>next suspect</source>
        <translation>下一個可疑點</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>action</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>note</source>
        <translation>註記</translation>
    </message>
    <message>
        <source>next question</source>
        <translation>下一個問題</translation>
    </message>
    <message>
        <source>accept</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>second best</source>
        <translation>次佳</translation>
    </message>
    <message>
        <source>lane</source>
        <translation>軌</translation>
    </message>
    <message>
        <source>… its classes</source>
        <translation>… 其類別</translation>
    </message>
    <message>
        <source>fight</source>
        <translation>開打</translation>
    </message>
    <message>
        <source>… lead the avatar</source>
        <translation>… 操控化身</translation>
    </message>
    <message>
        <source>go on otherwise</source>
        <translation>換個走向繼續</translation>
    </message>
    <message>
        <source>… play a block at once</source>
        <translation>… 立即播放區塊</translation>
    </message>
    <message>
        <source>back to the sequence</source>
        <translation>回到序列</translation>
    </message>
    <message>
        <source>find an action</source>
        <translation>尋找動作</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>加入</translation>
    </message>
    <message>
        <source>block</source>
        <translation>區塊</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>draw its transition anew</source>
        <translation>重新抽選其轉換</translation>
    </message>
    <message>
        <source>map of poses</source>
        <translation>姿勢地圖</translation>
    </message>
    <message>
        <source>live</source>
        <translation>即時</translation>
    </message>
    <message>
        <source>add a key here</source>
        <translation>在此加入關鍵姿勢</translation>
    </message>
    <message>
        <source>key</source>
        <translation>關鍵姿勢</translation>
    </message>
    <message>
        <source>take the recording&apos;s pose</source>
        <translation>取用錄製的姿勢</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>控點</translation>
    </message>
    <message>
        <source>pin it</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>鏡射</translation>
    </message>
    <message>
        <source>back to the keys</source>
        <translation>回到關鍵姿勢</translation>
    </message>
    <message>
        <source>hit a target</source>
        <translation>擊中目標</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>按鍵</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>動態</translation>
    </message>
    <message>
        <source>keep as a take</source>
        <translation>存為鏡次</translation>
    </message>
    <message>
        <source>next surprise</source>
        <translation>下一個意外</translation>
    </message>
    <message>
        <source>play what is behind</source>
        <translation>播放背後的片刻</translation>
    </message>
    <message>
        <source>matrix or graph</source>
        <translation>矩陣或圖</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>影格</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>邊界</translation>
    </message>
    <message>
        <source>add</source>
        <translation>加入</translation>
    </message>
    <message>
        <source>any command</source>
        <translation>任何命令</translation>
    </message>
    <message>
        <source>help</source>
        <translation>說明</translation>
    </message>
    <message>
        <source>1 finding</source>
        <translation>1 項發現</translation>
    </message>
    <message>
        <source>%1 findings</source>
        <translation>%1 項發現</translation>
    </message>
    <message>
        <source>What was found in the recordings</source>
        <translation>錄製檔中的發現事項</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>鏡次(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Add recordings as a take…</source>
        <translation>加入錄製檔作為鏡次(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Rename take</source>
        <translation>重新命名鏡次(&amp;R)</translation>
    </message>
    <message>
        <source>Re&amp;move take</source>
        <translation>移除鏡次(&amp;M)</translation>
    </message>
    <message>
        <source>Move take &amp;up</source>
        <translation>鏡次上移(&amp;U)</translation>
    </message>
    <message>
        <source>Move take &amp;down</source>
        <translation>鏡次下移(&amp;D)</translation>
    </message>
    <message>
        <source>Show the take &amp;before</source>
        <translation>顯示前一個鏡次(&amp;B)</translation>
    </message>
    <message>
        <source>Show the take a&amp;fter</source>
        <translation>顯示後一個鏡次(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Other fighter active</source>
        <translation>切換目前選手(&amp;O)</translation>
    </message>
    <message>
        <source>Fighter &amp;properties…</source>
        <translation>選手屬性(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Swap fighters</source>
        <translation>對調選手(&amp;S)</translation>
    </message>
    <message>
        <source>F&amp;indings on the recordings</source>
        <translation>錄製檔的發現事項(&amp;I)</translation>
    </message>
    <message>
        <source>Removed take %1. %2 brings it back.</source>
        <translation>已移除鏡次 %1。%2 可還原。</translation>
    </message>
    <message>
        <source>leave the field or button</source>
        <translation>離開欄位或按鈕</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MatrixPage</name>
    <message>
        <source>log</source>
        <translation>對數</translation>
    </message>
    <message>
        <source>by own label</source>
        <translation>依自己的標籤</translation>
    </message>
    <message>
        <source>by opponent&apos;s label</source>
        <translation>依對手的標籤</translation>
    </message>
    <message>
        <source>by both labels</source>
        <translation>依雙方標籤</translation>
    </message>
    <message>
        <source>What the rows know</source>
        <translation>列所知的內容</translation>
    </message>
    <message>
        <source>What the rows know: what the fighter does, what the opponent does, or both. What is left out is summed over.</source>
        <translation>列所知的內容：選手做什麼、對手做什麼，或兩者。未列入的會加總。</translation>
    </message>
    <message>
        <source>by count</source>
        <translation>依次數</translation>
    </message>
    <message>
        <source>by name</source>
        <translation>依名稱</translation>
    </message>
    <message>
        <source>by likeness</source>
        <translation>依相似度</translation>
    </message>
    <message>
        <source>Order of rows and columns</source>
        <translation>列與欄的順序</translation>
    </message>
    <message>
        <source>By likeness rows that lead to the same labels become neighbours; a line parts the groups.</source>
        <translation>依相似度時，通往相同標籤的列會相鄰；以線分隔各組。</translation>
    </message>
    <message>
        <source>P, EQU7</source>
        <translation>P，EQU7</translation>
    </message>
    <message>
        <source>P, EQU6</source>
        <translation>P，EQU6</translation>
    </message>
    <message>
        <source>P, EQU5</source>
        <translation>P，EQU5</translation>
    </message>
    <message>
        <source>as counted</source>
        <translation>依計數</translation>
    </message>
    <message>
        <source>How probabilities are estimated</source>
        <translation>機率的估計方式</translation>
    </message>
    <message>
        <source>EQU7: P(next | own) · P(next | opponent). EQU6: over pairs of label elements. EQU5: counts of whole triples. All three with a prior, so that nothing is impossible; as counted: without.</source>
        <translation>EQU7：P(下一個 | 自己) · P(下一個 | 對手)。EQU6：以標籤元素的配對計。EQU5：以完整三元組計數。三者皆有先驗，因此沒有不可能的事；依計數則沒有。</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>並列</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差異</translation>
    </message>
    <message>
        <source>How two are compared</source>
        <translation>兩者的比較方式</translation>
    </message>
    <message>
        <source>Colours over the logarithm: rare transitions become visible</source>
        <translation>顏色取對數：罕見的轉換也看得見</translation>
    </message>
    <message>
        <source>Matrix of transitions to compare with</source>
        <translation>用來比較的轉換矩陣</translation>
    </message>
    <message>
        <source>P(next | own)</source>
        <translation>P(下一個 | 自己)</translation>
    </message>
    <message>
        <source>P(next | opponent)</source>
        <translation>P(下一個 | 對手)</translation>
    </message>
    <message>
        <source>P(next | own, opponent)</source>
        <translation>P(下一個 | 自己, 對手)</translation>
    </message>
    <message>
        <source>%1 − %2</source>
        <translation>%1 − %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>difference %1</source>
        <translation>差異 %1</translation>
    </message>
    <message>
        <source>P %1</source>
        <translation>P %1</translation>
    </message>
    <message>
        <source>%1 → %2   ·   %3   ·   seen %4 of %5 times</source>
        <translation>%1 → %2   ·   %3   ·   見過 %4 / %5 次</translation>
    </message>
    <message>
        <source>%1   ·   %2 transitions begin so</source>
        <translation>%1   ·   %2 個轉換由此開始</translation>
    </message>
    <message>
        <source>%1   ·   %2 transitions lead here</source>
        <translation>%1   ·   %2 個轉換通往這裡</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MatrixView</name>
    <message>
        <source>Matrix of transitions</source>
        <translation>轉換矩陣</translation>
    </message>
    <message>
        <source>A row is what goes on, a column what follows. Arrows lead from cell to cell; the moments behind the chosen one are listed beside it.</source>
        <translation>列是正在進行的，欄是接下來的。方向鍵在格子間移動；所選格子背後的片刻列在旁邊。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MessageStrip</name>
    <message>
        <source>Details</source>
        <translation>詳細資料</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>關閉</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>發生了什麼</translation>
    </message>
    <message numerus="yes">
        <source> And %n more.</source>
        <translation>
            <numerusform> 還有 %n 則。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::MotionBox</name>
    <message>
        <source>joints adjusted</source>
        <translation>關節已調整</translation>
    </message>
    <message>
        <source>What the motion is made of</source>
        <translation>動態的組成</translation>
    </message>
    <message>
        <source>whole body</source>
        <translation>全身</translation>
    </message>
    <message>
        <source>What is looked for</source>
        <translation>尋找的對象</translation>
    </message>
    <message>
        <source>In what the places are like the keys: the whole body or one part</source>
        <translation>這些位置在何處與關鍵姿勢相似：全身或某個部位</translation>
    </message>
    <message>
        <source>Similar in</source>
        <translation>相似部位</translation>
    </message>
    <message>
        <source>The keys and places like them</source>
        <translation>關鍵姿勢及與其相似的位置</translation>
    </message>
    <message>
        <source>First the keys, then what is most like them; a click takes it</source>
        <translation>先是關鍵姿勢，再來是最相似的；點按即採用</translation>
    </message>
    <message>
        <source>Places that are like the keys</source>
        <translation>與關鍵姿勢相似之處</translation>
    </message>
    <message>
        <source>The places that are most like the keys, the best first; a click, or Return, takes the body or the part from there</source>
        <translation>與關鍵姿勢最相似的位置，最好的在前；點按或 Enter 即取用該處的身體或部位</translation>
    </message>
    <message>
        <source>what fits better</source>
        <translation>更合適的</translation>
    </message>
    <message>
        <source>with the body</source>
        <translation>隨身體</translation>
    </message>
    <message>
        <source>its own best</source>
        <translation>自己的最佳</translation>
    </message>
    <message>
        <source>as chosen above</source>
        <translation>依上方所選</translation>
    </message>
    <message>
        <source>Where the %1 comes from</source>
        <translation>%1的來源</translation>
    </message>
    <message>
        <source>Take a part from elsewhere</source>
        <translation>改從別處取用部位</translation>
    </message>
    <message>
        <source>Where parts are joined the joints&apos; mean and spread become those of the keys (paper C, 4.2.2)</source>
        <translation>部位接合處，關節的平均值與離散程度會變成關鍵姿勢的（論文 C，4.2.2）</translation>
    </message>
    <message>
        <source>How far the motion is drawn to the keys</source>
        <translation>動態拉向關鍵姿勢的程度</translation>
    </message>
    <message>
        <source>Left: as it was found; right: through the keys&apos; poses</source>
        <translation>左：如所找到；右：通過關鍵姿勢</translation>
    </message>
    <message>
        <source>Meet keys</source>
        <translation>貼合姿勢</translation>
    </message>
    <message>
        <source>Join parts otherwise</source>
        <translation>換個方式接合部位</translation>
    </message>
    <message>
        <source>Draw the motion to the keys</source>
        <translation>將動態拉向關鍵姿勢</translation>
    </message>
    <message>
        <source>Two keys or more become a motion, put together from the takes and clips.</source>
        <translation>兩個以上的關鍵姿勢會成為動態，由鏡次與片段組合而成。</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>正在製作動態。</translation>
    </message>
    <message>
        <source>Body: %1, %2 of %3 features differ, %4 cm from the keys.</source>
        <translation>身體：%1，%3 個特徵中 %2 個不同，距關鍵姿勢 %4 cm。</translation>
    </message>
    <message>
        <source>%1 features differ, %2 cm from the keys</source>
        <translation>%1 個特徵不同，距關鍵姿勢 %2 cm</translation>
    </message>
    <message>
        <source>%1, %2 features differ</source>
        <translation>%1，%2 個特徵不同</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>關鍵姿勢</translation>
    </message>
    <message>
        <source>Take the %1 from elsewhere</source>
        <translation>從別處取用%1</translation>
    </message>
    <message>
        <source>Take the body from elsewhere</source>
        <translation>身體改從別處取用</translation>
    </message>
</context>
<context>
    <name>kumite::studio::NodePage</name>
    <message>
        <source>cross edges</source>
        <translation>交叉邊</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差異</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Fighter 1&apos;s graph before fighter 2&apos;s, cross edges between; drag turns</source>
        <translation>選手 1 的圖在選手 2 的圖前方，交叉邊在中間；拖曳可旋轉</translation>
    </message>
    <message>
        <source>Also what a fighter does next given what the opponent is doing; those of what is selected show always</source>
        <translation>同時顯示選手依對手正在做的事接下來做什麼；選取項目的交叉邊一律顯示</translation>
    </message>
    <message>
        <source>Of each side only what it does more often than the other, as wide as the difference</source>
        <translation>每一方只顯示比另一方更常做的，寬度即差異</translation>
    </message>
    <message>
        <source>Least probability of an edge</source>
        <translation>邊的最低機率</translation>
    </message>
    <message>
        <source>Edges that are less probable are not drawn.</source>
        <translation>機率較低的邊不會畫出。</translation>
    </message>
    <message>
        <source>Most edges from a node</source>
        <translation>每個節點最多的邊數</translation>
    </message>
    <message>
        <source>So many edges of each node are drawn, the likeliest ones.</source>
        <translation>每個節點畫出這麼多條邊，取最可能的。</translation>
    </message>
    <message>
        <source>ΔP ≥ 0.000</source>
        <translation>ΔP ≥ 0.000</translation>
    </message>
    <message>
        <source>12 a node</source>
        <translation>每節點 12 條</translation>
    </message>
    <message>
        <source>ΔP ≥ %1</source>
        <translation>ΔP ≥ %1</translation>
    </message>
    <message>
        <source>P ≥ %1</source>
        <translation>P ≥ %1</translation>
    </message>
    <message>
        <source>%1 a node</source>
        <translation>每節點 %1 條</translation>
    </message>
    <message>
        <source>%1: %2   ·   %3 actions</source>
        <translation>%1：%2   ·   %3 個動作</translation>
    </message>
    <message>
        <source>%1: %2 → %3   ·   %4 %5   ·   seen %6 times</source>
        <translation>%1：%2 → %3   ·   %4 %5   ·   見過 %6 次</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 對 %2</translation>
    </message>
    <message>
        <source>more often by</source>
        <translation>較常出現於</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
</context>
<context>
    <name>kumite::studio::NoteField</name>
    <message>
        <source>Note on the action</source>
        <translation>動作的註記</translation>
    </message>
    <message>
        <source>Return keeps the note, Esc leaves it as it was; no text removes it.</source>
        <translation>Return 保留註記，Esc 維持原樣；清空文字即移除。</translation>
    </message>
    <message>
        <source>Note on this action</source>
        <translation>此動作的註記</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PartDialog</name>
    <message>
        <source>joints adjusted</source>
        <translation>關節已調整</translation>
    </message>
    <message>
        <source>Replace a part of a take</source>
        <translation>取代鏡次的一部分</translation>
    </message>
    <message>
        <source>In</source>
        <translation>在</translation>
    </message>
    <message>
        <source>take that is changed</source>
        <translation>要變更的鏡次</translation>
    </message>
    <message>
        <source>Part that is replaced</source>
        <translation>被取代的部位</translation>
    </message>
    <message>
        <source>Where the part hangs on the rest its joint keeps the take&apos;s mean and spread</source>
        <translation>部位連接之處的關節保留該鏡次的平均與離散</translation>
    </message>
    <message>
        <source>The</source>
        <translation>部位</translation>
    </message>
    <message>
        <source>By that of</source>
        <translation>改用</translation>
    </message>
    <message>
        <source>take or clip that lends the part</source>
        <translation>提供部位的鏡次或片段</translation>
    </message>
    <message>
        <source>The take, what lends the part, and the result</source>
        <translation>鏡次、部位的來源與結果</translation>
    </message>
    <message>
        <source>What becomes of it</source>
        <translation>結果如何</translation>
    </message>
    <message>
        <source>Keep as a take…</source>
        <translation>保留為鏡次…</translation>
    </message>
    <message>
        <source>The %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>First frame of the %1</source>
        <translation>%1的第一個影格</translation>
    </message>
    <message>
        <source>Last frame of the %1</source>
        <translation>%1的最後一個影格</translation>
    </message>
    <message>
        <source>%1, at %2 Hz</source>
        <translation>%1，%2 Hz</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>原樣</translation>
    </message>
    <message>
        <source>what lends the %1</source>
        <translation>%1的來源</translation>
    </message>
    <message>
        <source>the result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>%1 of the take&apos;s %2 are changed, in the %3 only; all else stays.</source>
        <translation>鏡次的 %2 中變更 %1，只限%3；其餘不變。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PartWords</name>
    <message>
        <source>left arm</source>
        <translation>左臂</translation>
    </message>
    <message>
        <source>right arm</source>
        <translation>右臂</translation>
    </message>
    <message>
        <source>left leg</source>
        <translation>左腿</translation>
    </message>
    <message>
        <source>right leg</source>
        <translation>右腿</translation>
    </message>
    <message>
        <source>trunk, head</source>
        <translation>軀幹、頭</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PoseBox</name>
    <message>
        <source>left hand</source>
        <translation>左手</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>右手</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>左腳</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>右腳</translation>
    </message>
    <message>
        <source>hips</source>
        <translation>髖部</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>胸部</translation>
    </message>
    <message>
        <source>head</source>
        <translation>頭部</translation>
    </message>
    <message>
        <source>even</source>
        <translation>等速</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>from rest</source>
        <translation>由靜止起</translation>
    </message>
    <message>
        <source>to rest</source>
        <translation>到靜止</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>停住</translation>
    </message>
    <message>
        <source>stays where it is</source>
        <translation>固定在原處</translation>
    </message>
    <message>
        <source>and later keys</source>
        <translation>以及之後的</translation>
    </message>
    <message>
        <source>The chosen key</source>
        <translation>所選的關鍵姿勢</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>控點</translation>
    </message>
    <message>
        <source>What is drawn: drag it in the 3D view, or give its place below</source>
        <translation>要拉動的部位：在 3D 檢視中拖曳，或在下方輸入位置</translation>
    </message>
    <message>
        <source>While another handle is drawn this one stays; Ctrl and a click on it does the same</source>
        <translation>拉動其他控點時此控點不動；按 Ctrl 並點它效果相同</translation>
    </message>
    <message>
        <source>Place, %1 in metres</source>
        <translation>位置，%1，公尺</translation>
    </message>
    <message>
        <source>%1, metres; y is up</source>
        <translation>%1，公尺；y 朝上</translation>
    </message>
    <message>
        <source>x y z, m</source>
        <translation>x y z，m</translation>
    </message>
    <message>
        <source>Way to the next key</source>
        <translation>到下一個關鍵姿勢的方式</translation>
    </message>
    <message>
        <source>How the way to the next key goes</source>
        <translation>如何過渡到下一個關鍵姿勢</translation>
    </message>
    <message>
        <source>Way on</source>
        <translation>後續方式</translation>
    </message>
    <message>
        <source>Frame of the key</source>
        <translation>關鍵姿勢的影格</translation>
    </message>
    <message>
        <source>Moves the key to that frame</source>
        <translation>將關鍵姿勢移到該影格</translation>
    </message>
    <message>
        <source>Later keys go as many frames along</source>
        <translation>之後的關鍵姿勢移動同樣的影格數</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>影格</translation>
    </message>
    <message>
        <source>Time from this key on, times</source>
        <translation>由此之後的時間倍數</translation>
    </message>
    <message>
        <source>All later keys that many times as far from this one: 2 is half as fast</source>
        <translation>之後所有關鍵姿勢與此的距離變為該倍數：2 為一半速度</translation>
    </message>
    <message>
        <source>Time on</source>
        <translation>之後時間</translation>
    </message>
    <message>
        <source>Frame %1. Drag hands, feet, hips, chest or head in the 3D view.</source>
        <translation>影格 %1。在 3D 檢視中拖曳手、腳、髖部、胸部或頭部。</translation>
    </message>
    <message>
        <source>Return makes a key.</source>
        <translation>Return 建立關鍵姿勢。</translation>
    </message>
    <message>
        <source>Choose a key to change its pose.</source>
        <translation>選擇關鍵姿勢以變更姿勢。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PoseDialog</name>
    <message>
        <source>Copy a pose</source>
        <translation>複製姿勢</translation>
    </message>
    <message>
        <source>Take or clip</source>
        <translation>鏡次或片段</translation>
    </message>
    <message>
        <source>Whose pose is copied: a fighter of a take, or a clip</source>
        <translation>複製誰的姿勢：鏡次中的選手或片段</translation>
    </message>
    <message>
        <source>The pose</source>
        <translation>姿勢</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Which moment; arrow keys go on by one frame</source>
        <translation>哪個時刻；方向鍵每次一個影格</translation>
    </message>
    <message>
        <source>Frame of the take or clip</source>
        <translation>鏡次或片段的影格</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Copy the pose</source>
        <translation>複製姿勢</translation>
    </message>
    <message>
        <source>frame %1 at %2 Hz</source>
        <translation>影格 %1，%2 Hz</translation>
    </message>
    <message>
        <source>Copy the pose of %1</source>
        <translation>複製%1的姿勢</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>偏好設定</translation>
    </message>
    <message>
        <source>General</source>
        <translation>一般</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按鍵</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>還原預設值</translation>
    </message>
    <message>
        <source>All values of the General page as the studio brings them.</source>
        <translation>將「一般」頁的所有值恢復為程式預設。</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>關閉此頁 (Esc)</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>外觀</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>依系統</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>淺色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>佈景主題</translation>
    </message>
    <message>
        <source>Colours of the whole window.</source>
        <translation>整個視窗的顏色。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>語言</translation>
    </message>
    <message>
        <source>Of all texts, numbers and dates in the window; files do not know it. The window is made anew at once, with what is open in it.</source>
        <translation>視窗中所有文字、數字與日期的語言；檔案不受影響。視窗會立即重新建立，並保留開啟的內容。</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Text size, percent</source>
        <translation>文字大小，百分比</translation>
    </message>
    <message>
        <source>How large all text is; pages that it makes too large can be scrolled.</source>
        <translation>所有文字的大小；因此過大的頁面可以捲動。</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>文字大小</translation>
    </message>
    <message>
        <source>Reduce motion</source>
        <translation>減少動態</translation>
    </message>
    <message>
        <source>Nothing begins to move by itself: questions and similar actions stand still until you play them.</source>
        <translation>不會有東西自行動起來：問題與相似動作會靜止，直到您播放。</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Playback speed of a bout that is opened, percent</source>
        <translation>開啟對打時的播放速度，百分比</translation>
    </message>
    <message>
        <source>How fast a bout plays when it is opened. While it is open, - and + change it.</source>
        <translation>對打開啟時的播放速度。開啟後可用 - 與 + 變更。</translation>
    </message>
    <message>
        <source>Speed at opening</source>
        <translation>開啟時的速度</translation>
    </message>
    <message>
        <source>Play in a loop</source>
        <translation>循環播放</translation>
    </message>
    <message>
        <source>Whether a bout loops when it is opened.</source>
        <translation>對打開啟時是否循環播放。</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> 影格</translation>
    </message>
    <message>
        <source>Frames of a leap</source>
        <translation>跳格的影格數</translation>
    </message>
    <message>
        <source>How far Shift+← and Shift+→ go.</source>
        <translation>Shift+← 與 Shift+→ 移動的距離。</translation>
    </message>
    <message>
        <source>Shift+← → goes</source>
        <translation>Shift+← → 移動</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>滑鼠</translation>
    </message>
    <message>
        <source>Mouse sensitivity in the 3D view, percent</source>
        <translation>3D 檢視中的滑鼠靈敏度，百分比</translation>
    </message>
    <message>
        <source>How fast a drag turns and the wheel zooms in the 3D view.</source>
        <translation>3D 檢視中拖曳旋轉與滾輪縮放的快慢。</translation>
    </message>
    <message>
        <source>Sensitivity in 3D</source>
        <translation>3D 靈敏度</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>安全</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Autosave interval in seconds</source>
        <translation>自動儲存間隔（秒）</translation>
    </message>
    <message>
        <source>After how long at most changes are kept for a recovery. The project file itself is written only when you save.</source>
        <translation>最多隔多久保留一次變更以供救回。專案檔案本身只在你儲存時寫入。</translation>
    </message>
    <message>
        <source>Autosave every</source>
        <translation>自動儲存間隔</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ProgressBox</name>
    <message>
        <source>Progress of labelling</source>
        <translation>標記進度</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>接下來做什麼</translation>
    </message>
    <message>
        <source>Keep what machine and rules propose where they are at least so sure; one step of the history (Ctrl+Return)</source>
        <translation>保留機器與規則至少有此把握的建議；在歷程中記為一步 (Ctrl+Return)</translation>
    </message>
    <message>
        <source>Labelled by hand, accepted, open</source>
        <translation>手動標記、已接受、未定</translation>
    </message>
    <message>
        <source>How sure the machine must be of what is accepted: 0.90 is nine of ten right. Ctrl+Down and Ctrl+Up move it.</source>
        <translation>機器要多有把握才接受：0.90 表示十個有九個對。Ctrl+↓ 與 Ctrl+↑ 可調整。</translation>
    </message>
    <message>
        <source>Least probability of what is accepted</source>
        <translation>接受的最低機率</translation>
    </message>
    <message>
        <source>Proposals that are at least so probable are accepted.</source>
        <translation>機率至少這麼高的建議會被接受。</translation>
    </message>
    <message>
        <source>%1 actions: %2 labelled by hand (dark), %3 accepted (light), %4 open</source>
        <translation>%1 個動作：%2 個手動標記（深），%3 個已接受（淺），%4 個未定</translation>
    </message>
    <message>
        <source>%1 labelled</source>
        <translation>已標記 %1</translation>
    </message>
    <message>
        <source>, expected accuracy %1</source>
        <translation>，預期正確率 %1</translation>
    </message>
    <message>
        <source>Accept rules</source>
        <translation>接受規則</translation>
    </message>
    <message>
        <source>Accept %1 sure</source>
        <translation>接受 %1 個</translation>
    </message>
    <message>
        <source>Accept the sure</source>
        <translation>接受有把握的</translation>
    </message>
    <message>
        <source>Every action is labelled. File &gt; Save keeps it; Label &gt; Write labels… makes a table.</source>
        <translation>所有動作都已標記。「檔案 &gt; 儲存」可保存；「標記 &gt; 寫出標籤…」可製成表格。</translation>
    </message>
    <message>
        <source>No recording is cut into actions yet.</source>
        <translation>尚無切成動作的錄製。</translation>
    </message>
    <message>
        <source>Label a few actions by hand; the machine proposes the others. N leads to the one that says most.</source>
        <translation>手動標記幾個動作；機器會建議其他的。N 前往最有幫助的一個。</translation>
    </message>
    <message>
        <source>Go on: N leads to the next one that says most.</source>
        <translation>繼續：N 前往下一個最有幫助的動作。</translation>
    </message>
    <message>
        <source>What rules say is left to be accepted.</source>
        <translation>規則的說法仍待接受。</translation>
    </message>
    <message>
        <source>Nothing of %1 was labelled so far: if there is any, show the machine one.</source>
        <translation>至今沒有標記過%1：若有，請讓機器看一個。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、 </translation>
    </message>
    <message>
        <source>Accept %1 guesses</source>
        <translation>接受 %1 個猜測</translation>
    </message>
    <message>
        <source>Every action has a label, but of ten that the machine gave only about %1 are right. N leads through those of which it was least sure; or undo the acceptance and answer more questions.</source>
        <translation>每個動作都有標籤，但機器給的十個中約只有 %1 個正確。按 N 逐一檢視最沒把握的；或復原接受並回答更多問題。</translation>
    </message>
    <message numerus="yes">
        <source>%n minima are still suspect. Half actions are hard to label: correct them in Segment first, or go on with N.</source>
        <translation>
            <numerusform>還有 %n 個可疑的極小點。半個動作難以標記：請先到分段修正，或按 N 繼續。</numerusform>
        </translation>
    </message>
    <message>
        <source>How many of the machine&apos;s answers should be right where no hand has spoken</source>
        <translation>未手動標記之處，機器答案預期正確的比例</translation>
    </message>
    <message>
        <source>More labels by hand will hardly help: accept the sure rest (%1), lower the bar for the others (%2), then look through the least sure (%3).</source>
        <translation>再手動標記也幫助不大：接受有把握的其餘（%1），其他的請降低門檻（%2），再檢視最沒把握的（%3）。</translation>
    </message>
    <message>
        <source>Go on: the next ones tell the machine most.</source>
        <translation>繼續：接下來的問題對機器最有幫助。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::QualityBox</name>
    <message>
        <source>Actions of the cell</source>
        <translation>格中的動作</translation>
    </message>
    <message>
        <source>Aspect of the confusion matrix</source>
        <translation>混淆矩陣的面向</translation>
    </message>
    <message>
        <source>Whose classes the matrix and the list are about.</source>
        <translation>矩陣與清單所顯示類別的面向。</translation>
    </message>
    <message>
        <source>What the cell says</source>
        <translation>此格的內容</translation>
    </message>
    <message>
        <source>Share of actions whose learnt aspects are all right. Expected: cross-validation over the hand labels as the session went. As asked and random: the hand labels are dealt into folds; one is held out, and from the others the machine learns more and more labels, in the order in which the queue asks for them and in random orders. Both are judged on the same held-out labels. What was asked for is harder than the rest, so the bout as a whole fares better.</source>
        <translation>所學面向全部正確的動作比例。預期：依工作過程對手動標籤做交叉驗證。依提問與隨機：手動標籤分成數份；保留一份，機器從其餘的學習越來越多標籤，順序依佇列提問或隨機。兩者都以同一份保留的標籤評判。被提問的比其餘的難，因此整場對打的表現會更好。</translation>
    </message>
    <message>
        <source>Judging</source>
        <translation>正在評判</translation>
    </message>
    <message>
        <source>Comparing orders</source>
        <translation>正在比較順序</translation>
    </message>
    <message>
        <source>How often machine and rules say the same as your hand appears here, once some actions are labelled by hand.</source>
        <translation>手動標記一些動作後，這裡會出現機器與規則和你說法相同的頻率。</translation>
    </message>
    <message>
        <source>No hand has said anything of this aspect.</source>
        <translation>此面向還沒有手動標記。</translation>
    </message>
    <message>
        <source>Rows by hand, columns %1. %2 of %3 right, F1 %4.</source>
        <translation>列為手動，欄為%1。%3 個中 %2 個正確，F1 %4。</translation>
    </message>
    <message>
        <source>by rule</source>
        <translation>依規則</translation>
    </message>
    <message>
        <source>by machine, unseen</source>
        <translation>依機器（未看過）</translation>
    </message>
    <message>
        <source>A click on a cell, or Enter, opens its actions.</source>
        <translation>按一下格子或 Enter 可開啟其中的動作。</translation>
    </message>
    <message>
        <source>No action is in this cell.</source>
        <translation>此格沒有動作。</translation>
    </message>
    <message>
        <source>%1 labels as asked do what %2 in random order do.</source>
        <translation>依提問的 %1 個標籤，效果等同隨機順序的 %2 個。</translation>
    </message>
    <message>
        <source>With %1 hand labels the order of the questions is compared with a random one.</source>
        <translation>有 %1 個手動標籤後，提問的順序會與隨機順序比較。</translation>
    </message>
    <message>
        <source>More labels will hardly help.</source>
        <translation>再多的標籤幫助不大。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Questions</name>
    <message>
        <source>%1: nobody is here to choose a file.</source>
        <translation>%1：沒有人可選擇檔案。</translation>
    </message>
    <message>
        <source>%1 Nobody is here to answer: %2.</source>
        <translation>%1 沒有人可回答：%2。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RecentButton</name>
    <message>
        <source>Open %1, %2</source>
        <translation>開啟 %1，%2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Recovery</name>
    <message>
        <source>Saving a copy</source>
        <translation>正在儲存副本</translation>
    </message>
    <message>
        <source>Recovery copies cannot be written. %1</source>
        <translation>無法寫入救援副本。%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RecoveryDialog</name>
    <message>
        <source>Recover</source>
        <translation>救回</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>捨棄</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>救回</translation>
    </message>
    <message>
        <source>Kumite ended unexpectedly. The edits that were not saved are kept here; recovered, they stand in the project as unsaved changes.</source>
        <translation>Kumite 意外結束。未儲存的編輯保留在這裡；救回後會成為專案中未儲存的變更。</translation>
    </message>
    <message>
        <source>Projects that can be recovered</source>
        <translation>可救回的專案</translation>
    </message>
    <message>
        <source>What was not saved; a double-click recovers it</source>
        <translation>未儲存的內容；按兩下即可救回</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>專案</translation>
    </message>
    <message>
        <source>Last edit</source>
        <translation>上次編輯</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>未儲存</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>資料夾</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>從未儲存</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>稍後</translation>
    </message>
    <message>
        <source>Delete the chosen edits for good (Del)</source>
        <translation>永久刪除所選的編輯 (Del)</translation>
    </message>
    <message>
        <source>Open the chosen project with its unsaved edits (Enter)</source>
        <translation>開啟所選專案及其未儲存的編輯 (Enter)</translation>
    </message>
    <message>
        <source>Keep them and ask again at the next start (Esc)</source>
        <translation>保留，並在下次啟動時再問 (Esc)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Review</name>
    <message numerus="yes">
        <source>What you decided clears %n more.</source>
        <translation>
            <numerusform>你的決定另外澄清了 %n 個。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n suspect(s) left.</source>
        <translation>
            <numerusform>還有 %n 個可疑點。</numerusform>
        </translation>
    </message>
    <message>
        <source>Every minimum of this take is decided.</source>
        <translation>此鏡次的每個極小值都已決定。</translation>
    </message>
    <message>
        <source>No suspect is left. N leads through the other minima.</source>
        <translation>沒有可疑點了。N 可逐一前往其他極小值。</translation>
    </message>
    <message>
        <source>No boundary is selected. N leads to the most suspicious minimum.</source>
        <translation>未選取邊界。N 前往最可疑的極小值。</translation>
    </message>
    <message>
        <source>No minimum is left to decide.</source>
        <translation>沒有待決定的極小值了。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RoleTable</name>
    <message>
        <source>read off the skeleton&apos;s shape</source>
        <translation>由骨架形狀判讀</translation>
    </message>
    <message>
        <source>no human body found</source>
        <translation>未找到人體</translation>
    </message>
    <message>
        <source>by %1 names</source>
        <translation>依 %1 的命名</translation>
    </message>
    <message>
        <source>Joints of the roles</source>
        <translation>角色的關節</translation>
    </message>
    <message>
        <source>Which joint of the recording is which part of the body</source>
        <translation>錄製中的關節各是身體的哪個部位</translation>
    </message>
    <message>
        <source>fighter 1</source>
        <translation>選手 1</translation>
    </message>
    <message>
        <source>fighter 2</source>
        <translation>選手 2</translation>
    </message>
    <message>
        <source>Fighter %1: %2 of %3 roles, %4.</source>
        <translation>選手 %1：%3 個角色中 %2 個，%4。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>無</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>set by hand</source>
        <translation>手動設定</translation>
    </message>
    <message>
        <source>found</source>
        <translation>求得</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>未找到</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RulesBox</name>
    <message>
        <source>Lands below</source>
        <translation>著地低於</translation>
    </message>
    <message>
        <source>Height below which a foot lands</source>
        <translation>腳著地的高度上限</translation>
    </message>
    <message>
        <source>A foot stands once its toes are lower than this above their rest height …</source>
        <translation>腳趾高出靜止高度不到此值 …</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>slower than</source>
        <translation>慢於</translation>
    </message>
    <message>
        <source>Speed below which a foot lands</source>
        <translation>腳著地的速度上限</translation>
    </message>
    <message>
        <source>… and slower than this.</source>
        <translation>… 且比此值慢時，腳算站定。</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Lifts above</source>
        <translation>離地高於</translation>
    </message>
    <message>
        <source>Height above which a foot lifts</source>
        <translation>腳離地的高度下限</translation>
    </message>
    <message>
        <source>It no longer stands once its toes are higher than this …</source>
        <translation>腳趾高於此值 …</translation>
    </message>
    <message>
        <source>faster than</source>
        <translation>快於</translation>
    </message>
    <message>
        <source>Speed above which a foot lifts</source>
        <translation>腳離地的速度下限</translation>
    </message>
    <message>
        <source>… or faster than this.</source>
        <translation>… 或快於此值時，就不再算站定。</translation>
    </message>
    <message>
        <source>Stands for</source>
        <translation>站定時間</translation>
    </message>
    <message>
        <source>Shortest stance</source>
        <translation>最短站定時間</translation>
    </message>
    <message>
        <source>A stance that is shorter does not count.</source>
        <translation>比這更短的站定不計。</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Closes at</source>
        <translation>逼近速度</translation>
    </message>
    <message>
        <source>Speed at which an attack must close</source>
        <translation>攻擊逼近所需的速度</translation>
    </message>
    <message>
        <source>An attack counts for the react rule if its fist or foot closes on the trunk or head faster than this at some moment.</source>
        <translation>攻擊的拳或腳在某一刻逼近軀幹或頭部的速度超過此值，反應規則才會計入。</translation>
    </message>
    <message>
        <source>Usual thresholds</source>
        <translation>一般門檻</translation>
    </message>
    <message>
        <source>Back to the thresholds that the studio brings</source>
        <translation>恢復為程式預設的門檻</translation>
    </message>
    <message>
        <source>What the thresholds change</source>
        <translation>門檻造成的改變</translation>
    </message>
    <message>
        <source>Why the rules say so</source>
        <translation>規則的理由</translation>
    </message>
    <message>
        <source>%1: no action</source>
        <translation>%1：沒有動作</translation>
    </message>
    <message>
        <source>%1: %2 of %3 actions</source>
        <translation>%1：%3 個動作中 %2 個</translation>
    </message>
    <message>
        <source>How many actions get another label stands here while a threshold is changed.</source>
        <translation>變更門檻時，這裡會顯示有多少動作的標籤會改變。</translation>
    </message>
    <message>
        <source>Changed: %1.</source>
        <translation>已變更：%1。</translation>
    </message>
    <message>
        <source>React: %1</source>
        <translation>反應：%1</translation>
    </message>
    <message>
        <source>Move: %1</source>
        <translation>移動：%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SegmentPanel</name>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Suspect minima</source>
        <translation>可疑的極小值</translation>
    </message>
    <message>
        <source>Minima of the force curves that cut actions appear here, the most suspicious first. Lower the prominence below to see more.</source>
        <translation>切割動作的力曲線極小值會出現在這裡，最可疑的在前。降低下方的突出度可看到更多。</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>檢查</translation>
    </message>
    <message>
        <source>Detection</source>
        <translation>偵測</translation>
    </message>
    <message>
        <source>Why the minimum is suspected</source>
        <translation>極小值可疑的原因</translation>
    </message>
    <message>
        <source>It is a boundary: no suspect any more; goes on to the next</source>
        <translation>這是邊界：不再可疑；接著到下一個</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>還原</translation>
    </message>
    <message>
        <source>A boundary that a hand has set.</source>
        <translation>手動設定的邊界。</translation>
    </message>
    <message>
        <source>No suspect is left. %1 leads through the others.</source>
        <translation>沒有可疑點了。%1 可逐一前往其他的。</translation>
    </message>
    <message>
        <source>Bring the boundary back</source>
        <translation>恢復邊界</translation>
    </message>
    <message>
        <source>It is spurious; goes on to the next</source>
        <translation>這是假的；接著到下一個</translation>
    </message>
    <message>
        <source>%1 leads to the most suspicious minimum. Remove it where the body hardly dips: a kick down and up again is one action. Keep it where one ends and another begins.</source>
        <translation>%1 前往最可疑的極小值。身體幾乎沒有下沉處請移除：踢腿放下又抬起是同一個動作。一個動作結束、另一個開始之處請保留。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceBar</name>
    <message>
        <source>Time of the sequence</source>
        <translation>序列的時間</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>/ %1</translation>
    </message>
    <message>
        <source>the chosen action, %1 s; Esc: back to the sequence</source>
        <translation>所選動作，%1 s；Esc：回到序列</translation>
    </message>
    <message>
        <source>live: 1 … 9 play blocks at once</source>
        <translation>即時：1 … 9 立即播放區塊</translation>
    </message>
    <message>
        <source> · last %1, cost %2</source>
        <translation> · 上次%1，成本 %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceCommands</name>
    <message>
        <source>Se&amp;quence</source>
        <translation>序列(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>播放或暫停(&amp;P)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>後退一影格</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>前進一影格</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>到開頭</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>到結尾</translation>
    </message>
    <message>
        <source>Play it &amp;over and over</source>
        <translation>反覆播放(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Live: keys play blocks at once</source>
        <translation>即時：按鍵立即播放區塊(&amp;L)</translation>
    </message>
    <message>
        <source>Live: block %1</source>
        <translation>即時：區塊 %1</translation>
    </message>
    <message>
        <source>Back to the sequence</source>
        <translation>回到序列</translation>
    </message>
    <message>
        <source>The playhead is not inside the chosen block.</source>
        <translation>播放頭不在所選區塊內。</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>修剪%1</translation>
    </message>
    <message>
        <source>&amp;Add the chosen action</source>
        <translation>加入所選動作(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;wap the block for the chosen action</source>
        <translation>以所選動作取代區塊(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Remove the block</source>
        <translation>移除區塊(&amp;R)</translation>
    </message>
    <message>
        <source>Block before</source>
        <translation>前一個區塊</translation>
    </message>
    <message>
        <source>Block after</source>
        <translation>後一個區塊</translation>
    </message>
    <message>
        <source>Move the block &amp;earlier</source>
        <translation>區塊前移(&amp;E)</translation>
    </message>
    <message>
        <source>Move the &amp;block later</source>
        <translation>區塊後移(&amp;B)</translation>
    </message>
    <message>
        <source>Once &amp;more</source>
        <translation>多播一次(&amp;M)</translation>
    </message>
    <message>
        <source>Repeat the block</source>
        <translation>重複區塊</translation>
    </message>
    <message>
        <source>Once less</source>
        <translation>少播一次</translation>
    </message>
    <message>
        <source>Repeat the block less</source>
        <translation>減少重複區塊</translation>
    </message>
    <message>
        <source>Block begins at the playhead</source>
        <translation>區塊從播放頭開始</translation>
    </message>
    <message>
        <source>Block ends at the playhead</source>
        <translation>區塊在播放頭結束</translation>
    </message>
    <message>
        <source>The whole action again</source>
        <translation>恢復整個動作</translation>
    </message>
    <message>
        <source>Trim nothing</source>
        <translation>不修剪</translation>
    </message>
    <message>
        <source>&amp;Draw the transition anew</source>
        <translation>重新抽選轉換(&amp;D)</translation>
    </message>
    <message>
        <source>Draw all that are not locked anew</source>
        <translation>重新抽選所有未鎖定的</translation>
    </message>
    <message>
        <source>Loc&amp;k the transition, or let it go</source>
        <translation>鎖定或放開轉換(&amp;K)</translation>
    </message>
    <message>
        <source>Unlock the transition</source>
        <translation>解鎖轉換</translation>
    </message>
    <message>
        <source>Lock the transition</source>
        <translation>鎖定轉換</translation>
    </message>
    <message>
        <source>Clear the sequence</source>
        <translation>清空序列</translation>
    </message>
    <message>
        <source>&amp;Find an action</source>
        <translation>尋找動作(&amp;F)</translation>
    </message>
    <message>
        <source>Show all of it</source>
        <translation>顯示全部內容</translation>
    </message>
    <message>
        <source>Map of po&amp;ses</source>
        <translation>姿勢地圖(&amp;G)</translation>
    </message>
    <message>
        <source>Add &amp;clips of files…</source>
        <translation>加入檔案的片段(&amp;C)…</translation>
    </message>
    <message>
        <source>Add cl&amp;ips of a folder…</source>
        <translation>加入資料夾的片段(&amp;H)…</translation>
    </message>
    <message>
        <source>Keep as a &amp;take…</source>
        <translation>存為鏡次(&amp;T)…</translation>
    </message>
    <message>
        <source>E&amp;xport the sequence…</source>
        <translation>匯出序列(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequencePanel</name>
    <message>
        <source>What appears here</source>
        <translation>這裡會出現什麼</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜尋</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>搜尋動作</translation>
    </message>
    <message>
        <source>Shows the actions in which every word appears: right kick</source>
        <translation>顯示含有每個字詞的動作，例如：右踢</translation>
    </message>
    <message>
        <source>Actions to choose from</source>
        <translation>可選擇的動作</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>片段…</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>保留…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>匯出…</translation>
    </message>
    <message>
        <source>Actions of the takes, and clips of other files, in any order, led over to each other: they appear here.</source>
        <translation>鏡次的動作與其他檔案的片段，以任意順序彼此銜接：會出現在這裡。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceSession</name>
    <message>
        <source>Preparing the clips</source>
        <translation>正在準備片段</translation>
    </message>
    <message>
        <source>Making the motion</source>
        <translation>正在製作動態</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>加入%1</translation>
    </message>
    <message>
        <source>Swap for %1</source>
        <translation>換成%1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除%1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移動%1</translation>
    </message>
    <message>
        <source>Clear the sequence</source>
        <translation>清空序列</translation>
    </message>
    <message>
        <source>Draw the transition anew</source>
        <translation>重新抽選轉換</translation>
    </message>
    <message>
        <source>Draw all anew</source>
        <translation>全部重新抽選</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceStrip</name>
    <message>
        <source>Blocks of the sequence</source>
        <translation>序列的區塊</translation>
    </message>
    <message>
        <source>  (%1 of %2)</source>
        <translation>  （%1 / %2）</translation>
    </message>
    <message>
        <source>Actions in the order in which they shall be played. Choose one at the right and press Return to add it.</source>
        <translation>依播放順序排列的動作。在右側選一個，按 Return 加入。</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>正在製作動態。</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>修剪%1</translation>
    </message>
    <message>
        <source>Drag to trim</source>
        <translation>拖曳以修剪</translation>
    </message>
    <message>
        <source>transition to %1 · %2 to %3</source>
        <translation>轉換到%1 · %2 至 %3</translation>
    </message>
    <message>
        <source>%1 · %2 to %3</source>
        <translation>%1 · %2 至 %3</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Session</name>
    <message>
        <source>The edit that waited was dropped: another take is shown.</source>
        <translation>等待中的編輯已捨棄：目前顯示的是另一個鏡次。</translation>
    </message>
    <message>
        <source>The edit waits until the force curves are computed.</source>
        <translation>編輯會等到力曲線算完。</translation>
    </message>
    <message>
        <source>No boundary of %1 lies within 0.1 s of the playhead.</source>
        <translation>播放頭 0.1 s 內沒有 %1 的邊界。</translation>
    </message>
    <message>
        <source>This is the first action: nothing comes before it.</source>
        <translation>這是第一個動作：前面沒有其他動作。</translation>
    </message>
    <message>
        <source>This is the last action: nothing comes after it.</source>
        <translation>這是最後一個動作：後面沒有其他動作。</translation>
    </message>
    <message>
        <source>A removed boundary does not move. Del restores it.</source>
        <translation>已移除的邊界無法移動。Del 可還原。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SettingsFields</name>
    <message>
        <source>Cutoff of the low-pass in Hz</source>
        <translation>低通濾波的截止頻率（Hz）</translation>
    </message>
    <message>
        <source>Low-pass over the centre of mass: lower gives smoother curves and fewer minima.</source>
        <translation>對質心的低通濾波：越低曲線越平滑，極小值越少。</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>Least prominence in body weights</source>
        <translation>最小突出度（體重倍數）</translation>
    </message>
    <message>
        <source>A minimum must be at least this deep to be a boundary.</source>
        <translation>極小值至少要這麼深才算邊界。</translation>
    </message>
    <message>
        <source> BW</source>
        <translation> BW</translation>
    </message>
    <message>
        <source>Cutoff</source>
        <translation>截止頻率</translation>
    </message>
    <message>
        <source>Promin.</source>
        <translation>突出度</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>length of the force</source>
        <translation>力的大小</translation>
    </message>
    <message>
        <source>vertical part</source>
        <translation>垂直分量</translation>
    </message>
    <message>
        <source>Curve that is cut at its minima</source>
        <translation>依其極小值切割的曲線</translation>
    </message>
    <message>
        <source>Which curve is cut at its minima: the length of the contact force or its vertical part.</source>
        <translation>依哪條曲線的極小值切割：接觸力的大小或其垂直分量。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SimilarBox</name>
    <message>
        <source>this one, %1</source>
        <translation>此動作，%1</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>已接受</translation>
    </message>
    <message>
        <source>%1, %2%3</source>
        <translation>%1，%2%3</translation>
    </message>
    <message>
        <source> ⇄</source>
        <translation> ⇄</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>雙方</translation>
    </message>
    <message>
        <source>Nearest by the numbers from which the machine learns; ⇄: its mirror image is near, and it is seen from the other side. All begin and end together.</source>
        <translation>依機器學習所用的數值最接近者；⇄：鏡像相近，並從另一側顯示。全部同時開始與結束。</translation>
    </message>
    <message>
        <source>The chosen ones get the label of the first one, said by a hand, as one step of the history. A click or Space chooses, a double click or Enter goes there.</source>
        <translation>所選的動作會得到第一個動作的標籤，視為手動標記，在歷程中記為一步。按一下或空白鍵選取，按兩下或 Enter 前往。</translation>
    </message>
    <message>
        <source>Show both fighters: the opponent, too</source>
        <translation>顯示雙方選手：也包括對手</translation>
    </message>
    <message>
        <source>Comparing actions</source>
        <translation>正在比較動作</translation>
    </message>
    <message>
        <source>The actions most like the current one.</source>
        <translation>與目前動作最相似的動作。</translation>
    </message>
    <message>
        <source>The actions most like the current one appear here, once there is an action at the playhead.</source>
        <translation>播放頭處有動作時，與目前動作最相似的動作會出現在這裡。</translation>
    </message>
    <message>
        <source>Same label for all</source>
        <translation>全部套用相同標籤</translation>
    </message>
    <message>
        <source>Same label for %1</source>
        <translation>%1 個套用相同標籤</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageCommands</name>
    <message>
        <source>Save a picture of the 3D view</source>
        <translation>儲存 3D 檢視的圖片</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>圖片 (*.png)</translation>
    </message>
    <message>
        <source>Picture of the 3D view</source>
        <translation>3D 檢視的圖片</translation>
    </message>
    <message>
        <source>%1: the picture cannot be written there.</source>
        <translation>%1：圖片無法寫入該處。</translation>
    </message>
    <message>
        <source>3&amp;D view</source>
        <translation>3D 檢視(&amp;D)</translation>
    </message>
    <message>
        <source>From the f&amp;ront</source>
        <translation>正面(&amp;R)</translation>
    </message>
    <message>
        <source>From the &amp;side</source>
        <translation>側面(&amp;S)</translation>
    </message>
    <message>
        <source>From a&amp;bove</source>
        <translation>俯視(&amp;B)</translation>
    </message>
    <message>
        <source>Over the shoulder of fighter 1</source>
        <translation>選手 1 的肩後</translation>
    </message>
    <message>
        <source>Over the shoulder of fighter 2</source>
        <translation>選手 2 的肩後</translation>
    </message>
    <message>
        <source>&amp;Follow the fighters</source>
        <translation>跟隨選手(&amp;F)</translation>
    </message>
    <message>
        <source>Foot &amp;contacts</source>
        <translation>足部接觸(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Trails of hands and feet</source>
        <translation>手腳軌跡(&amp;T)</translation>
    </message>
    <message>
        <source>Centre of &amp;mass</source>
        <translation>質心(&amp;M)</translation>
    </message>
    <message>
        <source>Contact f&amp;orce</source>
        <translation>接觸力(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Ghosts</source>
        <translation>殘影(&amp;G)</translation>
    </message>
    <message>
        <source>Longer trails</source>
        <translation>加長軌跡</translation>
    </message>
    <message>
        <source>Shorter trails</source>
        <translation>縮短軌跡</translation>
    </message>
    <message>
        <source>&amp;Leave a ghost here</source>
        <translation>在此留下殘影(&amp;L)</translation>
    </message>
    <message>
        <source>Remove all ghosts</source>
        <translation>移除所有殘影</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>測量(&amp;A)</translation>
    </message>
    <message>
        <source>Measure: next joint</source>
        <translation>測量：下一個關節</translation>
    </message>
    <message>
        <source>Measure: joint before</source>
        <translation>測量：上一個關節</translation>
    </message>
    <message>
        <source>Measure from, then to this joint</source>
        <translation>先從、再量到此關節</translation>
    </message>
    <message>
        <source>Leave measuring</source>
        <translation>離開測量</translation>
    </message>
    <message>
        <source>Co&amp;py a picture</source>
        <translation>複製圖片(&amp;P)</translation>
    </message>
    <message>
        <source>Save a p&amp;icture…</source>
        <translation>儲存圖片(&amp;I)…</translation>
    </message>
    <message>
        <source>Click two joints; or %1 and %2 lead to a joint, %3 takes it</source>
        <translation>點選兩個關節；或用 %1 與 %2 前往關節，%3 選取</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageTools</name>
    <message>
        <source>Camera</source>
        <translation>攝影機</translation>
    </message>
    <message>
        <source>Where the camera stands</source>
        <translation>攝影機的位置</translation>
    </message>
    <message>
        <source>Shown in 3D</source>
        <translation>在 3D 中顯示</translation>
    </message>
    <message>
        <source>What the 3D view shows</source>
        <translation>3D 檢視顯示的內容</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>測量</translation>
    </message>
    <message>
        <source>Trails, frames</source>
        <translation>軌跡，影格</translation>
    </message>
    <message>
        <source>Frames of trail before the shown one</source>
        <translation>目前影格之前的軌跡影格數</translation>
    </message>
    <message>
        <source>Frames of trail after the shown one</source>
        <translation>目前影格之後的軌跡影格數</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageView</name>
    <message>
        <source>3D view</source>
        <translation>3D 檢視</translation>
    </message>
    <message>
        <source>The fighters at the playhead: a drag turns, the wheel zooms</source>
        <translation>播放頭處的選手：拖曳旋轉，滾輪縮放</translation>
    </message>
    <message>
        <source>before the action</source>
        <translation>動作之前</translation>
    </message>
    <message>
        <source>after the action</source>
        <translation>動作之後</translation>
    </message>
    <message>
        <source>grid 1 m</source>
        <translation>格線 1 m</translation>
    </message>
    <message>
        <source>   ·   left limbs lighter</source>
        <translation>   ·   左側肢體較淺</translation>
    </message>
    <message>
        <source>   ·   arrow: contact force, 0.5 m per BW</source>
        <translation>   ·   箭頭：接觸力，每 BW 0.5 m</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1   %2 m/s</source>
        <translation>%1   %2 m/s</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1，從 %2 到 %3</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1，從 %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>從 %1</translation>
    </message>
    <message>
        <source>No joint is chosen. %1</source>
        <translation>未選擇關節。%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StatisticsBox</name>
    <message>
        <source>actions</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Actions that the stream is cut into</source>
        <translation>將連續動態切成的動作</translation>
    </message>
    <message>
        <source>min/s</source>
        <translation>極小/s</translation>
    </message>
    <message>
        <source>Minima a second that cut by themselves</source>
        <translation>每秒自行切割的極小值數</translation>
    </message>
    <message>
        <source>corr.</source>
        <translation>修正</translation>
    </message>
    <message>
        <source>Share of boundaries that a hand removed, moved or added</source>
        <translation>經手動移除、移動或加入的邊界比例</translation>
    </message>
    <message>
        <source>left</source>
        <translation>待審</translation>
    </message>
    <message>
        <source>Suspects that nobody has decided yet. Every decision teaches what is suspect, so that others may be cleared, too</source>
        <translation>尚未有人決定的可疑點。每個決定都會教導何謂可疑，因此其他的也可能隨之澄清</translation>
    </message>
    <message>
        <source>take</source>
        <translation>鏡次</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SurpriseStrip</name>
    <message>
        <source>Surprise of the transitions</source>
        <translation>轉換的意外度</translation>
    </message>
    <message>
        <source>Both terms</source>
        <translation>兩項</translation>
    </message>
    <message>
        <source>−log P(next | own, opponent, motion): seen how it moves, another label was likelier. Finds labels that are wrong.</source>
        <translation>−log P(下一個 | 自己, 對手, 動態)：看過其動態後，另一個標籤更有可能。找出錯誤的標籤。</translation>
    </message>
    <message>
        <source>Label term alone</source>
        <translation>僅標籤項</translation>
    </message>
    <message>
        <source>−log P(next | own, opponent): a label that seldom follows. Finds rare decisions.</source>
        <translation>−log P(下一個 | 自己, 對手)：很少接續的標籤。找出罕見的決定。</translation>
    </message>
    <message>
        <source>Geometry term alone</source>
        <translation>僅幾何項</translation>
    </message>
    <message>
        <source>−log density of places, facing and poses under the label, from its mean: no probability. Finds odd poses and places.</source>
        <translation>−log 該標籤下位置、朝向與姿勢的密度，相對於平均值：不是機率。找出異常的姿勢與位置。</translation>
    </message>
    <message>
        <source>How unexpected each transition was to a model that had not seen it, in nats.
%1</source>
        <translation>每個轉換對沒看過它的模型而言有多出乎意料，單位 nat。
%1</translation>
    </message>
    <message>
        <source>Which surprise is shown</source>
        <translation>顯示哪種意外度</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>意外度</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 → %4 while %5   ·   %6</source>
        <translation>%1 · %2 · %3 → %4，同時 %5   ·   %6</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SuspectsModel</name>
    <message>
        <source>, removed</source>
        <translation>，已移除</translation>
    </message>
    <message>
        <source>, accepted</source>
        <translation>，已接受</translation>
    </message>
    <message>
        <source>, set by hand</source>
        <translation>，手動設定</translation>
    </message>
    <message>
        <source>%1, suspicion %2: %3</source>
        <translation>%1，可疑度 %2：%3</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>What speaks against the minimum, and how deep it is</source>
        <translation>不利於該極小值的理由，以及它的深度</translation>
    </message>
    <message>
        <source>How likely the minimum is spurious, learnt from what hands removed and accepted; ✓ accepted or set by hand, × removed</source>
        <translation>極小值為假的可能性，學自手動移除與接受的結果；✓ 已接受或手動設定，× 已移除</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>susp.</source>
        <translation>可疑度</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TakesList</name>
    <message>
        <source>%1
Double-click or F2 renames, Alt+↑ ↓ or a drag moves it.</source>
        <translation>%1
按兩下或 F2 重新命名，Alt+↑ ↓ 或拖曳可移動。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TimelineView</name>
    <message>
        <source>time, frame</source>
        <translation>時間、影格</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>影格</translation>
    </message>
    <message>
        <source>Release to move the boundary here, Esc to leave it, Ctrl or Alt to place it freely.</source>
        <translation>放開將邊界移到此處，Esc 取消，Ctrl 或 Alt 自由放置。</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>時間軸</translation>
    </message>
    <message>
        <source>Force curves of the fighters, the boundaries that cut them, and the actions between</source>
        <translation>選手的力曲線、切割曲線的邊界，以及其間的動作</translation>
    </message>
    <message>
        <source>Preparing curves</source>
        <translation>正在準備曲線</translation>
    </message>
    <message>
        <source>%1 · frame %2</source>
        <translation>%1 · 影格 %2</translation>
    </message>
    <message>
        <source>%1 · %2 · frame %3</source>
        <translation>%1 · %2 · 影格 %3</translation>
    </message>
    <message>
        <source> · action %1</source>
        <translation> · 動作 %1</translation>
    </message>
    <message>
        <source> · note: %1</source>
        <translation> · 註記：%1</translation>
    </message>
    <message>
        <source> · removed boundary</source>
        <translation> · 已移除的邊界</translation>
    </message>
    <message>
        <source> · accepted boundary</source>
        <translation> · 已接受的邊界</translation>
    </message>
    <message>
        <source> · moved boundary</source>
        <translation> · 已移動的邊界</translation>
    </message>
    <message>
        <source> · added boundary</source>
        <translation> · 已加入的邊界</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Tour</name>
    <message>
        <source>&amp;Tour on the demo bout</source>
        <translation>示範對打導覽(&amp;T)</translation>
    </message>
    <message>
        <source>Tour: next step</source>
        <translation>導覽：下一步</translation>
    </message>
    <message>
        <source>Tour: step before</source>
        <translation>導覽：上一步</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>離開導覽</translation>
    </message>
    <message>
        <source>Correct a suspect</source>
        <translation>修正可疑點</translation>
    </message>
    <message>
        <source>Label an action</source>
        <translation>標記動作</translation>
    </message>
    <message>
        <source>%1 leads to the action that says most; it loops. Say what it is: %2 is a left punch forward, %3 a right one; the palette shows the other keys.</source>
        <translation>%1 前往最有幫助的動作，並循環播放。說明它是什麼：%2 是左拳向前，%3 是右拳；面板會顯示其他按鍵。</translation>
    </message>
    <message>
        <source>Let the machine say the rest</source>
        <translation>其餘讓機器標記</translation>
    </message>
    <message>
        <source>A machine learns from your labels. One is few: here a third of the bout can be labelled for you. Then %1 accepts all that the machine is sure of; %2 takes it back.</source>
        <translation>機器從你的標籤學習。一個太少：這裡可以替你標記三分之一的對打。接著 %1 接受機器有把握的全部；%2 可復原。</translation>
    </message>
    <message>
        <source>Label a third for me</source>
        <translation>替我標記三分之一</translation>
    </message>
    <message>
        <source>See what follows what</source>
        <translation>看看什麼接在什麼之後</translation>
    </message>
    <message>
        <source>A row is what goes on, a column what comes next. Click a cell: the moments behind it are listed, a click plays one. %1 leads to the most surprising moment.</source>
        <translation>列是正在進行的，欄是接下來的。點選格子：背後的片刻會列出，按一下播放。%1 前往最意外的片刻。</translation>
    </message>
    <message>
        <source>Let them fight on</source>
        <translation>讓他們繼續對打</translation>
    </message>
    <message>
        <source>%1 starts a bout that was never fought, made from what was learnt. Every choice stands at the right; a click takes another one. Back with %2, on otherwise with %3.</source>
        <translation>%1 開始一場從未發生過的對打，由所學內容產生。每個選擇都列在右側；按一下改選另一個。%2 後退，%3 換個走向繼續。</translation>
    </message>
    <message>
        <source>The minima of the force cut the bout into actions; a few are wrong. %1 leads to the likeliest, plays it and says why; %2 stops. %3 keeps it, %4 removes it.</source>
        <translation>力的極小值將對打切成動作；少數是錯的。%1 前往最可能有錯的，播放並說明原因；%2 停止。%3 保留，%4 移除。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TourBox</name>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ 完成</translation>
    </message>
    <message>
        <source>This step is done</source>
        <translation>此步驟已完成</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>離開</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 / %2：%3</translation>
    </message>
    <message>
        <source>Tour, step %1</source>
        <translation>導覽，步驟 %1</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TraceBox</name>
    <message>
        <source>Behind it</source>
        <translation>背後的片刻</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>選取的項目</translation>
    </message>
    <message>
        <source>Transitions behind it</source>
        <translation>背後的轉換</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>意外度</translation>
    </message>
    <message>
        <source>Choose a cell, a node, an edge or a row above: the moments behind it appear here, and a click plays them.</source>
        <translation>在上方選擇格子、節點、邊或列：背後的片刻會出現在這裡，按一下即播放。</translation>
    </message>
    <message>
        <source>%1. Never seen.</source>
        <translation>%1。從未見過。</translation>
    </message>
    <message>
        <source>%1. Seen once.</source>
        <translation>%1。見過一次。</translation>
    </message>
    <message>
        <source>%1. Seen %2 times.</source>
        <translation>%1。見過 %2 次。</translation>
    </message>
    <message>
        <source>%1. Never seen so; these share the own label.</source>
        <translation>%1。未曾這樣見過；以下自己的標籤相同。</translation>
    </message>
    <message>
        <source>%1. Never seen so; these share the opponent&apos;s label.</source>
        <translation>%1。未曾這樣見過；以下對手的標籤相同。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TraceModel</name>
    <message>
        <source>%1 → %2 | %3</source>
        <translation>%1 → %2 | %3</translation>
    </message>
    <message>
        <source>%1, %2: %3
%4
A click plays it</source>
        <translation>%1，%2：%3
%4
按一下播放</translation>
    </message>
    <message>
        <source>Surprise (%1), nats: how unexpected it was to a model that had not seen it</source>
        <translation>意外度（%1），nat：對沒看過它的模型而言有多出乎意料</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>own → next</source>
        <translation>自己 → 下一個</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>意外度</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TrackPainter</name>
    <message>
        <source>The recording of %1 is missing. File ▸ Find recording… points to it.</source>
        <translation>%1 的錄製檔遺失。用「檔案 ▸ 尋找錄製檔…」指定位置。</translation>
    </message>
    <message>
        <source>No contact force: this skeleton has no body that is known here. S adds boundaries by hand.</source>
        <translation>沒有接觸力：此骨架沒有程式認得的身體。S 可手動加入邊界。</translation>
    </message>
    <message>
        <source>force, BW</source>
        <translation>力，BW</translation>
    </message>
    <message>
        <source>unsmoothed</source>
        <translation>未平滑</translation>
    </message>
    <message>
        <source>COM, m</source>
        <translation>質心，m</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>hands, m/s</source>
        <translation>手，m/s</translation>
    </message>
    <message>
        <source>feet, m/s</source>
        <translation>腳，m/s</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TransitionBox</name>
    <message>
        <source>Transition</source>
        <translation>轉換</translation>
    </message>
    <message>
        <source>The transition</source>
        <translation>此轉換</translation>
    </message>
    <message>
        <source>Ways that the transition can go</source>
        <translation>轉換可走的路徑</translation>
    </message>
    <message>
        <source>A click, or Return, takes another way</source>
        <translation>按一下或 Return 改走另一條路徑</translation>
    </message>
    <message>
        <source>Choose a block, or the transition before it.</source>
        <translation>選擇區塊，或其前的轉換。</translation>
    </message>
    <message>
        <source>The first block begins where it was recorded.</source>
        <translation>第一個區塊從錄製之處開始。</translation>
    </message>
    <message>
        <source>There is no transition.</source>
        <translation>沒有轉換。</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>正在製作動態。</translation>
    </message>
    <message>
        <source>straight from pose to pose</source>
        <translation>姿勢間直線相連</translation>
    </message>
    <message>
        <source>on a curve</source>
        <translation>沿曲線</translation>
    </message>
    <message>
        <source>along recorded clips past %1 poses</source>
        <translation>沿錄製片段，經過 %1 個姿勢</translation>
    </message>
    <message>
        <source>between poses that are alike</source>
        <translation>在相似的姿勢之間</translation>
    </message>
    <message>
        <source>To %1: %2 s, %3%4</source>
        <translation>到%1：%2 s，%3%4</translation>
    </message>
    <message>
        <source>. Locked.</source>
        <translation>。已鎖定。</translation>
    </message>
    <message>
        <source>drawn by cost</source>
        <translation>依成本抽選</translation>
    </message>
    <message>
        <source>path %1 · they meet as they are</source>
        <translation>路徑 %1 · 直接相接</translation>
    </message>
    <message>
        <source>path %1 · cost %2 · clips: %3</source>
        <translation>路徑 %1 · 成本 %2 · 片段：%3</translation>
    </message>
    <message>
        <source>curve (Bézier)</source>
        <translation>曲線（Bézier）</translation>
    </message>
    <message>
        <source>straight, for comparison</source>
        <translation>直線，供比較</translation>
    </message>
    <message>
        <source>Take another transition</source>
        <translation>改用另一個轉換</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TransportBar</name>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>影格 %1</translation>
    </message>
    <message>
        <source>Playback speed: - slower, + faster</source>
        <translation>播放速度：- 放慢，+ 加快</translation>
    </message>
    <message>
        <source>Rows ▾</source>
        <translation>列 ▾</translation>
    </message>
    <message>
        <source>Rows of the timeline</source>
        <translation>時間軸的列</translation>
    </message>
    <message>
        <source>What the timeline shows: curves, speeds, units of the ruler</source>
        <translation>時間軸顯示的內容：曲線、速度、尺規單位</translation>
    </message>
    <message>
        <source>selected: boundary of %1 at %2</source>
        <translation>已選取：%1 在 %2 的邊界</translation>
    </message>
    <message>
        <source>selected: action of %1, %2 to %3</source>
        <translation>已選取：%1 的動作，%2 至 %3</translation>
    </message>
    <message>
        <source>active: %1</source>
        <translation>目前：%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::UnmatchedBox</name>
    <message>
        <source>Put boundary</source>
        <translation>設置邊界</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>捨棄</translation>
    </message>
    <message>
        <source>Corrections without a minimum</source>
        <translation>沒有極小值的修正</translation>
    </message>
    <message>
        <source>With the present settings these corrections mean nothing any more.</source>
        <translation>在目前的設定下，這些修正已無意義。</translation>
    </message>
    <message>
        <source>Put a boundary by hand where the correction had one</source>
        <translation>在修正原本的位置手動設置邊界</translation>
    </message>
    <message>
        <source>Drop the correction from the project</source>
        <translation>將此修正從專案中捨棄</translation>
    </message>
</context>
<context>
    <name>kumite::studio::VersionsDialog</name>
    <message>
        <source>Restore</source>
        <translation>還原</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>開啟副本</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Versions, the newest first</source>
        <translation>版本，最新的在前</translation>
    </message>
    <message>
        <source>States that were saved over; a double-click restores one</source>
        <translation>被覆寫的狀態；按兩下即可還原</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>儲存時間</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>鏡次</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>修正</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>關閉</translation>
    </message>
    <message>
        <source>Open the chosen version as a project without a file</source>
        <translation>將所選版本開啟為沒有檔案的專案</translation>
    </message>
    <message>
        <source>Make the chosen version the open project; undo takes it back (Enter)</source>
        <translation>以所選版本作為開啟的專案；可以復原 (Enter)</translation>
    </message>
    <message>
        <source>Leave everything as it is (Esc)</source>
        <translation>一切維持原樣 (Esc)</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>正在尋找…</translation>
    </message>
    <message>
        <source>Reading versions</source>
        <translation>正在讀取版本</translation>
    </message>
    <message>
        <source>No earlier version yet. Every save keeps what the file held before; the last ten are listed here.</source>
        <translation>尚無先前版本。每次儲存都會保留檔案先前的內容；最近十個列在這裡。</translation>
    </message>
    <message>
        <source>What the project file held before each of the last saves. Restoring is an edit: undo takes it back, and the file changes only when you save.</source>
        <translation>專案檔案在最近每次儲存之前的內容。還原屬於編輯：可以復原，且只有儲存時才會變更檔案。</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>無法讀取</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WelcomePage</name>
    <message>
        <source>Cut a recorded bout into actions: both fighters in 3D over the force that they exert against the ground. Its minima are the boundaries; you correct the few that are wrong. Then say what a few actions are, and the machine says it of the rest.</source>
        <translation>將錄製的對打切成動作：雙方選手以 3D 呈現，下方是他們對地面施加的力。力的極小值就是邊界；你只要修正少數錯誤。接著說明幾個動作是什麼，其餘由機器標記。</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Or drop recordings (BVH, or AMC with its ASF) or a project on this window.</source>
        <translation>或將錄製檔（BVH，或 AMC 搭配其 ASF）或專案拖放到此視窗。</translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation>最近開啟</translation>
    </message>
    <message>
        <source>Projects and recordings that you open appear here, with the day and the folder.</source>
        <translation>你開啟的專案與錄製檔會出現在這裡，並附上日期與資料夾。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WelcomePicture</name>
    <message>
        <source>Two fighters over the curves of their contact force, which is cut into actions at its minima</source>
        <translation>兩名選手位於接觸力曲線上方，曲線在極小值處切成動作</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>actions</source>
        <translation>動作</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WhatIfBox</name>
    <message>
        <source>at playhead</source>
        <translation>在播放頭</translation>
    </message>
    <message>
        <source>Both labels are those of the moment that is shown</source>
        <translation>兩個標籤都取自目前顯示的時刻</translation>
    </message>
    <message>
        <source>own</source>
        <translation>自己</translation>
    </message>
    <message>
        <source>What the fighter does now</source>
        <translation>選手現在做什麼</translation>
    </message>
    <message>
        <source>opponent</source>
        <translation>對手</translation>
    </message>
    <message>
        <source>What the opponent does now</source>
        <translation>對手現在做什麼</translation>
    </message>
    <message>
        <source>What comes next</source>
        <translation>接下來是什麼</translation>
    </message>
    <message>
        <source>What next?</source>
        <translation>接下來呢？</translation>
    </message>
    <message>
        <source>What %1 may do next, the likeliest first</source>
        <translation>%1 接下來可能做什麼，最可能的在前</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>任意</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WhatIfDelegate</name>
    <message>
        <source>P %1</source>
        <translation>P %1</translation>
    </message>
    <message>
        <source>label %1</source>
        <translation>標籤 %1</translation>
    </message>
    <message>
        <source>geom. %1</source>
        <translation>幾何 %1</translation>
    </message>
    <message>
        <source>n %1</source>
        <translation>n %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WhatIfModel</name>
    <message>
        <source>%1: P %2, label term %3</source>
        <translation>%1：P %2，標籤項 %3</translation>
    </message>
    <message>
        <source>, geometry term %1</source>
        <translation>，幾何項 %1</translation>
    </message>
    <message>
        <source>
Seen %1 times with both labels, %2 with the own, %3 with the opponent&apos;s</source>
        <translation>
兩個標籤皆符合見過 %1 次，自己的 %2 次，對手的 %3 次</translation>
    </message>
    <message>
        <source>
This is what came next</source>
        <translation>
接下來發生的就是這個</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Words</name>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>prominence %1</source>
        <translation>突出度 %1</translation>
    </message>
    <message>
        <source>slow left kick, %1</source>
        <translation>慢速左踢，%1</translation>
    </message>
    <message>
        <source>slow right kick, %1</source>
        <translation>慢速右踢，%1</translation>
    </message>
    <message>
        <source>left foot moves at %1 m/s, %2</source>
        <translation>左腳以 %1 m/s 移動，%2</translation>
    </message>
    <message>
        <source>right foot moves at %1 m/s, %2</source>
        <translation>右腳以 %1 m/s 移動，%2</translation>
    </message>
    <message>
        <source>shallow, %1</source>
        <translation>淺，%1</translation>
    </message>
    <message>
        <source>%1 s from the next minimum, %2</source>
        <translation>距下一個極小值 %1 s，%2</translation>
    </message>
    <message>
        <source>hardly dips (to %1), %2</source>
        <translation>幾乎沒下降（到 %1），%2</translation>
    </message>
    <message>
        <source>nothing unusual, %1</source>
        <translation>沒有異常，%1</translation>
    </message>
    <message>
        <source>left kick</source>
        <translation>左踢</translation>
    </message>
    <message>
        <source>right kick</source>
        <translation>右踢</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>左腳</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>右腳</translation>
    </message>
    <message>
        <source>shallow</source>
        <translation>淺</translation>
    </message>
    <message>
        <source>crowded</source>
        <translation>太密</translation>
    </message>
    <message>
        <source>hardly dips</source>
        <translation>幾乎沒下降</translation>
    </message>
    <message>
        <source>%1, suspicion %2</source>
        <translation>%1，可疑度 %2</translation>
    </message>
    <message>
        <source>removal at %1</source>
        <translation>於 %1 移除</translation>
    </message>
    <message>
        <source>addition at %1</source>
        <translation>於 %1 加入</translation>
    </message>
    <message>
        <source>move from %1 to %2</source>
        <translation>從 %1 移到 %2</translation>
    </message>
    <message>
        <source>acceptance at %1</source>
        <translation>於 %1 接受</translation>
    </message>
    <message>
        <source>fighter %1</source>
        <translation>選手 %1</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>今天 %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>昨天 %1</translation>
    </message>
    <message>
        <source>Computer %1, process %2, since %3.</source>
        <translation>電腦 %1，處理程序 %2，自 %3 起。</translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s)</source>
        <translation>
            <numerusform>%n 項編輯</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::WorkspaceBar</name>
    <message>
        <source>Workspaces</source>
        <translation>工作區</translation>
    </message>
    <message>
        <source>%1 workspace</source>
        <translation>%1工作區</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Workspaces</name>
    <message>
        <source>%1 workspace</source>
        <translation>%1工作區</translation>
    </message>
</context>
</TS>
