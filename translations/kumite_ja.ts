<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>Core</name>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>復旧</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>ラベルを取り込む</translation>
    </message>
    <message>
        <source>Take over labels of %1</source>
        <translation>%1のラベルを取り込む</translation>
    </message>
    <message>
        <source>Remove boundary %1</source>
        <translation>境界%1を削除</translation>
    </message>
    <message>
        <source>Restore boundary %1</source>
        <translation>境界%1を復元</translation>
    </message>
    <message>
        <source>Add boundary %1</source>
        <translation>境界%1を追加</translation>
    </message>
    <message>
        <source>Move boundary %1</source>
        <translation>境界%1を移動</translation>
    </message>
    <message>
        <source>Accept boundary %1</source>
        <translation>境界%1を承認</translation>
    </message>
    <message>
        <source>Change segmentation settings</source>
        <translation>分割の設定を変更</translation>
    </message>
    <message>
        <source>Change body model to %1</source>
        <translation>身体モデルを%1に変更</translation>
    </message>
    <message>
        <source>Restore the version of %1</source>
        <translation>%1のバージョンを復元</translation>
    </message>
    <message>
        <source>Add clips</source>
        <translation>クリップを追加</translation>
    </message>
    <message>
        <source>Remove clips</source>
        <translation>クリップを削除</translation>
    </message>
    <message>
        <source>Add take %1</source>
        <translation>テイク%1を追加</translation>
    </message>
    <message>
        <source>Remove take %1</source>
        <translation>テイク%1を削除</translation>
    </message>
    <message>
        <source>Rename take to %1</source>
        <translation>テイクの名前を%1に変更</translation>
    </message>
    <message>
        <source>Move take %1 to place %2</source>
        <translation>テイク%1を%2番目へ移動</translation>
    </message>
    <message>
        <source>Swap fighters</source>
        <translation>選手を入れ替え</translation>
    </message>
    <message>
        <source>Change time offset, fighter %1</source>
        <translation>時間オフセットを変更、選手%1</translation>
    </message>
    <message>
        <source>Change floor, fighter %1</source>
        <translation>床を変更、選手%1</translation>
    </message>
    <message>
        <source>Change role %1, fighter %2</source>
        <translation>役割%1を変更、選手%2</translation>
    </message>
    <message>
        <source>Relink recording, fighter %1</source>
        <translation>収録を再リンク、選手%1</translation>
    </message>
    <message>
        <source>Keep bout as take %1</source>
        <translation>試合をテイク%1として残す</translation>
    </message>
    <message>
        <source>Keep motion as take %1</source>
        <translation>モーションをテイク%1として残す</translation>
    </message>
    <message>
        <source>Label action %1, fighter %2: %3</source>
        <translation>動作%1にラベル付け、選手%2: %3</translation>
    </message>
    <message>
        <source>Label action %1, fighter %2</source>
        <translation>動作%1にラベル付け、選手%2</translation>
    </message>
    <message>
        <source>Label %1 actions, fighter %2: %3</source>
        <translation>動作%1件にラベル付け、選手%2: %3</translation>
    </message>
    <message>
        <source>Label %1 actions, fighter %2</source>
        <translation>動作%1件にラベル付け、選手%2</translation>
    </message>
    <message>
        <source>Label %1 actions: %2</source>
        <translation>動作%1件にラベル付け: %2</translation>
    </message>
    <message>
        <source>Label %1 actions</source>
        <translation>動作%1件にラベル付け</translation>
    </message>
    <message>
        <source>Clear label, action %1, fighter %2</source>
        <translation>ラベルを消去、動作%1、選手%2</translation>
    </message>
    <message>
        <source>Clear label, %1 actions, fighter %2</source>
        <translation>ラベルを消去、動作%1件、選手%2</translation>
    </message>
    <message>
        <source>Accept labels</source>
        <translation>ラベルを承認</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>ラベルを読み込む</translation>
    </message>
    <message>
        <source>Merge labels</source>
        <translation>ラベルを統合</translation>
    </message>
    <message>
        <source>Change vocabulary to %1</source>
        <translation>語彙を%1に変更</translation>
    </message>
    <message>
        <source>Change rules</source>
        <translation>ルールを変更</translation>
    </message>
    <message>
        <source>Change learning settings</source>
        <translation>学習の設定を変更</translation>
    </message>
    <message>
        <source>Keep model</source>
        <translation>モデルを保存</translation>
    </message>
    <message>
        <source>Remove note %1</source>
        <translation>メモ%1を削除</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>メモ%1</translation>
    </message>
    <message>
        <source>Accept what rules say</source>
        <translation>ルールの提案を承認</translation>
    </message>
    <message>
        <source>Accept 1 label</source>
        <translation>ラベル1件を承認</translation>
    </message>
    <message>
        <source>Accept %1 labels</source>
        <translation>ラベル%1件を承認</translation>
    </message>
    <message>
        <source>at %1, fighter %2</source>
        <translation>%1、選手%2</translation>
    </message>
    <message>
        <source>A model of two fighters needs a take with two of them.</source>
        <translation>二人の選手のモデルには、二人が写るテイクが必要です。</translation>
    </message>
    <message>
        <source>No action is labelled yet: label some by hand and let the machine do the rest, or import labels.</source>
        <translation>ラベルの付いた動作がまだありません。いくつかを手で付けて残りを機械に任せるか、ラベルを読み込んでください。</translation>
    </message>
    <message>
        <source>No transition has the labels of all its three actions: label more of both fighters.</source>
        <translation>三つの動作すべてにラベルがある遷移がありません。両選手の動作にもっとラベルを付けてください。</translation>
    </message>
    <message>
        <source>cannot be read: %1.</source>
        <translation>読み込めません: %1。</translation>
    </message>
    <message>
        <source>cannot read: %1.</source>
        <translation>読み込めません: %1。</translation>
    </message>
    <message>
        <source>cannot write: %1.</source>
        <translation>書き込めません: %1。</translation>
    </message>
    <message>
        <source>cannot make this folder: %1.</source>
        <translation>このフォルダーを作れません: %1。</translation>
    </message>
    <message>
        <source>is a folder, expected a file.</source>
        <translation>フォルダーです。ファイルを指定してください。</translation>
    </message>
    <message>
        <source>is no regular file; save it as one first.</source>
        <translation>通常のファイルではありません。まずファイルとして保存してください。</translation>
    </message>
    <message>
        <source>is a folder, expected a file to write.</source>
        <translation>フォルダーです。書き込み先にはファイルを指定してください。</translation>
    </message>
    <message>
        <source>is what is read here; write to another file.</source>
        <translation>読み込み中のファイルそのものです。別のファイルに書き込んでください。</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>そのようなファイルはありません。</translation>
    </message>
    <message>
        <source>Every motion has too few frames for %1 key poses.</source>
        <translation>どのモーションもフレームが足りず、キーポーズ%1個を取れません。</translation>
    </message>
    <message>
        <source>There is no frame of %1 to write.</source>
        <translation>書き込む%1のフレームがありません。</translation>
    </message>
    <message>
        <source>The file holds %1 skeletons: %2. The first is read unless --root names another.</source>
        <translation>ファイルにスケルトンが%1個あります: %2。--rootで別のものを指定しない限り、最初のものを読み込みます。</translation>
    </message>
    <message>
        <source>found several skeletons beside it (%1), expected one (name it with --asf)</source>
        <translation>同じ場所にスケルトンが複数あります (%1)。1つを--asfで指定してください</translation>
    </message>
    <message>
        <source>found %1, expected %2</source>
        <translation>必要なのは%2ですが、見つかったのは%1です</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>ファイルの終わり</translation>
    </message>
    <message>
        <source>only the %1 channels that CHANNELS announces</source>
        <translation>CHANNELSで宣言された%1チャンネルだけ</translation>
    </message>
    <message>
        <source>A split by takes needs two takes or more with labelled transitions.</source>
        <translation>テイク単位で分けるには、ラベル付きの遷移があるテイクが2つ以上必要です。</translation>
    </message>
    <message>
        <source>There are too few labelled transitions to set some apart.</source>
        <translation>ラベル付きの遷移が少なすぎて、一部を取り分けられません。</translation>
    </message>
    <message>
        <source>For labelling, these joints take their parents&apos; place: %1.</source>
        <translation>ラベル付けでは、次の関節に親の関節の位置を使います: %1。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no aspect of the vocabulary %2.</source>
        <translation>「%1」に当たる観点は、語彙%2にありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no qualifier of %2.</source>
        <translation>「%1」に当たる修飾は、%2にありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names an aspect twice.</source>
        <translation>「%1」に同じ観点が2回あります。</translation>
    </message>
    <message>
        <source>After %1 a confidence is expected, such as 0.6 or 60 %.</source>
        <translation>%1の後には確信度が必要です。例: 0.6、60%。</translation>
    </message>
    <message>
        <source>After %1 a confidence is expected, such as 0.6 or 60 %, not %2.</source>
        <translation>%1の後には確信度が必要です (例: 0.6、60%)。%2は使えません。</translation>
    </message>
    <message>
        <source>Say whether the confidence is &quot;below %1&quot; or &quot;above %1&quot;.</source>
        <translation>確信度は「below %1」か「above %1」のどちらかで指定してください。</translation>
    </message>
    <message>
        <source>After %1 a time is expected, such as %2.</source>
        <translation>%1の後には時刻が必要です。例: %2。</translation>
    </message>
    <message>
        <source>After %1 a time is expected, such as %2, not %3.</source>
        <translation>%1の後には時刻が必要です (例: %2)。%3は使えません。</translation>
    </message>
    <message>
        <source>After %1 two times are expected, such as 0:30 to 1:00.</source>
        <translation>%1の後には時刻が2つ必要です。例: 0:30 to 1:00。</translation>
    </message>
    <message>
        <source>After %1 1 or 2 is expected.</source>
        <translation>%1の後には1か2が必要です。</translation>
    </message>
    <message>
        <source>After %1 1 or 2 is expected, not %2.</source>
        <translation>%1の後には1か2が必要です。%2は使えません。</translation>
    </message>
    <message>
        <source>There is no take %1; the takes are %2.</source>
        <translation>テイク%1はありません。テイク: %2。</translation>
    </message>
    <message>
        <source>Say which take; the takes are %1.</source>
        <translation>どのテイクかを指定してください。テイク: %1。</translation>
    </message>
    <message>
        <source>No aspect has a &quot;strike&quot;: %1 will never find anything to react to.</source>
        <translation>「strike」のある観点がないため、%1には反応する対象が見つかりません。</translation>
    </message>
    <message>
        <source>The key %1 stands for both %2 and %3.</source>
        <translation>キー%1が%2と%3の両方に割り当てられています。</translation>
    </message>
    <message>
        <source>In %1 the key %2 stands for both %3 and %4.</source>
        <translation>%1で、キー%2が%3と%4の両方に割り当てられています。</translation>
    </message>
    <message>
        <source>The target has no %1: their turns go to the joints below them.</source>
        <translation>リターゲット先に%1がありません。その回転は下位の関節に移されます。</translation>
    </message>
    <message>
        <source>The source has no %1: they keep their rest relative to their parent.</source>
        <translation>リターゲット元に%1がありません。親に対してレストポーズのままになります。</translation>
    </message>
    <message>
        <source>No joint was found for: %1.</source>
        <translation>関節が見つかりません: %1。</translation>
    </message>
    <message>
        <source>Joint %1 does not stand behind its parent.</source>
        <translation>関節%1が親より後に並んでいません。</translation>
    </message>
    <message>
        <source>The channels of joint %1 do not follow the ones before.</source>
        <translation>関節%1のチャンネルが、前の関節のチャンネルに続いていません。</translation>
    </message>
    <message>
        <source>The End Site %1 has channels.</source>
        <translation>End Site %1にチャンネルがあります。</translation>
    </message>
    <message>
        <source>The offset of joint %1 is not a finite number.</source>
        <translation>関節%1のオフセットが有限の数ではありません。</translation>
    </message>
    <message>
        <source>Frame 0 is a rest pose, not motion; takes leave it out.</source>
        <translation>フレーム0は動きではなくレストポーズです。テイクには含めません。</translation>
    </message>
    <message>
        <source>Frames 0 to %1 are a rest pose, not motion; takes leave them out.</source>
        <translation>フレーム0～%1は動きではなくレストポーズです。テイクには含めません。</translation>
    </message>
    <message>
        <source>Fighter %1 has no boundary near frame %2.</source>
        <translation>選手%1には、フレーム%2の近くに境界がありません。</translation>
    </message>
    <message>
        <source>Fighter %1 has no boundary near frame %2; the nearest is at %3.</source>
        <translation>選手%1には、フレーム%2の近くに境界がありません。最も近い境界は%3です。</translation>
    </message>
    <message>
        <source>the recording is missing; its boundaries cannot be edited.</source>
        <translation>収録が見つからないため、境界を編集できません。</translation>
    </message>
    <message>
        <source>A time offset must be a number.</source>
        <translation>時間オフセットは数にしてください。</translation>
    </message>
    <message>
        <source>A placement must be a number.</source>
        <translation>位置は数にしてください。</translation>
    </message>
    <message>
        <source>The floor&apos;s height must be a number.</source>
        <translation>床の高さは数にしてください。</translation>
    </message>
    <message>
        <source>There is a take named &quot;%1&quot; already.</source>
        <translation>「%1」という名前のテイクはすでにあります。</translation>
    </message>
    <message>
        <source>%1 has another skeleton: it is not the recording that is missing.</source>
        <translation>%1はスケルトンが異なります。探している収録ではありません。</translation>
    </message>
    <message>
        <source>the suffix says what to write, expected .bvh, .glb, .npz, .csv, .json or .eaf.</source>
        <translation>拡張子で書き出す形式が決まります。.bvh、.glb、.npz、.csv、.json、.eafのいずれかにしてください。</translation>
    </message>
    <message>
        <source>the recording is missing; the take cannot be written without it.</source>
        <translation>収録が見つからないため、テイクを書き出せません。</translation>
    </message>
    <message>
        <source>a graph is written as .csv, .json or .graphml.</source>
        <translation>グラフは.csv、.json、.graphmlのいずれかで書き出します。</translation>
    </message>
    <message>
        <source>there is no joint named &quot;%1&quot;; there is: %2.</source>
        <translation>「%1」という名前の関節はありません。関節: %2。</translation>
    </message>
    <message>
        <source>the name holds bytes that are no UTF-8 text; rename the file or folder.</source>
        <translation>名前にUTF-8でない文字が含まれています。ファイルかフォルダーの名前を変えてください。</translation>
    </message>
    <message>
        <source>the key pose of clip &quot;%1&quot; is not in the project</source>
        <translation>クリップ「%1」のキーポーズがプロジェクトにありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no source.</source>
        <translation>「%1」は、ラベルを付けたものを表す語ではありません。</translation>
    </message>
    <message>
        <source>labels are written as .csv, .json or .eaf.</source>
        <translation>ラベルは.csv、.json、.eafのいずれかで書き出します。</translation>
    </message>
    <message>
        <source>labels are read from .csv, .json and .eaf files.</source>
        <translation>ラベルは.csv、.json、.eafのファイルから読み込みます。</translation>
    </message>
    <message>
        <source>the project has no take &quot;%1&quot;.</source>
        <translation>プロジェクトに「%1」というテイクはありません。</translation>
    </message>
    <message>
        <source>the take has no such fighter.</source>
        <translation>テイクにその選手はいません。</translation>
    </message>
    <message>
        <source>no action there.</source>
        <translation>そこに動作はありません。</translation>
    </message>
    <message>
        <source>its action takes the label of %1.</source>
        <translation>この動作には、代わりに%1のラベルを使います。</translation>
    </message>
    <message>
        <source>no joint has the role pelvis, so its actions cannot be compared.</source>
        <translation>役割「骨盤」の関節がないため、動作を比較できません。</translation>
    </message>
    <message>
        <source>the recording is missing; its actions cannot be labelled.</source>
        <translation>収録が見つからないため、動作にラベルを付けられません。</translation>
    </message>
    <message>
        <source>has no body with two legs; it is left out.</source>
        <translation>両脚のある体がないため、除外します。</translation>
    </message>
    <message>
        <source>%1 It is left out.</source>
        <translation>%1 除外します。</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: expected frames as A:B after the @.</source>
        <translation>「%1」: @の後にはフレームをA:Bの形で指定してください。</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: these frames are not in it; it has %2 to %3.</source>
        <translation>「%1」: フレームが範囲の外です。範囲は%2～%3です。</translation>
    </message>
    <message>
        <source>No action of the library is labelled &quot;%1&quot;.</source>
        <translation>ライブラリに「%1」のラベルが付いた動作はありません。</translation>
    </message>
    <message>
        <source>No action of the library is labelled &quot;%1&quot; of that player.</source>
        <translation>ライブラリに、その選手の「%1」のラベルが付いた動作はありません。</translation>
    </message>
    <message>
        <source>None of these clips is of that player.</source>
        <translation>これらのクリップに、その選手のものはありません。</translation>
    </message>
    <message>
        <source>joint &quot;%1&quot; is gone; the role %2 has no joint now.</source>
        <translation>関節「%1」がなくなったため、役割%2に関節がありません。</translation>
    </message>
    <message>
        <source>%1 The recording is left out; its corrections are kept.</source>
        <translation>%1 収録は除外しますが、修正は残ります。</translation>
    </message>
    <message>
        <source>the recording is missing; put it back or relink it. Its corrections are kept.</source>
        <translation>収録が見つかりません。元の場所に戻すか、再リンクしてください。修正は残っています。</translation>
    </message>
    <message>
        <source>the recording has changed since it became part of the project; check the boundaries, then relink it to accept the change.</source>
        <translation>収録が、プロジェクトに入れた後で変わっています。境界を確認してから再リンクすると、変更を受け入れます。</translation>
    </message>
    <message>
        <source>the recording is missing; the take cannot be shown without it.</source>
        <translation>収録が見つからないため、テイクを表示できません。</translation>
    </message>
    <message>
        <source>There is no take named &quot;%1&quot;; the project has none.</source>
        <translation>「%1」という名前のテイクはありません。プロジェクトにテイクがありません。</translation>
    </message>
    <message>
        <source>There is no take named &quot;%1&quot;; there is: %2.</source>
        <translation>「%1」という名前のテイクはありません。テイク: %2。</translation>
    </message>
    <message>
        <source>no contact force without a body; no joint has the role %1.</source>
        <translation>体がないと接地力は求められません。役割%1の関節がありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; of fighter %2 is no correction without a minimum.</source>
        <translation>選手%2の「%1」は、極小のない修正ではありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; leaves no boundary that could be added.</source>
        <translation>「%1」には、追加できる境界がありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be reached: the nearest target that can is %2.</source>
        <translation>「%1」には届きません。届く中で最も近いターゲットは%2です。</translation>
    </message>
    <message>
        <source>What was saved before could not be kept. %1</source>
        <translation>前に保存した内容を残せませんでした。%1</translation>
    </message>
    <message>
        <source>holds %1 frames only; the take ends there for this fighter.</source>
        <translation>%1フレームしかありません。この選手のテイクはそこで終わります。</translation>
    </message>
    <message>
        <source>holds %1 frames now, the take begins at frame %2; the recording is left out.</source>
        <translation>今は%1フレームですが、テイクはフレーム%2から始まります。収録を除外します。</translation>
    </message>
    <message>
        <source>holds %1 frames now; the take ends there.</source>
        <translation>今は%1フレームです。テイクはそこで終わります。</translation>
    </message>
    <message>
        <source>a cutoff of %1 Hz smooths nothing at %2 frames a second; choose one below %3 Hz.</source>
        <translation>毎秒%2フレームでは、%1 Hzのカットオフで何も平滑化されません。%3 Hz未満にしてください。</translation>
    </message>
    <message>
        <source>the annotation &quot;%1&quot; has no time and is left out.</source>
        <translation>注釈「%1」には時刻がないため、除外します。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no action that can be asked for; there are %2, what they strike with, and ASPECT:QUALIFIER.</source>
        <translation>「%1」は指示できる動作ではありません。指示できるのは%2、打つ部位、ASPECT:QUALIFIER (観点:修飾) です。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing.</source>
        <translation>「%1」がありません。</translation>
    </message>
    <message>
        <source>expected a list.</source>
        <translation>リストが必要です。</translation>
    </message>
    <message>
        <source>expected an object.</source>
        <translation>オブジェクトが必要です。</translation>
    </message>
    <message>
        <source>expected a whole number.</source>
        <translation>整数が必要です。</translation>
    </message>
    <message>
        <source>expected a number.</source>
        <translation>数が必要です。</translation>
    </message>
    <message>
        <source>expected a finite number.</source>
        <translation>有限の数が必要です。</translation>
    </message>
    <message>
        <source>expected a number above 0.</source>
        <translation>0より大きい数が必要です。</translation>
    </message>
    <message>
        <source>expected true or false.</source>
        <translation>trueかfalseが必要です。</translation>
    </message>
    <message>
        <source>expected text.</source>
        <translation>テキストが必要です。</translation>
    </message>
    <message>
        <source>expected 0 or more.</source>
        <translation>0以上の数が必要です。</translation>
    </message>
    <message>
        <source>expected [begin, end] with 0 &lt;= begin &lt; end.</source>
        <translation>0 &lt;= begin &lt; endを満たす[begin, end]が必要です。</translation>
    </message>
    <message>
        <source>expected an object with &quot;key_poses&quot;: 1, &quot;rate&quot; and &quot;keys&quot;.</source>
        <translation>&quot;key_poses&quot;: 1、&quot;rate&quot;、&quot;keys&quot;を持つオブジェクトが必要です。</translation>
    </message>
    <message>
        <source>expected a colour like #3a86d8.</source>
        <translation>#3a86d8のような色が必要です。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no joint role.</source>
        <translation>「%1」という関節の役割はありません。</translation>
    </message>
    <message>
        <source>is no joint role.</source>
        <translation>関節の役割ではありません。</translation>
    </message>
    <message>
        <source>is no vocabulary: it has no &quot;vocabulary&quot; version.</source>
        <translation>語彙ではありません。「vocabulary」のバージョンがありません。</translation>
    </message>
    <message>
        <source>is the id of two qualifiers.</source>
        <translation>2つの修飾のIDになっています。</translation>
    </message>
    <message>
        <source>is the id of two aspects.</source>
        <translation>2つの観点のIDになっています。</translation>
    </message>
    <message>
        <source>is the name of two takes.</source>
        <translation>2つのテイクの名前になっています。</translation>
    </message>
    <message>
        <source>a take has one or two fighters.</source>
        <translation>テイクの選手は1人か2人です。</translation>
    </message>
    <message>
        <source>a vocabulary has one aspect or more.</source>
        <translation>語彙には観点が1つ以上必要です。</translation>
    </message>
    <message>
        <source>an aspect has two qualifiers or more.</source>
        <translation>観点には修飾が2つ以上必要です。</translation>
    </message>
    <message>
        <source>is none of the qualifiers.</source>
        <translation>どの修飾でもありません。</translation>
    </message>
    <message>
        <source>there is no aspect &quot;%1&quot;.</source>
        <translation>「%1」という観点はありません。</translation>
    </message>
    <message>
        <source>The system&apos;s OpenSSL library cannot compute SHA-256.</source>
        <translation>システムのOpenSSLライブラリではSHA-256を計算できません。</translation>
    </message>
    <message>
        <source>A demo bout lasts from 1 second to 24 hours; %1 seconds were asked for.</source>
        <translation>デモ試合の長さは1秒～24時間です。指定: %1秒。</translation>
    </message>
    <message>
        <source>A demo bout has 24 to 240 frames a second; %1 were asked for.</source>
        <translation>デモ試合のレートは毎秒24～240フレームです。指定: %1。</translation>
    </message>
    <message>
        <source>There is no key pose to make a motion of.</source>
        <translation>モーションの元になるキーポーズがありません。</translation>
    </message>
    <message>
        <source>The library holds no motion.</source>
        <translation>ライブラリにモーションがありません。</translation>
    </message>
    <message>
        <source>There is no key at frame %1.</source>
        <translation>フレーム%1にキーポーズはありません。</translation>
    </message>
    <message>
        <source>Frame %1 is not behind the key before.</source>
        <translation>フレーム%1は、前のキーポーズより後ではありません。</translation>
    </message>
    <message>
        <source>Keys can be brought nearer or farther by a factor above 0 only.</source>
        <translation>キーポーズの間隔の倍率は、0より大きくしてください。</translation>
    </message>
    <message>
        <source>Keys cannot be brought that far.</source>
        <translation>キーポーズをそこまで離すことはできません。</translation>
    </message>
    <message>
        <source>Key poses need a skeleton.</source>
        <translation>キーポーズにはスケルトンが必要です。</translation>
    </message>
    <message>
        <source>Key poses need a rate above 0.</source>
        <translation>キーポーズのレートは0より大きくしてください。</translation>
    </message>
    <message>
        <source>The key at frame %1 is a pose of another skeleton.</source>
        <translation>フレーム%1のキーポーズは、別のスケルトンのポーズです。</translation>
    </message>
    <message>
        <source>The key at frame %1 comes after one at frame %2.</source>
        <translation>フレーム%1のキーポーズが、フレーム%2のものより後に並んでいます。</translation>
    </message>
    <message>
        <source>Frames %1:%2 are not in the take, which has %3.</source>
        <translation>フレーム%1:%2はテイクの範囲の外です。テイクは%3フレームです。</translation>
    </message>
    <message>
        <source>The part comes from another skeleton.</source>
        <translation>部位が別のスケルトンのものです。</translation>
    </message>
    <message>
        <source>Frames %1 to %2 are not in the source, which has %3.</source>
        <translation>フレーム%1～%2は元の範囲の外です。元は%3フレームです。</translation>
    </message>
    <message>
        <source>There is no key pose to look for.</source>
        <translation>探すキーポーズがありません。</translation>
    </message>
    <message>
        <source>At most 1000 key poses can be looked for.</source>
        <translation>一度に探せるキーポーズは1000個までです。</translation>
    </message>
    <message>
        <source>Every key pose needs its features and its frame.</source>
        <translation>どのキーポーズにも、特徴とフレームが必要です。</translation>
    </message>
    <message>
        <source>Key poses must stand in the order of their frames, one per frame.</source>
        <translation>キーポーズはフレームの順に、1フレームに1つずつ並べてください。</translation>
    </message>
    <message>
        <source>Two examples of the strike cannot be aligned in time.</source>
        <translation>打撃の2つの例を、時間方向に揃えられません。</translation>
    </message>
    <message>
        <source>There is no example of the strike to blend.</source>
        <translation>ブレンドする打撃の例がありません。</translation>
    </message>
    <message>
        <source>The skeleton has no %1: its roles tell nothing that could hit.</source>
        <translation>スケルトンに%1がありません。役割に、当てられる部位がありません。</translation>
    </message>
    <message>
        <source>Strike &quot;%1&quot; is of another skeleton.</source>
        <translation>打撃「%1」は別のスケルトンのものです。</translation>
    </message>
    <message>
        <source>Feature poses must come in pairs, one of the query and one of the clip.</source>
        <translation>特徴ポーズは、クエリ側とクリップ側を1つずつの対にしてください。</translation>
    </message>
    <message>
        <source>Feature poses must follow each other in time.</source>
        <translation>特徴ポーズは時間順に並べてください。</translation>
    </message>
    <message>
        <source>An AMC file does not say its frame rate: 120 Hz is assumed; give another with --rate.</source>
        <translation>AMCファイルにはフレームレートがないため、120 Hzとみなします。別の値は--rateで指定してください。</translation>
    </message>
    <message>
        <source>Frame %1, the last, is cut: it is dropped.</source>
        <translation>最後のフレーム%1は途中で切れているため、破棄します。</translation>
    </message>
    <message>
        <source>Frame %1 does not follow the one before it by number: the frames are taken one after the other.</source>
        <translation>フレーム%1の番号が前のフレームから続いていません。フレームは並び順に読み込みます。</translation>
    </message>
    <message>
        <source>found %1 numbers, expected %2 for bone %3 in frame %4</source>
        <translation>フレーム%4のボーン%3に必要なのは数値%2個ですが、見つかったのは%1個です</translation>
    </message>
    <message>
        <source>found no line for bone %1 in frame %2, expected one for each bone with a dof</source>
        <translation>フレーム%2にボーン%1の行がありません。dofのあるボーンごとに1行必要です</translation>
    </message>
    <message>
        <source>found %1, expected a unit of length greater than zero</source>
        <translation>必要なのは0より大きい長さの単位ですが、見つかったのは%1です</translation>
    </message>
    <message>
        <source>found a bone without name, expected one</source>
        <translation>ボーンに名前がありません。名前が必要です</translation>
    </message>
    <message>
        <source>found a second bone %1, expected one</source>
        <translation>ボーン%1が2つあります。1つだけにしてください</translation>
    </message>
    <message>
        <source>found bone %1 a second time, expected one parent for each</source>
        <translation>ボーン%1が2回出てきます。各ボーンの親は1つだけです</translation>
    </message>
    <message>
        <source>found bone %1 that does not hang on the root, expected it in :hierarchy</source>
        <translation>ボーン%1がルートにつながっていません。:hierarchyに必要です</translation>
    </message>
    <message>
        <source>found a skeleton without any dof, expected an order for the root</source>
        <translation>スケルトンにdofが1つもありません。ルートのorderが必要です</translation>
    </message>
    <message>
        <source>Bone %1 changes its length: that is not used.</source>
        <translation>ボーン%1の長さが変化しますが、その変化は使いません。</translation>
    </message>
    <message>
        <source>found more joints than a skeleton can have, expected %1 at most</source>
        <translation>関節が多すぎます。1つのスケルトンに使えるのは%1個までです</translation>
    </message>
    <message>
        <source>%1 has no OFFSET: taken as 0 0 0.</source>
        <translation>%1にOFFSETがないため、0 0 0とみなします。</translation>
    </message>
    <message>
        <source>%1 has channels or children: read as a joint.</source>
        <translation>%1にチャンネルか子があるため、関節として読み込みます。</translation>
    </message>
    <message>
        <source>found a second %1, expected one in joint %2</source>
        <translation>関節%2に2つ目の%1があります。1つだけにしてください</translation>
    </message>
    <message>
        <source>found a skeleton without any channel, expected CHANNELS</source>
        <translation>スケルトンにチャンネルが1つもありません。CHANNELSが必要です</translation>
    </message>
    <message>
        <source>found %1 numbers after Frame Time, expected at least one frame of %2 numbers</source>
        <translation>Frame Timeの後の数値が%1個しかありません。少なくとも1フレーム分の%2個が必要です</translation>
    </message>
    <message>
        <source>found more frames than can be counted, expected fewer</source>
        <translation>フレームが数えきれないほどあります。減らしてください</translation>
    </message>
    <message>
        <source>A .glb file cannot hold more than 4 GB: export a shorter range.</source>
        <translation>.glbファイルの上限は4 GBです。書き出す範囲を短くしてください。</translation>
    </message>
    <message>
        <source>There is no figure to write.</source>
        <translation>書き出す人物がありません。</translation>
    </message>
    <message>
        <source>A glTF skeleton cannot have more than 65 535 joints.</source>
        <translation>glTFのスケルトンに使える関節は65 535個までです。</translation>
    </message>
    <message>
        <source>is not valid JSON here.</source>
        <translation>ここが正しいJSONではありません。</translation>
    </message>
    <message>
        <source>holds a number that is too large.</source>
        <translation>大きすぎる数が含まれています。</translation>
    </message>
    <message>
        <source>A .npz file cannot hold more than 4 GB: export a shorter range.</source>
        <translation>.npzファイルの上限は4 GBです。書き出す範囲を短くしてください。</translation>
    </message>
    <message>
        <source>found no skeleton beside it, expected an .asf file (name it with --asf)</source>
        <translation>同じ場所にスケルトンがありません。.asfファイルが必要です (--asfで指定できます)</translation>
    </message>
    <message>
        <source>found an ASF skeleton, which holds no motion, expected the .amc file that belongs to it.</source>
        <translation>ASFスケルトンです。動きは含まれないため、対応する.amcファイルを指定してください。</translation>
    </message>
    <message>
        <source>The recording holds no skeleton.</source>
        <translation>収録にスケルトンがありません。</translation>
    </message>
    <message>
        <source>found UTF-16 text, expected plain text (save the file as UTF-8)</source>
        <translation>UTF-16のテキストです。通常のテキストが必要です (UTF-8で保存してください)</translation>
    </message>
    <message>
        <source>has a quote that is not closed.</source>
        <translation>引用符が閉じていません。</translation>
    </message>
    <message>
        <source>No joint has the role pelvis: actions cannot be compared.</source>
        <translation>役割「骨盤」の関節がないため、動作を比較できません。</translation>
    </message>
    <message>
        <source>Nothing stands before &quot;or&quot;.</source>
        <translation>「or」の前に何もありません。</translation>
    </message>
    <message>
        <source>Nothing stands after &quot;or&quot;.</source>
        <translation>「or」の後に何もありません。</translation>
    </message>
    <message>
        <source>Something is missing after &quot;not&quot;.</source>
        <translation>「not」の後が足りません。</translation>
    </message>
    <message>
        <source>Points to be aligned must come in pairs.</source>
        <translation>揃える点は対にしてください。</translation>
    </message>
    <message>
        <source>Points to be aligned need a weight above zero.</source>
        <translation>揃える点には0より大きい重みが必要です。</translation>
    </message>
    <message>
        <source>A rate must be a positive number of frames a second.</source>
        <translation>レートは正の数 (毎秒フレーム数) にしてください。</translation>
    </message>
    <message>
        <source>Foot locking needs a frame to show.</source>
        <translation>足の固定には、表示するフレームが必要です。</translation>
    </message>
    <message>
        <source>Foot locking needs to know of every frame which feet stand.</source>
        <translation>足の固定には、どの足が接地しているかがフレームごとに必要です。</translation>
    </message>
    <message>
        <source>A clip without frames cannot be joined.</source>
        <translation>フレームのないクリップはつなげません。</translation>
    </message>
    <message>
        <source>Clips can be joined only at one rate and on one skeleton.</source>
        <translation>つなげるのは、レートとスケルトンが同じクリップだけです。</translation>
    </message>
    <message>
        <source>A motion needs a skeleton.</source>
        <translation>モーションにはスケルトンが必要です。</translation>
    </message>
    <message>
        <source>A motion&apos;s frame time must be a positive number of seconds.</source>
        <translation>モーションのフレーム時間は正の秒数にしてください。</translation>
    </message>
    <message>
        <source>A motion&apos;s channel values do not fill its frames.</source>
        <translation>モーションのチャンネル値の数がフレームと合いません。</translation>
    </message>
    <message>
        <source>A channel value is not a finite number.</source>
        <translation>チャンネルの値が有限の数ではありません。</translation>
    </message>
    <message>
        <source>A clip&apos;s rig does not have the joints of its motion.</source>
        <translation>クリップのリグの関節がモーションと一致しません。</translation>
    </message>
    <message>
        <source>A clip of %1 joints cannot be written with the %2 joints of another skeleton: retarget it first.</source>
        <translation>関節%1個のクリップは、関節%2個の別のスケルトンでは書き出せません。先にリターゲットしてください。</translation>
    </message>
    <message>
        <source>Ways are scaled by %1 for the legs&apos; lengths.</source>
        <translation>脚の長さに合わせて、移動量を%1倍します。</translation>
    </message>
    <message>
        <source>%1 moves by up to %2 cm of its own, which is not kept: %3 carries the body.</source>
        <translation>%1は単独で最大%2 cm動きますが、その動きは残しません。体を動かすのは%3です。</translation>
    </message>
    <message>
        <source>The bone to %1 changes by up to %2 cm; its mean is kept.</source>
        <translation>%1へのボーンの長さが最大%2 cm変化します。平均の長さを使います。</translation>
    </message>
    <message>
        <source>No neck: the chest (%1) stands in for it.</source>
        <translation>首がないため、胸 (%1) で代用します。</translation>
    </message>
    <message>
        <source>The joint names say nothing; the roles were read off the skeleton&apos;s shape. Check left and right.</source>
        <translation>関節の名前からはわからないため、役割をスケルトンの形から判定しました。左右を確認してください。</translation>
    </message>
    <message>
        <source>This skeleton is not a human body that is known here: it is shown and measured, but the contact force needs joint roles. Name them by hand if it is one.</source>
        <translation>このスケルトンは既知の人体ではありません。表示と計測はできますが、接地力には関節の役割が必要です。人体であれば、手動で割り当ててください。</translation>
    </message>
    <message>
        <source>A skeleton needs at least one joint.</source>
        <translation>スケルトンには関節が1つ以上必要です。</translation>
    </message>
    <message>
        <source>A skeleton&apos;s channel count does not add up.</source>
        <translation>スケルトンのチャンネル数が合いません。</translation>
    </message>
    <message>
        <source>The body lies along the x axis; y was taken for up. Say which axis is up.</source>
        <translation>体がx軸に沿って横たわっているため、yを上とみなしました。上の軸を指定してください。</translation>
    </message>
    <message>
        <source>Without legs the unit cannot be found; centimetres are assumed.</source>
        <translation>脚がないため単位がわかりません。センチメートルとみなします。</translation>
    </message>
    <message>
        <source>The labels belong to another segmentation.</source>
        <translation>ラベルは別の分割のものです。</translation>
    </message>
    <message>
        <source>The differences belong to another segmentation or vocabulary.</source>
        <translation>違いは別の分割か語彙のものです。</translation>
    </message>
    <message>
        <source>Fighter %1 has no removed boundary near frame %2.</source>
        <translation>選手%1には、フレーム%2の近くに削除した境界がありません。</translation>
    </message>
    <message>
        <source>Fighter %1 has another boundary at frame %2; move that one first.</source>
        <translation>選手%1のフレーム%2には別の境界があります。先にそちらを移動してください。</translation>
    </message>
    <message>
        <source>Frame %1 is not inside the take, whose last frame is %2: a boundary cannot stand there.</source>
        <translation>フレーム%1はテイクの外なので、境界を置けません。最後のフレームは%2です。</translation>
    </message>
    <message>
        <source>The boundary can move between its neighbours only: frames %1 to %2.</source>
        <translation>境界を移動できるのは隣の境界までの間、フレーム%1～%2だけです。</translation>
    </message>
    <message>
        <source>The boundary at frame %1 is an end of the take, which stays.</source>
        <translation>フレーム%1の境界はテイクの端なので、変更できません。</translation>
    </message>
    <message>
        <source>Take %1, player %2: its skeleton has other joints than that of the first take, so it is left out of bouts.</source>
        <translation>テイク%1、選手%2: 関節が最初のテイクのスケルトンと異なるため、試合から除外します。</translation>
    </message>
    <message>
        <source>No action of player %1 begins in frames %2 to %3 of take %4.</source>
        <translation>テイク%4のフレーム%2～%3に、選手%1の動作の始まりがありません。</translation>
    </message>
    <message>
        <source>Player %1 does not attack in frames %2 to %3 of take %4.</source>
        <translation>選手%1は、テイク%4のフレーム%2～%3で攻撃していません。</translation>
    </message>
    <message>
        <source>Player %1 never attacks.</source>
        <translation>選手%1は一度も攻撃していません。</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2.</source>
        <translation>フォルダー%1を作れません: %2。</translation>
    </message>
    <message>
        <source>The cutoff must be a positive number of Hz.</source>
        <translation>カットオフは正の数 (Hz) にしてください。</translation>
    </message>
    <message>
        <source>The prominence must be a number of body weights, 0 or more.</source>
        <translation>プロミネンスは0以上の数 (体重比) にしてください。</translation>
    </message>
    <message>
        <source>A take needs a name.</source>
        <translation>テイクには名前が必要です。</translation>
    </message>
    <message>
        <source>A take has one or two fighters.</source>
        <translation>テイクの選手は1人か2人です。</translation>
    </message>
    <message>
        <source>There is no such place in the list of takes.</source>
        <translation>テイクの一覧にそのような位置はありません。</translation>
    </message>
    <message>
        <source>There is one fighter only: nothing to swap.</source>
        <translation>選手が1人なので、入れ替えられません。</translation>
    </message>
    <message>
        <source>The skeleton has no such joint.</source>
        <translation>スケルトンにそのような関節はありません。</translation>
    </message>
    <message>
        <source>%1 holds %2 frames, but the take reaches to frame %3: it is not the recording that is missing.</source>
        <translation>%1は%2フレームですが、テイクはフレーム%3まであります。探している収録ではありません。</translation>
    </message>
    <message>
        <source>The placement cannot be written: neither the root nor a joint right below it has all position and rotation channels.</source>
        <translation>位置を書き込めません。ルートにも、そのすぐ下の関節にも、位置と回転のチャンネルが揃っていません。</translation>
    </message>
    <message>
        <source>A take is made of one or two recordings.</source>
        <translation>テイクは1つか2つの収録から作ります。</translation>
    </message>
    <message>
        <source>The take&apos;s name holds bytes that are no UTF-8 text.</source>
        <translation>テイクの名前にUTF-8でない文字が含まれています。</translation>
    </message>
    <message>
        <source>A frame rate lies between 1 and 10000 Hz.</source>
        <translation>フレームレートは1～10000 Hzです。</translation>
    </message>
    <message>
        <source>The recordings run at %1 and %2 Hz; each keeps its own rate.</source>
        <translation>収録のレートは%1と%2 Hzです。それぞれ元のレートを保ちます。</translation>
    </message>
    <message>
        <source>Take %1, player %2: no pelvis or no centre of mass is known, so its actions are left out.</source>
        <translation>テイク%1、選手%2: 骨盤か重心がわからないため、動作を除外します。</translation>
    </message>
    <message>
        <source>Player %1: %2 of %3 actions have no label and are left out, with every transition that touches them.</source>
        <translation>選手%1: 動作%3件中%2件にラベルがないため、それに接するすべての遷移とともに除外します。</translation>
    </message>
    <message>
        <source>No take of two has a recording of player %1 with the skeleton of the bout: it was removed since the bout was begun.</source>
        <translation>選手が二人のテイクに、試合のスケルトンを持つ選手%1の収録がありません。試合を始めた後に削除されました。</translation>
    </message>
    <message>
        <source>An .eaf file holds one take: say which.</source>
        <translation>.eafファイルに入るテイクは1つです。どのテイクかを指定してください。</translation>
    </message>
    <message>
        <source>is empty.</source>
        <translation>空です。</translation>
    </message>
    <message>
        <source>has no column %1; a label table needs begin_s, end_s and label.</source>
        <translation>列%1がありません。ラベルの表にはbegin_s、end_s、labelが必要です。</translation>
    </message>
    <message>
        <source>holds no labels: it has neither &quot;kumite_labels&quot; nor &quot;players&quot;.</source>
        <translation>ラベルがありません。「kumite_labels」も「players」もありません。</translation>
    </message>
    <message>
        <source>There is no action %1; the fighter has %2.</source>
        <translation>動作%1はありません。この選手の動作は%2件です。</translation>
    </message>
    <message>
        <source>The vocabulary has no aspect %1.</source>
        <translation>語彙に観点%1はありません。</translation>
    </message>
    <message>
        <source>%1 has no qualifier %2.</source>
        <translation>%1に修飾%2はありません。</translation>
    </message>
    <message>
        <source>The label belongs to another vocabulary.</source>
        <translation>ラベルは別の語彙のものです。</translation>
    </message>
    <message>
        <source>The thresholds of the rules must be numbers, 0 or more.</source>
        <translation>ルールのしきい値は0以上の数にしてください。</translation>
    </message>
    <message>
        <source>A cross-validation has two folds or more.</source>
        <translation>交差検証にはフォールドが2つ以上必要です。</translation>
    </message>
    <message>
        <source>A library&apos;s rate lies between %1 and %2 Hz.</source>
        <translation>ライブラリのレートは%1～%2 Hzです。</translation>
    </message>
    <message>
        <source>The library is empty: no source holds the motion of a body.</source>
        <translation>ライブラリが空です。体の動きを含むものがありません。</translation>
    </message>
    <message>
        <source>The library has no clip &quot;%1&quot;; it has %2.</source>
        <translation>ライブラリにクリップ「%1」はありません。クリップ: %2。</translation>
    </message>
    <message>
        <source>None of these clips shows a hand or a foot that strikes.</source>
        <translation>これらのクリップには、打撃をする手や足がありません。</translation>
    </message>
    <message>
        <source>No strike of the %1 was found in &quot;%2&quot;.</source>
        <translation>「%2」に%1の打撃は見つかりませんでした。</translation>
    </message>
    <message>
        <source>%1 was not where the project says; the same recording was found at %2.</source>
        <translation>%1はプロジェクトの示す場所にありませんでした。同じ収録が%2で見つかりました。</translation>
    </message>
    <message>
        <source>%1 is there already: choose another name.</source>
        <translation>%1はすでにあります。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>is a recording; make a project of it with kumite new.</source>
        <translation>収録です。kumite newでプロジェクトにしてください。</translation>
    </message>
    <message>
        <source>is not a Kumite project: it has no &quot;kumite&quot; version.</source>
        <translation>Kumiteプロジェクトではありません。「kumite」のバージョンがありません。</translation>
    </message>
    <message>
        <source>was written by a newer Kumite (file version %1, this one reads up to %2); open it with that one.</source>
        <translation>新しいKumiteで保存されています (ファイルのバージョン%1、このKumiteで読めるのは%2まで)。新しい方のKumiteで開いてください。</translation>
    </message>
    <message>
        <source>No motion from key poses of %1: %2</source>
        <translation>%1のキーポーズからモーションを作れません: %2</translation>
    </message>
    <message>
        <source>There is no clip to rate.</source>
        <translation>評価するクリップがありません。</translation>
    </message>
    <message>
        <source>Frame %1 is not inside the take: a boundary cannot stand there.</source>
        <translation>フレーム%1はテイクの外なので、境界を置けません。</translation>
    </message>
    <message>
        <source>Fighter %1 has another boundary at frame %2; forget this one.</source>
        <translation>選手%1のフレーム%2には別の境界があります。こちらは「忘れる」にしてください。</translation>
    </message>
    <message>
        <source>Fighter %1 has no action at frame %2.</source>
        <translation>選手%1のフレーム%2に動作はありません。</translation>
    </message>
    <message>
        <source>The budget is a share of all actions, above 0 and at most 1.</source>
        <translation>予算は全動作に対する割合で、0より大きく1以下です。</translation>
    </message>
    <message>
        <source>Player %1 has no labelled action that follows another labelled one: label more of it.</source>
        <translation>選手%1には、ラベル付きの動作に続くラベル付きの動作がありません。もっとラベルを付けてください。</translation>
    </message>
    <message>
        <source>The captured attack holds no action.</source>
        <translation>収録された攻撃に動作がありません。</translation>
    </message>
    <message>
        <source>No take of two shows player %1.</source>
        <translation>選手が二人のテイクに、選手%1が写るものがありません。</translation>
    </message>
    <message>
        <source>The captured attack cannot be shown: its take is missing.</source>
        <translation>収録された攻撃を表示できません。テイクが見つかりません。</translation>
    </message>
    <message>
        <source>Player %1 shows nothing but attacks outside of the captured one.</source>
        <translation>選手%1の動作は、収録された攻撃を除くと攻撃しかありません。</translation>
    </message>
    <message>
        <source>No recorded moment shows both fighters labelled.</source>
        <translation>両選手ともラベルがある場面が、収録にありません。</translation>
    </message>
    <message>
        <source>Only a bout with an avatar can be steered.</source>
        <translation>操作できるのは、アバターのいる試合だけです。</translation>
    </message>
    <message>
        <source>The library was made without an avatar&apos;s model.</source>
        <translation>ライブラリが、アバターのモデルなしで作られています。</translation>
    </message>
    <message>
        <source>Player %1 never shows &quot;%2&quot; after another labelled action.</source>
        <translation>選手%1の「%2」が、ラベル付きの動作に続くことはありません。</translation>
    </message>
    <message>
        <source>A weight is 0 (never) or a positive factor.</source>
        <translation>重みは0 (使わない) か正の倍率です。</translation>
    </message>
    <message>
        <source>A temperature is 0 or positive.</source>
        <translation>温度は0か正の数です。</translation>
    </message>
    <message>
        <source>No action of the avatar is followed by half a second of its take.</source>
        <translation>アバターの動作に、後にテイクが0.5 s以上続くものがありません。</translation>
    </message>
    <message>
        <source>The action has no frame.</source>
        <translation>動作にフレームがありません。</translation>
    </message>
    <message>
        <source>The threshold of pose clusters must be a positive number.</source>
        <translation>ポーズのクラスターのしきい値は正の数にしてください。</translation>
    </message>
    <message>
        <source>The block &quot;%1&quot; has no motion.</source>
        <translation>ブロック「%1」に動きがありません。</translation>
    </message>
    <message>
        <source>Frames %1:%2 cannot be taken from &quot;%3&quot;, which has %4.</source>
        <translation>フレーム%1:%2は「%3」から取り出せません。あるのは%4フレームです。</translation>
    </message>
    <message>
        <source>The block &quot;%1&quot; has no frame.</source>
        <translation>ブロック「%1」にフレームがありません。</translation>
    </message>
    <message>
        <source>The sequence has no block.</source>
        <translation>シーケンスにブロックがありません。</translation>
    </message>
    <message>
        <source>There is no path in the graph between these two actions; choose a curve, or clips played backward.</source>
        <translation>この2つの動作の間には、グラフ上の経路がありません。曲線か、クリップの逆再生を選んでください。</translation>
    </message>
    <message>
        <source>There are %1 candidate paths, counted from 0: no path %2.</source>
        <translation>経路の候補は%1本です (0から数えます)。経路%2はありません。</translation>
    </message>
    <message>
        <source>A transition needs motion on both sides.</source>
        <translation>遷移には、前後両方にモーションが必要です。</translation>
    </message>
    <message>
        <source>%1 (%2–%3 s, fighter %4): %5</source>
        <translation>%1 (%2～%3 s、選手%4): %5</translation>
    </message>
    <message>
        <source>at least one whole frame</source>
        <translation>1つ以上の完全なフレーム</translation>
    </message>
    <message>
        <source>the number of a frame</source>
        <translation>フレームの番号</translation>
    </message>
    <message>
        <source>a bone of the skeleton that has a dof, or the number of the frame after %1</source>
        <translation>dofのあるスケルトンのボーン、または%1の次のフレームの番号</translation>
    </message>
    <message>
        <source>each bone once in frame %1</source>
        <translation>フレーム%1で各ボーン1回ずつ</translation>
    </message>
    <message>
        <source>a number for bone %1 in frame %2</source>
        <translation>フレーム%2のボーン%1の数値</translation>
    </message>
    <message>
        <source>only %1 numbers for bone %2 in frame %3</source>
        <translation>フレーム%3のボーン%2には数値%1個だけ</translation>
    </message>
    <message>
        <source>a section of an ASF file, such as :units or :bonedata</source>
        <translation>:unitsや:bonedataなど、ASFファイルのセクション</translation>
    </message>
    <message>
        <source>the section :root</source>
        <translation>セクション:root</translation>
    </message>
    <message>
        <source>the section :hierarchy</source>
        <translation>セクション:hierarchy</translation>
    </message>
    <message>
        <source>deg or rad</source>
        <translation>degかrad</translation>
    </message>
    <message>
        <source>order, axis, position or orientation</source>
        <translation>order、axis、position、orientationのいずれか</translation>
    </message>
    <message>
        <source>10000 bones at most</source>
        <translation>10000個以内のボーン</translation>
    </message>
    <message>
        <source>end, behind the last line of a bone</source>
        <translation>ボーンの最後の行の後のend</translation>
    </message>
    <message>
        <source>the name of a bone of :bonedata, or end</source>
        <translation>:bonedataのボーンの名前、またはend</translation>
    </message>
    <message>
        <source>an order of rotations, such as XYZ</source>
        <translation>XYZなど、回転の順序</translation>
    </message>
    <message>
        <source>each degree of freedom once</source>
        <translation>各自由度1回ずつ</translation>
    </message>
    <message>
        <source>OFFSET, CHANNELS, JOINT, End Site or } in joint %1</source>
        <translation>関節%1のOFFSET、CHANNELS、JOINT、End Site、または}</translation>
    </message>
    <message>
        <source>the number of channels, 0 to 6</source>
        <translation>チャンネルの数 (0～6)</translation>
    </message>
    <message>
        <source>each channel once in a joint</source>
        <translation>1つの関節に各チャンネル1回ずつ</translation>
    </message>
    <message>
        <source>channel %1 of %2: Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation</source>
        <translation>%2個中%1番目のチャンネル: Xposition、Yposition、Zposition、Xrotation、Yrotation、Zrotationのいずれか</translation>
    </message>
    <message>
        <source>a finite number with a decimal point</source>
        <translation>小数点を使った有限の数</translation>
    </message>
    <message>
        <source>no action of the opponent at that time</source>
        <translation>その時刻に相手の動作がありません</translation>
    </message>
    <message>
        <source>the opponent&apos;s action is no attack</source>
        <translation>相手の動作は攻撃ではありません</translation>
    </message>
    <message>
        <source>stands left</source>
        <translation>左足立ち</translation>
    </message>
    <message>
        <source>stands right</source>
        <translation>右足立ち</translation>
    </message>
    <message>
        <source>in the air</source>
        <translation>空中</translation>
    </message>
    <message>
        <source>opponent&apos;s %1, closing only %2 m/s</source>
        <translation>相手の%1、接近は%2 m/sのみ</translation>
    </message>
    <message>
        <source>opponent&apos;s %1, closing %2 m/s</source>
        <translation>相手の%1、接近%2 m/s</translation>
    </message>
    <message>
        <source>%1 at the beginning, %2 at the end</source>
        <translation>開始時は%1、終了時は%2</translation>
    </message>
    <message>
        <source>There is no root %1; the recording has %2.</source>
        <translation>ルート%1はありません。収録にあるのは%2です。</translation>
    </message>
    <message>
        <source>The body stands on its head most of the time: is up right?</source>
        <translation>体がほとんどの時間、逆さに立っています。上方向は正しいですか？</translation>
    </message>
    <message>
        <source>The legs would be %1 m long: is the unit (%2) right?</source>
        <translation>脚の長さが %1 m になります。単位（%2）は正しいですか？</translation>
    </message>
    <message>
        <source>Relative to the legs the target&apos;s arms are %1 % longer: hands do not reach the same places.</source>
        <translation>リターゲット先は、脚に対して腕が%1%長くなっています。手の届く位置が変わります。</translation>
    </message>
    <message>
        <source>Relative to the legs the target&apos;s arms are %1 % shorter: hands do not reach the same places.</source>
        <translation>リターゲット先は、脚に対して腕が%1%短くなっています。手の届く位置が変わります。</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>%1 行目</translation>
    </message>
    <message>
        <source>frames %1:%2 cannot be taken from a recording of %3 frames.</source>
        <translation>フレーム %1:%2 は、%3 フレームの収録から取り出せません。</translation>
    </message>
    <message>
        <source>found %1 data, expected BVH or ASF/AMC: import it into Blender and export it as Motion Capture (.bvh).</source>
        <translation>%1 のデータです。必要なのは BVH か ASF/AMC です。Blender に読み込み、Motion Capture (.bvh) として書き出してください。</translation>
    </message>
    <message>
        <source>the opponent&apos;s action is not labelled yet</source>
        <translation>相手の動作にはまだラベルがありません</translation>
    </message>
</context>
<context>
    <name>KeysSheet</name>
    <message>
        <source>Kumite: keys and mouse</source>
        <translation>Kumite: キーとマウス</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>pelvis</source>
        <translation>骨盤</translation>
    </message>
    <message>
        <source>spine</source>
        <translation>背骨</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>胸</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>首</translation>
    </message>
    <message>
        <source>head</source>
        <translation>頭</translation>
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
        <translation>左手首</translation>
    </message>
    <message>
        <source>left hip</source>
        <translation>左股関節</translation>
    </message>
    <message>
        <source>left knee</source>
        <translation>左膝</translation>
    </message>
    <message>
        <source>left ankle</source>
        <translation>左足首</translation>
    </message>
    <message>
        <source>left toe</source>
        <translation>左つま先</translation>
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
        <translation>右手首</translation>
    </message>
    <message>
        <source>right hip</source>
        <translation>右股関節</translation>
    </message>
    <message>
        <source>right knee</source>
        <translation>右膝</translation>
    </message>
    <message>
        <source>right ankle</source>
        <translation>右足首</translation>
    </message>
    <message>
        <source>right toe</source>
        <translation>右つま先</translation>
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
        <translation>蹴り</translation>
    </message>
    <message>
        <source>punch</source>
        <translation>突き</translation>
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
        <translation>左突き</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>前</translation>
    </message>
    <message>
        <source>back</source>
        <translation>後ろ</translation>
    </message>
    <message>
        <source>back and forward</source>
        <translation>後ろから前</translation>
    </message>
    <message>
        <source>forward and back</source>
        <translation>前から後ろ</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Right punch</source>
        <translation>右突き</translation>
    </message>
    <message>
        <source>Left kick</source>
        <translation>左蹴り</translation>
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
        <source>down and up</source>
        <translation>下から上</translation>
    </message>
    <message>
        <source>Right kick</source>
        <translation>右蹴り</translation>
    </message>
    <message>
        <source>Jump</source>
        <translation>ジャンプ</translation>
    </message>
    <message>
        <source>React</source>
        <translation>反応</translation>
    </message>
    <message>
        <source>to a kick</source>
        <translation>蹴りへ</translation>
    </message>
    <message>
        <source>to a punch</source>
        <translation>突きへ</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>left to left</source>
        <translation>左から左</translation>
    </message>
    <message>
        <source>left to right</source>
        <translation>左から右</translation>
    </message>
    <message>
        <source>left to flight</source>
        <translation>左から空中</translation>
    </message>
    <message>
        <source>right to left</source>
        <translation>右から左</translation>
    </message>
    <message>
        <source>right to right</source>
        <translation>右から右</translation>
    </message>
    <message>
        <source>right to flight</source>
        <translation>右から空中</translation>
    </message>
    <message>
        <source>flight to left</source>
        <translation>空中から左</translation>
    </message>
    <message>
        <source>flight to right</source>
        <translation>空中から右</translation>
    </message>
    <message>
        <source>flight to flight</source>
        <translation>空中から空中</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>何もなし</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Key: %1</source>
        <translation>キー: %1</translation>
    </message>
</context>
<context>
    <name>kumite</name>
    <message>
        <source>Male means (de Leva 1996)</source>
        <translation>男性の平均 (de Leva 1996)</translation>
    </message>
    <message>
        <source>Female means (de Leva 1996)</source>
        <translation>女性の平均 (de Leva 1996)</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>今日 %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>昨日 %1</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>極小</translation>
    </message>
    <message>
        <source>foot contact</source>
        <translation>足の接地</translation>
    </message>
    <message>
        <source>boundary of the other</source>
        <translation>他方の境界</translation>
    </message>
    <message>
        <source>playhead</source>
        <translation>再生ヘッド</translation>
    </message>
</context>
<context>
    <name>kumite::studio</name>
    <message>
        <source>example, sample, tutorial, try</source>
        <translation>例, サンプル, チュートリアル, 試す, デモ</translation>
    </message>
    <message>
        <source>import, load, bvh, amc, asf, mocap, motion capture, new project</source>
        <translation>インポート, 読み込み, bvh, amc, asf, モキャプ, モーションキャプチャ, 新規プロジェクト</translation>
    </message>
    <message>
        <source>load, kumite file</source>
        <translation>読み込み, 開く, kumiteファイル</translation>
    </message>
    <message>
        <source>store, write</source>
        <translation>保存, 保管, 書き込み</translation>
    </message>
    <message>
        <source>copy, rename project, duplicate</source>
        <translation>コピー, プロジェクト名の変更, 複製, 別名</translation>
    </message>
    <message>
        <source>backup, restore, earlier, revert, snapshot</source>
        <translation>バックアップ, 復元, 以前の版, 戻す, スナップショット, バージョン</translation>
    </message>
    <message>
        <source>csv, json, table, spreadsheet, results, segmentation</source>
        <translation>csv, json, 表, スプレッドシート, 結果, 分割</translation>
    </message>
    <message>
        <source>bvh, skeleton, animation, blender, mocap</source>
        <translation>bvh, スケルトン, 骨格, アニメーション, blender, モキャプ</translation>
    </message>
    <message>
        <source>missing, relink, locate, moved</source>
        <translation>見つからない, 再リンク, 探す, 移動した</translation>
    </message>
    <message>
        <source>exit, close, leave</source>
        <translation>終了, 閉じる, 退出</translation>
    </message>
    <message>
        <source>back, revert, oops</source>
        <translation>戻る, 取り消し, 元に戻す, 間違えた</translation>
    </message>
    <message>
        <source>again, repeat</source>
        <translation>もう一度, 繰り返し, やり直し</translation>
    </message>
    <message>
        <source>settings, options, configuration, shortcuts, autosave</source>
        <translation>設定, オプション, 構成, ショートカット, 自動保存</translation>
    </message>
    <message>
        <source>import, new, load, clip, session</source>
        <translation>インポート, 新規, 読み込み, クリップ, セッション</translation>
    </message>
    <message>
        <source>name, title</source>
        <translation>名前, 名称, タイトル</translation>
    </message>
    <message>
        <source>delete, close, clip</source>
        <translation>削除, 閉じる, クリップ</translation>
    </message>
    <message>
        <source>previous clip, switch</source>
        <translation>前のクリップ, 切り替え</translation>
    </message>
    <message>
        <source>next clip, switch</source>
        <translation>次のクリップ, 切り替え</translation>
    </message>
    <message>
        <source>switch, opponent, toggle, player</source>
        <translation>切り替え, 相手, トグル, プレイヤー</translation>
    </message>
    <message>
        <source>joints, roles, skeleton, rate, offset, sync, floor, body model, mass</source>
        <translation>関節, 役割, スケルトン, レート, オフセット, 同期, 床, 身体モデル, 質量</translation>
    </message>
    <message>
        <source>exchange, colours, player</source>
        <translation>交換, 入れ替え, 色, プレイヤー</translation>
    </message>
    <message>
        <source>warnings, problems, errors, log, report</source>
        <translation>警告, 問題, エラー, ログ, 報告</translation>
    </message>
    <message>
        <source>delete, erase, clear, undelete, merge, cut</source>
        <translation>削除, 消去, クリア, 復活, 結合, カット</translation>
    </message>
    <message>
        <source>split, cut, insert, new, razor, slice, mark, here</source>
        <translation>分割, カット, 挿入, 新規, カミソリ, スライス, 印, ここ</translation>
    </message>
    <message>
        <source>merge left, combine, previous</source>
        <translation>左と結合, 統合, 前</translation>
    </message>
    <message>
        <source>merge right, combine, next</source>
        <translation>右と結合, 統合, 次</translation>
    </message>
    <message>
        <source>nudge left, shift</source>
        <translation>左へずらす, 移動</translation>
    </message>
    <message>
        <source>nudge right, shift</source>
        <translation>右へずらす, 移動</translation>
    </message>
    <message>
        <source>repeat, zoom to action, segment</source>
        <translation>繰り返し, 動作を拡大, 区間</translation>
    </message>
    <message>
        <source>comment, annotate, remark, text, label</source>
        <translation>コメント, 注釈, 備考, テキスト, ラベル, メモ</translation>
    </message>
    <message>
        <source>review, suspicious, error, uncertain, queue</source>
        <translation>確認, 疑わしい, 誤り, 不確か, キュー</translation>
    </message>
    <message>
        <source>review, suspicious</source>
        <translation>確認, 疑わしい</translation>
    </message>
    <message>
        <source>accept, approve, confirm, ok, yes, good</source>
        <translation>承認, 採用, 確認, ok, はい, 良い</translation>
    </message>
    <message>
        <source>reject, delete, dismiss, discard, no, false, wrong</source>
        <translation>却下, 削除, 除外, 破棄, いいえ, 誤り, 間違い</translation>
    </message>
    <message>
        <source>reset, reopen, undecided, withdraw</source>
        <translation>リセット, 再開, 未決定, 取り下げ</translation>
    </message>
    <message>
        <source>difference, a/b, versus, parameters</source>
        <translation>違い, 差, a/b, 対比, パラメーター</translation>
    </message>
    <message>
        <source>raw, unfiltered, noise</source>
        <translation>生データ, フィルターなし, ノイズ</translation>
    </message>
    <message>
        <source>com, cog, gravity</source>
        <translation>com, cog, 重心, 重力</translation>
    </message>
    <message>
        <source>velocity, wrist, punch</source>
        <translation>速度, 手首, 突き, パンチ</translation>
    </message>
    <message>
        <source>velocity, ankle, kick</source>
        <translation>速度, 足首, 蹴り, キック</translation>
    </message>
    <message>
        <source>seconds, frames, timecode</source>
        <translation>秒, フレーム, タイムコード</translation>
    </message>
    <message>
        <source>start, stop, run</source>
        <translation>開始, 停止, 実行</translation>
    </message>
    <message>
        <source>pause, halt</source>
        <translation>一時停止, 停止</translation>
    </message>
    <message>
        <source>rewind, shuttle</source>
        <translation>巻き戻し, シャトル</translation>
    </message>
    <message>
        <source>fast forward, shuttle</source>
        <translation>早送り, シャトル</translation>
    </message>
    <message>
        <source>previous frame, step</source>
        <translation>前のフレーム, コマ送り</translation>
    </message>
    <message>
        <source>next frame, step</source>
        <translation>次のフレーム, コマ送り</translation>
    </message>
    <message>
        <source>beginning, first frame, rewind</source>
        <translation>先頭, 最初のフレーム, 巻き戻し</translation>
    </message>
    <message>
        <source>last frame</source>
        <translation>最後のフレーム, 末尾</translation>
    </message>
    <message>
        <source>slow motion, speed, rate</source>
        <translation>スローモーション, 速度, レート</translation>
    </message>
    <message>
        <source>speed up, rate</source>
        <translation>速くする, レート</translation>
    </message>
    <message>
        <source>repeat, cycle</source>
        <translation>繰り返し, 循環</translation>
    </message>
    <message>
        <source>in point, mark in, start, range</source>
        <translation>イン点, 開始点, 開始, 範囲</translation>
    </message>
    <message>
        <source>out point, mark out, end, range</source>
        <translation>アウト点, 終了点, 終了, 範囲</translation>
    </message>
    <message>
        <source>fit, frame all, zoom out, home, reset view</source>
        <translation>合わせる, 全体表示, 縮小, ホーム, 表示リセット</translation>
    </message>
    <message>
        <source>frame selected, zoom in, focus, centre</source>
        <translation>選択を表示, 拡大, フォーカス, 中央</translation>
    </message>
    <message>
        <source>sidebar, show panels, focus mode</source>
        <translation>サイドバー, パネル表示, 集中モード</translation>
    </message>
    <message>
        <source>maximise, maximize</source>
        <translation>最大化, 全画面</translation>
    </message>
    <message>
        <source>font size, zoom, bigger, accessibility, scale</source>
        <translation>文字の大きさ, ズーム, 大きく, アクセシビリティ, 拡大</translation>
    </message>
    <message>
        <source>font size, zoom, scale</source>
        <translation>文字の大きさ, ズーム, 拡大</translation>
    </message>
    <message>
        <source>dark mode, light mode, colours, auto</source>
        <translation>ダークモード, ライトモード, 色, 自動</translation>
    </message>
    <message>
        <source>light mode, bright, white, day, colours</source>
        <translation>ライトモード, 明るい, 白, 昼, 色</translation>
    </message>
    <message>
        <source>dark mode, black, night, colours</source>
        <translation>ダークモード, 黒, 夜, 色</translation>
    </message>
    <message>
        <source>camera, front view</source>
        <translation>カメラ, 正面</translation>
    </message>
    <message>
        <source>camera, side view, left, right, profile</source>
        <translation>カメラ, 側面, 左, 右, 横顔</translation>
    </message>
    <message>
        <source>camera, top view, bird</source>
        <translation>カメラ, 上面, 俯瞰</translation>
    </message>
    <message>
        <source>camera, behind, third person</source>
        <translation>カメラ, 後ろ, 三人称</translation>
    </message>
    <message>
        <source>camera, track</source>
        <translation>カメラ, 追跡</translation>
    </message>
    <message>
        <source>footsteps, feet, ground</source>
        <translation>足跡, 足, 地面</translation>
    </message>
    <message>
        <source>trajectory, path, motion trail</source>
        <translation>軌道, 経路, 軌跡</translation>
    </message>
    <message>
        <source>com, cog, center, gravity</source>
        <translation>com, cog, 中心, 重心, 重力</translation>
    </message>
    <message>
        <source>arrow, vector, ground reaction</source>
        <translation>矢印, ベクトル, 床反力</translation>
    </message>
    <message>
        <source>onion skin</source>
        <translation>オニオンスキン, 残像</translation>
    </message>
    <message>
        <source>onion skin, pose, stamp</source>
        <translation>オニオンスキン, ポーズ, スタンプ, 残像</translation>
    </message>
    <message>
        <source>delete ghosts, onion skin</source>
        <translation>ゴーストを削除, オニオンスキン</translation>
    </message>
    <message>
        <source>distance, ruler, speed, tape</source>
        <translation>距離, 定規, 速度, 巻き尺</translation>
    </message>
    <message>
        <source>screenshot, clipboard, image</source>
        <translation>スクリーンショット, クリップボード, 画像</translation>
    </message>
    <message>
        <source>screenshot, render, image, png, export picture, capture</source>
        <translation>スクリーンショット, レンダリング, 画像, png, 画像の書き出し, キャプチャ</translation>
    </message>
    <message>
        <source>start, stop, preview</source>
        <translation>開始, 停止, プレビュー</translation>
    </message>
    <message>
        <source>jump back, skip</source>
        <translation>戻る, ジャンプ, スキップ</translation>
    </message>
    <message>
        <source>jump forward, skip</source>
        <translation>進む, ジャンプ, スキップ</translation>
    </message>
    <message>
        <source>preview, result, assembled, synthesised, before, after</source>
        <translation>プレビュー, 結果, 合成, 組み立て, 前, 後</translation>
    </message>
    <message>
        <source>punch, kick, strike, aim, reach, target tool</source>
        <translation>突き, 蹴り, 打撃, パンチ, キック, 狙う, 届く, ターゲット</translation>
    </message>
    <message>
        <source>insert key, new pose, keyframe, set key</source>
        <translation>キーを挿入, 新しいポーズ, キーフレーム, キーを打つ</translation>
    </message>
    <message>
        <source>delete key, erase</source>
        <translation>キーを削除, 消去</translation>
    </message>
    <message>
        <source>previous keyframe, jump</source>
        <translation>前のキーフレーム, ジャンプ</translation>
    </message>
    <message>
        <source>next keyframe, jump</source>
        <translation>次のキーフレーム, ジャンプ</translation>
    </message>
    <message>
        <source>nudge left, time, shift</source>
        <translation>左へずらす, 時間, 移動</translation>
    </message>
    <message>
        <source>nudge right, time, shift</source>
        <translation>右へずらす, 時間, 移動</translation>
    </message>
    <message>
        <source>duplicate key, clone, paste</source>
        <translation>キーを複製, コピー, 貼り付け</translation>
    </message>
    <message>
        <source>flip, left, right, symmetry, reverse</source>
        <translation>反転, 左, 右, 対称, ミラー, 逆</translation>
    </message>
    <message>
        <source>grab, capture, snapshot, recording</source>
        <translation>取り込み, キャプチャ, スナップショット, 収録</translation>
    </message>
    <message>
        <source>paste pose, browse, frame, library, import pose</source>
        <translation>ポーズの貼り付け, 参照, フレーム, ライブラリ, ポーズの読み込み</translation>
    </message>
    <message>
        <source>rotate, gizmo, ring, fk, angle, elbow, knee</source>
        <translation>回転, ギズモ, リング, fk, 角度, 肘, 膝</translation>
    </message>
    <message>
        <source>rotate, gizmo, ring, fk, angle</source>
        <translation>回転, ギズモ, リング, fk, 角度</translation>
    </message>
    <message>
        <source>ripple, shift, time, slide left</source>
        <translation>ずらす, 時間, 左へ</translation>
    </message>
    <message>
        <source>ripple, shift, time, slide right</source>
        <translation>ずらす, 時間, 右へ</translation>
    </message>
    <message>
        <source>retime, faster, speed up, compress, scale time</source>
        <translation>時間調整, 速く, 加速, 縮める, 時間の拡縮</translation>
    </message>
    <message>
        <source>retime, slower, slow down, stretch, scale time</source>
        <translation>時間調整, 遅く, 減速, 伸ばす, 時間の拡縮</translation>
    </message>
    <message>
        <source>before, after, compare, side by side, a/b, unadjusted</source>
        <translation>前, 後, 比較, 並べる, a/b, 調整なし</translation>
    </message>
    <message>
        <source>onion skin, onion skinning, ghost</source>
        <translation>オニオンスキン, 残像, ゴースト</translation>
    </message>
    <message>
        <source>partial edit, swap arm, splice, layer, fix, retake</source>
        <translation>部分編集, 腕の差し替え, 接合, レイヤー, 修正, 撮り直し</translation>
    </message>
    <message>
        <source>tab, panel, joint, handle</source>
        <translation>タブ, パネル, 関節, ハンドル</translation>
    </message>
    <message>
        <source>tab, panel, find similar, retrieval, sources, parts</source>
        <translation>タブ, パネル, 類似検索, 検索, 元, 部位</translation>
    </message>
    <message>
        <source>lock, fix, nail, constraint, hold foot</source>
        <translation>ロック, 固定, 釘, 拘束, 足を固定</translation>
    </message>
    <message>
        <source>effector, hand, foot, ik, select</source>
        <translation>エフェクター, 手, 足, ik, 選択</translation>
    </message>
    <message>
        <source>raise, nudge, ik</source>
        <translation>上げる, ずらす, ik</translation>
    </message>
    <message>
        <source>lower, nudge, ik</source>
        <translation>下げる, ずらす, ik</translation>
    </message>
    <message>
        <source>nudge, ik, left</source>
        <translation>ずらす, ik, 左</translation>
    </message>
    <message>
        <source>nudge, ik, right</source>
        <translation>ずらす, ik, 右</translation>
    </message>
    <message>
        <source>nudge, ik, back</source>
        <translation>ずらす, ik, 後ろ</translation>
    </message>
    <message>
        <source>nudge, ik, forward</source>
        <translation>ずらす, ik, 前</translation>
    </message>
    <message>
        <source>source, automatic, best match, reset</source>
        <translation>出所, 自動, 最良の一致, リセット</translation>
    </message>
    <message>
        <source>delete all, reset, start over</source>
        <translation>すべて削除, リセット, 最初から</translation>
    </message>
    <message>
        <source>import, library, load, bvh</source>
        <translation>インポート, ライブラリ, 読み込み, bvh</translation>
    </message>
    <message>
        <source>import, library, directory, bvh</source>
        <translation>インポート, ライブラリ, フォルダー, bvh</translation>
    </message>
    <message>
        <source>save, bake, new take</source>
        <translation>保存, ベイク, 新規テイク</translation>
    </message>
    <message>
        <source>save, bvh, gltf, glb, animation</source>
        <translation>保存, bvh, gltf, glb, アニメーション</translation>
    </message>
    <message>
        <source>beginning, rewind</source>
        <translation>先頭, 巻き戻し</translation>
    </message>
    <message>
        <source>repeat, cycle, endless</source>
        <translation>繰り返し, 循環, 無限</translation>
    </message>
    <message>
        <source>play live, game, controller, real time</source>
        <translation>ライブ再生, ゲーム, コントローラー, リアルタイム</translation>
    </message>
    <message>
        <source>stop live, end</source>
        <translation>ライブ停止, 終了</translation>
    </message>
    <message>
        <source>insert, append, clip, action</source>
        <translation>挿入, 追加, クリップ, 動作</translation>
    </message>
    <message>
        <source>replace, exchange, other action</source>
        <translation>置き換え, 交換, 別の動作</translation>
    </message>
    <message>
        <source>delete, erase, cut</source>
        <translation>削除, 消去, カット</translation>
    </message>
    <message>
        <source>select, jump</source>
        <translation>選択, ジャンプ</translation>
    </message>
    <message>
        <source>move left, reorder</source>
        <translation>左へ移動, 並べ替え</translation>
    </message>
    <message>
        <source>move right, reorder</source>
        <translation>右へ移動, 並べ替え</translation>
    </message>
    <message>
        <source>repeat, again, loop</source>
        <translation>繰り返し, もう一度, ループ</translation>
    </message>
    <message>
        <source>repeat less</source>
        <translation>繰り返しを減らす</translation>
    </message>
    <message>
        <source>trim, in point, cut start</source>
        <translation>トリム, イン点, 頭を切る</translation>
    </message>
    <message>
        <source>trim, out point, cut end</source>
        <translation>トリム, アウト点, 末尾を切る</translation>
    </message>
    <message>
        <source>untrim, reset</source>
        <translation>トリム解除, リセット</translation>
    </message>
    <message>
        <source>random, reroll, blend, other path</source>
        <translation>ランダム, 引き直し, ブレンド, 別の経路</translation>
    </message>
    <message>
        <source>random, reroll, shuffle</source>
        <translation>ランダム, 引き直し, シャッフル</translation>
    </message>
    <message>
        <source>fix, hold, keep</source>
        <translation>固定, 保持, 維持, ロック</translation>
    </message>
    <message>
        <source>delete all, new, reset</source>
        <translation>すべて削除, 新規, リセット</translation>
    </message>
    <message>
        <source>search, filter, actions</source>
        <translation>検索, 絞り込み, 動作</translation>
    </message>
    <message>
        <source>library, list, show</source>
        <translation>ライブラリ, 一覧, 表示</translation>
    </message>
    <message>
        <source>clusters, poses, graph, space</source>
        <translation>クラスター, ポーズ, グラフ, 空間</translation>
    </message>
    <message>
        <source>manual, documentation, guide</source>
        <translation>マニュアル, 説明書, ドキュメント, ガイド</translation>
    </message>
    <message>
        <source>tutorial, introduction, start, guide</source>
        <translation>チュートリアル, 入門, 開始, ガイド</translation>
    </message>
    <message>
        <source>formula, explain, statistics, papers, sources</source>
        <translation>式, 説明, 統計, 論文, 出典</translation>
    </message>
    <message>
        <source>tutorial, introduction, walkthrough, wizard, guide</source>
        <translation>チュートリアル, 入門, ツアー, ウィザード, ガイド</translation>
    </message>
    <message>
        <source>explain, context help</source>
        <translation>説明, 状況ヘルプ</translation>
    </message>
    <message>
        <source>explain, accessibility</source>
        <translation>説明, アクセシビリティ</translation>
    </message>
    <message>
        <source>shortcuts, hotkeys, cheat sheet, help, manual, print</source>
        <translation>ショートカット, ホットキー, 早見表, ヘルプ, マニュアル, 印刷</translation>
    </message>
    <message>
        <source>release notes, changelog, news, version</source>
        <translation>リリースノート, 変更履歴, 新着, バージョン</translation>
    </message>
    <message>
        <source>version, licence, license</source>
        <translation>バージョン, 版, ライセンス</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ActionTiles</name>
    <message>
        <source>Similar actions</source>
        <translation>似た動作</translation>
    </message>
    <message>
        <source>Those that look most like the current action, side by side.</source>
        <translation>現在の動作に最も似たものを並べます。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ActionsModel</name>
    <message>
        <source>%1, %2 from %3
Return adds it, Shift+Return swaps it for the chosen block</source>
        <translation>%1、%3の%2
Returnで追加、Shift+Returnで選んだブロックと交換</translation>
    </message>
    <message>
        <source>action</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>where</source>
        <translation>場所</translation>
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
        <translation>試合の時刻</translation>
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
        <translation>アバター: %1</translation>
    </message>
    <message>
        <source>The analysis is not finished yet.</source>
        <translation>解析がまだ終わっていません。</translation>
    </message>
    <message>
        <source>Keep the bout as a take</source>
        <translation>試合をテイクとして残す</translation>
    </message>
    <message>
        <source>Recordings, NAME-1 and NAME-2 (*.bvh)</source>
        <translation>収録、NAME-1とNAME-2 (*.bvh)</translation>
    </message>
    <message>
        <source>Keeping the bout</source>
        <translation>試合を保存中</translation>
    </message>
    <message>
        <source>The project changed while the bout was written. Its files are there; open them as a take, or keep it again under another name.</source>
        <translation>試合の書き出し中にプロジェクトが変わりました。ファイルはできています。テイクとして開くか、別の名前でもう一度残してください。</translation>
    </message>
    <message>
        <source>Kept as take %1. Detection alone finds %2 % and %3 % of its boundaries.</source>
        <translation>テイク%1として残しました。検出だけで境界の%2 %と%3 %が見つかります。</translation>
    </message>
    <message>
        <source>Writing the bout</source>
        <translation>試合を書き出し中</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Export the bout</source>
        <translation>試合を書き出す</translation>
    </message>
    <message>
        <source>Motion of both, NAME-1 and NAME-2 (*.bvh);;glTF: skeletons and animation (*.glb);;Pictures, 30 a second (*.png);;Video, by ffmpeg (*.mp4);;Log: everything that makes it again (*.json)</source>
        <translation>両者のモーション、NAME-1とNAME-2 (*.bvh);;glTF: スケルトンとアニメーション (*.glb);;画像、毎秒30枚 (*.png);;動画、ffmpeg使用 (*.mp4);;ログ: 再現に必要なすべて (*.json)</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>キャンセルしました。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き出しました: %1</translation>
    </message>
    <message>
        <source>&amp;Bout</source>
        <translation>試合(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Fight or pause</source>
        <translation>戦う／一時停止(&amp;F)</translation>
    </message>
    <message>
        <source>Begin a&amp;new</source>
        <translation>始めからやり直す(&amp;N)</translation>
    </message>
    <message>
        <source>Begin with the next &amp;seed</source>
        <translation>次のシードで始める(&amp;S)</translation>
    </message>
    <message>
        <source>Go on from here with other &amp;draws</source>
        <translation>ここから別の抽選で続ける(&amp;D)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>1フレーム戻る</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>1フレーム進む</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>1秒戻る</translation>
    </message>
    <message>
        <source>One second on</source>
        <translation>1秒進む</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>先頭へ</translation>
    </message>
    <message>
        <source>To the end of what was shown</source>
        <translation>表示済みの末尾へ</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>遅く</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>速く</translation>
    </message>
    <message>
        <source>&amp;Automatic: the model decides</source>
        <translation>自動: モデルが決める(&amp;A)</translation>
    </message>
    <message>
        <source>A&amp;vatar: keys lead one fighter</source>
        <translation>アバター: キーで一方の選手を操作(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Passive: one answers a captured attack</source>
        <translation>受け身: 一方が収録された攻撃に応じる(&amp;P)</translation>
    </message>
    <message>
        <source>Avatar: key %1</source>
        <translation>アバター: キー%1</translation>
    </message>
    <message>
        <source>Avatar: forget &amp;what was asked for</source>
        <translation>アバター: 指示を忘れる(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Measure the quality</source>
        <translation>品質を測る(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Keep as a take…</source>
        <translation>テイクとして残す(&amp;K)…</translation>
    </message>
    <message>
        <source>E&amp;xport the bout…</source>
        <translation>試合を書き出す(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutExport</name>
    <message>
        <source>%1: it cannot be written there.</source>
        <translation>%1: そこには書き込めません。</translation>
    </message>
    <message>
        <source>There is no ffmpeg on this computer, which a video needs: install it (on Debian and Ubuntu: sudo apt install ffmpeg), or export pictures (.png).</source>
        <translation>動画に必要なffmpegがこのコンピューターにありません。インストールするか (DebianとUbuntuでは: sudo apt install ffmpeg)、画像 (.png) を書き出してください。</translation>
    </message>
    <message>
        <source>%1 cannot be started.</source>
        <translation>%1を起動できません。</translation>
    </message>
    <message>
        <source>ffmpeg could not write the video: %1</source>
        <translation>ffmpegが動画を書き出せませんでした: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutPage</name>
    <message>
        <source>Why there is no bout</source>
        <translation>試合がない理由</translation>
    </message>
    <message>
        <source>Anew</source>
        <translation>最初から</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>残す…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出す…</translation>
    </message>
    <message>
        <source>A bout that goes on for ever, made from what was learnt of the labelled actions, appears here.</source>
        <translation>ラベル付きの動作から学んだことで作られる、終わりのない試合がここに表示されます。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutPanel</name>
    <message>
        <source>foot skate</source>
        <translation>足滑り</translation>
    </message>
    <message>
        <source>Share of frames in which a foot near the floor slides faster than 0.5 m/s</source>
        <translation>床の近くで足が0.5 m/sより速く滑るフレームの割合</translation>
    </message>
    <message>
        <source>in the floor</source>
        <translation>床へのめり込み</translation>
    </message>
    <message>
        <source>Share of frames with a foot more than 5 mm in the floor</source>
        <translation>足が床に5 mmより深く入るフレームの割合</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>重なり</translation>
    </message>
    <message>
        <source>Share of frames with the bodies more than 3 cm in each other</source>
        <translation>両者の体が3 cmより深く重なるフレームの割合</translation>
    </message>
    <message>
        <source>joins</source>
        <translation>つなぎ目</translation>
    </message>
    <message>
        <source>Joint accelerations where actions are joined, their 99th percentile over that inside recorded actions</source>
        <translation>動作のつなぎ目での関節加速度。99パーセンタイルを、収録された動作内のそれで割った値</translation>
    </message>
    <message>
        <source>facing</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>Mean angle between where a fighter faces and its opponent</source>
        <translation>選手の向きと相手の方向との角度の平均</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Mean distance between both fighters</source>
        <translation>両選手の距離の平均</translation>
    </message>
    <message>
        <source>hit timing</source>
        <translation>反応のずれ</translation>
    </message>
    <message>
        <source>How far reactions are from their due moment, on average</source>
        <translation>反応があるべき瞬間からのずれの平均</translation>
    </message>
    <message>
        <source>variety</source>
        <translation>多様さ</translation>
    </message>
    <message>
        <source>Share of distinct runs of three labels; falls with length</source>
        <translation>連続する3ラベルのうち異なるものの割合。長いほど下がります</translation>
    </message>
    <message>
        <source>reacts first</source>
        <translation>反応優先</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>測る</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Avatar</source>
        <translation>アバター</translation>
    </message>
    <message>
        <source>Passive</source>
        <translation>受け身</translation>
    </message>
    <message>
        <source>The model decides for both</source>
        <translation>両者ともモデルが決めます</translation>
    </message>
    <message>
        <source>Keys and pointer lead one fighter, the model the other</source>
        <translation>一方の選手はキーとポインターで、他方はモデルで動きます</translation>
    </message>
    <message>
        <source>One replays a captured attack that the model has not seen; the other answers and may not attack</source>
        <translation>一方はモデルが見たことのない収録済みの攻撃を再現し、他方はそれに応じて、攻撃はしません</translation>
    </message>
    <message>
        <source>Under attack the avatar may answer before it does as asked</source>
        <translation>攻撃を受けたとき、アバターは指示に従う前に応じてもかまいません</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>シード</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>シード</translation>
    </message>
    <message>
        <source>The same seed gives the same bout</source>
        <translation>同じシードなら同じ試合になります</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>0: always the likeliest; 1: as learnt; above: more even</source>
        <translation>0: 常に最有力、1: 学習どおり、それ以上: より均等</translation>
    </message>
    <message>
        <source>State of the bout</source>
        <translation>試合の状態</translation>
    </message>
    <message>
        <source>Why this?</source>
        <translation>なぜこれ?</translation>
    </message>
    <message>
        <source>The choice</source>
        <translation>この選択</translation>
    </message>
    <message>
        <source>What else it could have done</source>
        <translation>他にあり得たもの</translation>
    </message>
    <message>
        <source>A click takes another one and goes on from there</source>
        <translation>クリックすると別のものを選び、そこから続けます</translation>
    </message>
    <message>
        <source>It cannot be taken: %1.</source>
        <translation>選べません: %1。</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>品質</translation>
    </message>
    <message>
        <source>Measures all that was shown, beside the longest recording</source>
        <translation>表示されたすべてを測り、最も長い収録と並べます</translation>
    </message>
    <message>
        <source>Quality of the bout and of the recording</source>
        <translation>試合と収録の品質</translation>
    </message>
    <message>
        <source>bout</source>
        <translation>試合</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>収録</translation>
    </message>
    <message>
        <source>attacker</source>
        <translation>攻撃側</translation>
    </message>
    <message>
        <source>avatar</source>
        <translation>アバター</translation>
    </message>
    <message>
        <source>Who attacks</source>
        <translation>攻撃する選手</translation>
    </message>
    <message>
        <source>Who is led</source>
        <translation>操作する選手</translation>
    </message>
    <message>
        <source>The fighter that replays a captured attack</source>
        <translation>収録された攻撃を再現する選手</translation>
    </message>
    <message>
        <source>The fighter that keys and clicks on the floor lead</source>
        <translation>キーと床のクリックで操作する選手</translation>
    </message>
    <message>
        <source>A bout is being prepared.</source>
        <translation>試合を準備中です。</translation>
    </message>
    <message>
        <source>Keys 1 to 9 ask the avatar for something, a click on the floor says where to be.</source>
        <translation>キー1～9でアバターに指示し、床のクリックで位置を示します。</translation>
    </message>
    <message>
        <source>Asked for: %1</source>
        <translation>指示: %1</translation>
    </message>
    <message>
        <source>Labels or boundaries changed: begin anew to use them.</source>
        <translation>ラベルか境界が変わりました。反映するには始めからやり直してください。</translation>
    </message>
    <message>
        <source>Each choice, with all that could have been, appears here.</source>
        <translation>それぞれの選択が、あり得たすべてとともにここに表示されます。</translation>
    </message>
    <message>
        <source>%1 at %2, after %3, while %4</source>
        <translation>%2に%1、直前: %3、相手: %4</translation>
    </message>
    <message>
        <source>: replayed</source>
        <translation>: 再現</translation>
    </message>
    <message>
        <source>: chosen by hand</source>
        <translation>: 手動で選択</translation>
    </message>
    <message>
        <source>: as asked for</source>
        <translation>: 指示どおり</translation>
    </message>
    <message>
        <source> (no other stance was left)</source>
        <translation> (別の支持足は残っていません)</translation>
    </message>
    <message>
        <source>Measure (%1 s)</source>
        <translation>測る (%1 s)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutSession</name>
    <message>
        <source>anything</source>
        <translation>何でも</translation>
    </message>
    <message>
        <source>Preparing a bout</source>
        <translation>試合を準備中</translation>
    </message>
    <message>
        <source>Measuring the bout</source>
        <translation>試合を測定中</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutStrip</name>
    <message>
        <source>Actions of the bout</source>
        <translation>試合の動作</translation>
    </message>
    <message>
        <source>%1 · %2 to %3 · %4</source>
        <translation>%1 · %2～%3 · %4</translation>
    </message>
    <message>
        <source>   ·   as asked for</source>
        <translation>   ·   指示どおり</translation>
    </message>
    <message>
        <source>   ·   chosen by hand</source>
        <translation>   ·   手動で選択</translation>
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
        <translation>ラベル %1</translation>
    </message>
    <message>
        <source>geom. %1</source>
        <translation>幾何 %1</translation>
    </message>
    <message>
        <source>both %1</source>
        <translation>両方 %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CandidatesModel</name>
    <message>
        <source>no example</source>
        <translation>例なし</translation>
    </message>
    <message>
        <source>not in this mode</source>
        <translation>このモード外</translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation>指示外</translation>
    </message>
    <message>
        <source>other stance</source>
        <translation>別の支持足</translation>
    </message>
    <message>
        <source>banned</source>
        <translation>禁止</translation>
    </message>
    <message>
        <source>%1: chance %2, label term %3, geometry term %4, product %5</source>
        <translation>%1: 確率%2、ラベル項%3、幾何項%4、積%5</translation>
    </message>
    <message>
        <source>
Sample: %1, %2</source>
        <translation>
サンプル: %1、%2</translation>
    </message>
    <message>
        <source>
Could not be drawn: %1</source>
        <translation>
抽選の対象外: %1</translation>
    </message>
    <message>
        <source>
This was chosen</source>
        <translation>
これが選ばれました</translation>
    </message>
    <message>
        <source>
A click takes it instead</source>
        <translation>
クリックでこちらを選びます</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ClusterMap</name>
    <message>
        <source>Map of poses</source>
        <translation>ポーズの地図</translation>
    </message>
    <message>
        <source>A map of the poses appears here: like ones near each other, and the way that a transition takes.</source>
        <translation>ここにポーズの地図が表示されます。似たものが近くに並び、遷移の通る道が見えます。</translation>
    </message>
    <message>
        <source>%1 kinds of poses, like ones near each other · line: what leads where</source>
        <translation>ポーズ%1種類、似たものが近く · 線: つながり</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CommandPalette</name>
    <message>
        <source> · on</source>
        <translation> · オン</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>したいことを入力</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>A name, a menu or a word for it: ↑ ↓ choose, Return runs, Esc leaves</source>
        <translation>名前、メニュー、関連する言葉: ↑ ↓で選択、Returnで実行、Escで閉じる</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>%1 · “%2”</source>
        <translation>%1 · 「%2」</translation>
    </message>
    <message>
        <source>No command that can be run now is called “%1”.</source>
        <translation>「%1」という、今実行できるコマンドはありません。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CompareBox</name>
    <message>
        <source>Compare with settings B</source>
        <translation>設定Bと比較</translation>
    </message>
    <message>
        <source> B</source>
        <translation> B</translation>
    </message>
    <message>
        <source>Use B</source>
        <translation>Bを使う</translation>
    </message>
    <message>
        <source>Draw beside the project&apos;s boundaries (A) those that other settings give</source>
        <translation>プロジェクトの境界 (A) の横に、別の設定による境界を描きます</translation>
    </message>
    <message>
        <source>Boundaries that differ</source>
        <translation>異なる境界</translation>
    </message>
    <message>
        <source>On the timeline: ○ only in A, dotted lines only in B</source>
        <translation>タイムライン上: ○はAのみ、点線はBのみ</translation>
    </message>
    <message>
        <source>Cut the project by settings B</source>
        <translation>プロジェクトを設定Bで分割します</translation>
    </message>
    <message>
        <source>Comparing settings</source>
        <translation>設定を比較中</translation>
    </message>
    <message>
        <source>%1: %2 in both, %3 only A, %4 only B</source>
        <translation>%1: 両方%2、Aのみ%3、Bのみ%4</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CompareLabelsBox</name>
    <message>
        <source>Take theirs</source>
        <translation>他者を採用</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>自分を維持</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>観点</translation>
    </message>
    <message>
        <source>both</source>
        <translation>両方</translation>
    </message>
    <message>
        <source>same</source>
        <translation>一致</translation>
    </message>
    <message>
        <source>κ</source>
        <translation>κ</translation>
    </message>
    <message>
        <source>Agreement per aspect</source>
        <translation>観点ごとの一致</translation>
    </message>
    <message>
        <source>Both: actions of which both people said something. κ (Cohen): how much more often they say the same than by chance; 1 always, 0 as often as by chance.</source>
        <translation>両方: 二人とも何か付けた動作の数。κ (Cohen): 偶然よりどれだけ多く一致するか。1は常に一致、0は偶然と同じ。</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>違い</translation>
    </message>
    <message>
        <source>Their value, as said by a hand; goes on to the next (Enter)</source>
        <translation>他者の値を手動として採用し、次へ進みます (Enter)</translation>
    </message>
    <message>
        <source>What the project says stays; goes on to the next (Backspace)</source>
        <translation>プロジェクトの値を維持し、次へ進みます (Backspace)</translation>
    </message>
    <message>
        <source>Theirs for all that are not decided, as one step of the history</source>
        <translation>未決定のすべてに他者の値を採用します。履歴の1ステップです</translation>
    </message>
    <message>
        <source>Their labels where you have none, as said by a hand, in one step</source>
        <translation>自分のラベルがない所に他者のラベルを手動として入れます。1ステップです</translation>
    </message>
    <message>
        <source>The boundaries have changed. Open %1 once more to compare.</source>
        <translation>境界が変わりました。比較するには%1をもう一度開いてください。</translation>
    </message>
    <message>
        <source>Another person&apos;s labels are compared here with those of the project: Label &gt; Compare with labels of… opens their file.</source>
        <translation>他の人のラベルとプロジェクトのラベルをここで比べます。ラベル &gt; ラベルと比較… でファイルを開きます。</translation>
    </message>
    <message>
        <source>%1: 1 action labelled by both, %2 alike</source>
        <translation>%1: 両者がラベルを付けた動作1件、一致%2</translation>
    </message>
    <message>
        <source>%1: %3 actions labelled by both, %2 alike</source>
        <translation>%1: 両者がラベルを付けた動作%3件、一致%2</translation>
    </message>
    <message>
        <source>, κ %1</source>
        <translation>, κ %1</translation>
    </message>
    <message>
        <source>. No difference to decide.</source>
        <translation>。判断すべき違いはありません。</translation>
    </message>
    <message>
        <source>. 1 difference to decide.</source>
        <translation>。判断すべき違いが1件あります。</translation>
    </message>
    <message>
        <source>. %1 differences to decide.</source>
        <translation>。判断すべき違いが%1件あります。</translation>
    </message>
    <message>
        <source> Only you labelled %1 more.</source>
        <translation> 他に自分だけが付けたもの%1件。</translation>
    </message>
    <message>
        <source>Theirs for all %1</source>
        <translation>全%1件に他者を採用</translation>
    </message>
    <message>
        <source>Add the 1 that only they labelled</source>
        <translation>他者だけが付けた1件を追加</translation>
    </message>
    <message>
        <source>Add the %1 that only they labelled</source>
        <translation>他者だけが付けた%1件を追加</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ConfusionMatrix</name>
    <message>
        <source>no answer</source>
        <translation>回答なし</translation>
    </message>
    <message>
        <source>Confusion matrix</source>
        <translation>混同行列</translation>
    </message>
    <message>
        <source>by rule</source>
        <translation>ルール</translation>
    </message>
    <message>
        <source>by machine</source>
        <translation>機械</translation>
    </message>
    <message>
        <source>%1 by hand and %2: </source>
        <translation>手動と%2がともに%1: </translation>
    </message>
    <message>
        <source>%1 by hand, %2 %3: </source>
        <translation>手動は%1、%2は%3: </translation>
    </message>
    <message>
        <source>1 action</source>
        <translation>動作1件</translation>
    </message>
    <message>
        <source>%1 actions</source>
        <translation>動作%1件</translation>
    </message>
    <message>
        <source>, %1 of %2</source>
        <translation>, %2件中%1件</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DetectionBox</name>
    <message>
        <source>Warning about the cutoff</source>
        <translation>カットオフについての警告</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DifferencesModel</name>
    <message>
        <source>%1, %2, %3: mine %4, theirs %5</source>
        <translation>%1、%2、%3: 自分%4、他者%5</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>観点</translation>
    </message>
    <message>
        <source>mine</source>
        <translation>自分</translation>
    </message>
    <message>
        <source>theirs</source>
        <translation>他者</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DistanceGridView</name>
    <message>
        <source>Distances of poses where motions are joined</source>
        <translation>動きのつなぎ目でのポーズの距離</translation>
    </message>
    <message>
        <source>How far the poses are from each other: the last frames of what was there down, the first frames of what comes in to the right. The stronger the colour, the nearer they are; the ring is where both were joined.</source>
        <translation>ポーズ同士の距離です。下方向は元の動きの最後のフレーム、右方向は入ってくる動きの最初のフレーム。色が濃いほど近く、輪の位置で両者がつながれました。</translation>
    </message>
    <message>
        <source>frames that come in →</source>
        <translation>入ってくるフレーム →</translation>
    </message>
    <message>
        <source>← frames there</source>
        <translation>← 元のフレーム</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Document</name>
    <message>
        <source>The force curves are still being computed; try again in a moment.</source>
        <translation>力の曲線はまだ計算中です。少し待ってからもう一度試してください。</translation>
    </message>
    <message>
        <source>Computing force curves</source>
        <translation>力の曲線を計算中</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DocumentPanel</name>
    <message>
        <source>Add recordings to begin a take.</source>
        <translation>収録を追加してテイクを始めます。</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>テイク</translation>
    </message>
    <message>
        <source>Fighters</source>
        <translation>選手</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source> (missing)</source>
        <translation> (見つかりません)</translation>
    </message>
    <message>
        <source>%1: %2
%3 Hz, %4 frames
Double-click: start, place, floor, joints</source>
        <translation>%1: %2
%3 Hz、%4フレーム
ダブルクリック: 開始、位置、床、関節</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FighterProperties</name>
    <message>
        <source>Fighter properties</source>
        <translation>選手のプロパティ</translation>
    </message>
    <message>
        <source>Fighter</source>
        <translation>選手</translation>
    </message>
    <message>
        <source>Whose properties are shown: the active fighter&apos;s (Tab)</source>
        <translation>プロパティを表示する選手: アクティブな選手 (Tab)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Start in seconds</source>
        <translation>開始 (秒)</translation>
    </message>
    <message>
        <source>When its first frame stands on the clock of the take; puts the fighters in step.</source>
        <translation>最初のフレームがテイクの時計で何秒に当たるか。両選手を同期させます。</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Starts at</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Place in the bout</source>
        <translation>試合での位置</translation>
    </message>
    <message>
        <source>x in metres</source>
        <translation>x (メートル)</translation>
    </message>
    <message>
        <source>Shifts the fighter to the side.</source>
        <translation>選手を横へずらします。</translation>
    </message>
    <message>
        <source>z in metres</source>
        <translation>z (メートル)</translation>
    </message>
    <message>
        <source>Shifts the fighter forward or back.</source>
        <translation>選手を前後にずらします。</translation>
    </message>
    <message>
        <source>Turn in degrees</source>
        <translation>回転 (度)</translation>
    </message>
    <message>
        <source>Turns the fighter about the origin of its recording, before it is shifted.</source>
        <translation>ずらす前に、収録の原点を中心に選手を回します。</translation>
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
        <translation>回転</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>found from the feet</source>
        <translation>足から検出</translation>
    </message>
    <message>
        <source>The height at which the feet rest; switch it off to set the floor by hand.</source>
        <translation>足が止まっているときの高さ。オフにすると床を手動で設定できます。</translation>
    </message>
    <message>
        <source>Height of the floor in metres</source>
        <translation>床の高さ (メートル)</translation>
    </message>
    <message>
        <source>Where the floor is in the space of the recording.</source>
        <translation>収録の空間での床の位置です。</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Body model of the project</source>
        <translation>プロジェクトの身体モデル</translation>
    </message>
    <message>
        <source>Body model</source>
        <translation>身体モデル</translation>
    </message>
    <message>
        <source>How the mass is spread over the body: what the centre of mass and with it the contact force are made of.</source>
        <translation>質量の体への配分。重心と、それによる接地力の元になります。</translation>
    </message>
    <message>
        <source>Which joint is what</source>
        <translation>関節の対応</translation>
    </message>
    <message>
        <source>Joint of the role %1</source>
        <translation>役割「%1」の関節</translation>
    </message>
    <message>
        <source>The joint of the recording that is the %1 of the body.</source>
        <translation>収録の中で体の%1に当たる関節です。</translation>
    </message>
    <message>
        <source>Start, place, floor and joints of a fighter appear here as soon as there is a take.</source>
        <translation>テイクができると、選手の開始、位置、床、関節がここに表示されます。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 Hz, frames %2 to %3 of %4, %5 joints</source>
        <translation>%1 Hz、フレーム%2～%3 / %4、関節%5個</translation>
    </message>
    <message>
        <source>one unit is %1 m, %2 is up</source>
        <translation>1単位は%1 m、上は%2</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>The recording is missing: File, Find recording.</source>
        <translation>収録が見つかりません: ファイル &gt; 収録を探す。</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>ファイルから…</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>1 role has no joint.</source>
        <translation>関節のない役割が1個あります。</translation>
    </message>
    <message>
        <source>%1 roles have no joint.</source>
        <translation>関節のない役割が%1個あります。</translation>
    </message>
    <message>
        <source>Open a body model</source>
        <translation>身体モデルを開く</translation>
    </message>
    <message>
        <source>Body models (*.json)</source>
        <translation>身体モデル (*.json)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FileActions</name>
    <message>
        <source>A project opens alone: choose one .kumite file, or one or two recordings.</source>
        <translation>プロジェクトは単独で開きます。.kumiteファイルを1つ、または収録を1つか2つ選んでください。</translation>
    </message>
    <message>
        <source>A take has one or two fighters: choose one or two recordings, not %1.</source>
        <translation>テイクの選手は1人か2人です。収録は%1個ではなく、1つか2つ選んでください。</translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation>他で開いています</translation>
    </message>
    <message>
        <source>%1 is open in another studio.</source>
        <translation>%1は別のスタジオで開いています。</translation>
    </message>
    <message>
        <source>A copy can be changed and saved under another name. Taking over, you save into this file, and so may the other.</source>
        <translation>コピーなら変更して別の名前で保存できます。引き継ぐとこのファイルに保存しますが、もう一方も保存できます。</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>コピーを開く</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>引き継ぐ</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1を開いています</translation>
    </message>
    <message>
        <source>Found in %1</source>
        <translation>%1での指摘</translation>
    </message>
    <message>
        <source>Making the demo bout</source>
        <translation>デモ試合を作成中</translation>
    </message>
    <message>
        <source>The demo bout: two made fighters. Save it to keep what you change.</source>
        <translation>デモ試合: 人工の選手2人です。変更を残すには保存してください。</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1を復旧中</translation>
    </message>
    <message>
        <source>Found while recovering</source>
        <translation>復旧中の指摘</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1を読み込み中</translation>
    </message>
    <message>
        <source>Found in the recordings</source>
        <translation>収録での指摘</translation>
    </message>
    <message>
        <source>Open one or two recordings</source>
        <translation>収録を1つか2つ開く</translation>
    </message>
    <message>
        <source>Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)</source>
        <translation>収録 (*.bvh *.BVH *.amc *.AMC);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>プロジェクトを開く</translation>
    </message>
    <message>
        <source>Kumite projects (*.kumite)</source>
        <translation>Kumiteプロジェクト (*.kumite)</translation>
    </message>
    <message>
        <source>Where is %1 of %2?</source>
        <translation>%2の%1はどこですか?</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>プロジェクトを保存</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1を保存中</translation>
    </message>
    <message>
        <source>Found while saving</source>
        <translation>保存中の指摘</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1を保存しました。</translation>
    </message>
    <message>
        <source>Save all the same</source>
        <translation>それでも保存</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>別名で保存…</translation>
    </message>
    <message>
        <source>Changed on the disk</source>
        <translation>ディスク上で変更されました</translation>
    </message>
    <message>
        <source>%1 was changed outside this window since you opened it.</source>
        <translation>%1は、開いた後にこのウィンドウの外で変更されました。</translation>
    </message>
    <message>
        <source>It was written %1. If you save over it, what it holds now is kept as a version.</source>
        <translation>書き込み: %1。上書き保存すると、今の内容はバージョンとして残ります。</translation>
    </message>
    <message>
        <source>Save over it</source>
        <translation>上書き保存</translation>
    </message>
    <message>
        <source>Export the actions of this take</source>
        <translation>このテイクの動作を書き出す</translation>
    </message>
    <message>
        <source>Table of actions (*.csv);;Segmentation (*.json)</source>
        <translation>動作の表 (*.csv);;分割 (*.json)</translation>
    </message>
    <message>
        <source>Export the motion of this take</source>
        <translation>このテイクのモーションを書き出す</translation>
    </message>
    <message>
        <source>Motion, one file per fighter (*.bvh)</source>
        <translation>モーション、選手ごとに1ファイル (*.bvh)</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1を書き出し中</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1を書き出しました。</translation>
    </message>
    <message>
        <source> and </source>
        <translation> と </translation>
    </message>
    <message>
        <source>Reading the version of %1</source>
        <translation>%1のバージョンを読み込み中</translation>
    </message>
    <message>
        <source>Found in the version</source>
        <translation>バージョンでの指摘</translation>
    </message>
    <message>
        <source>Restored the version of %1; Ctrl+Z takes it back.</source>
        <translation>%1のバージョンを復元しました。Ctrl+Zで取り消せます。</translation>
    </message>
    <message>
        <source>That version is what is open.</source>
        <translation>開いているのはそのバージョンです。</translation>
    </message>
    <message>
        <source>The version of %1 is open as a copy.</source>
        <translation>%1のバージョンをコピーとして開きました。</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>保存していない変更</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>%1への変更を保存しますか?</translation>
    </message>
    <message>
        <source>What is not saved is lost.</source>
        <translation>保存しないものは失われます。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FindBox</name>
    <message>
        <source>Actions found</source>
        <translation>見つかった動作</translation>
    </message>
    <message>
        <source>right kick up, machine, below 0.6</source>
        <translation>例: right kick up, machine, below 0.6</translation>
    </message>
    <message>
        <source>Find actions</source>
        <translation>動作を検索</translation>
    </message>
    <message>
        <source>Aspects and qualifiers (kick, right punch fwd, jump none), who said it (by hand, machine, rule), how surely (uncertain, below 0.6), which fighter or take, when (after 1:20, longer than 1 s), unlabelled. All must hold; &quot;or&quot; joins two, &quot;not&quot; turns one round. Source and confidence are those of the aspects that are named.</source>
        <translation>観点と修飾 (kick、right punch fwd、jump none)、付けたもの (by hand、machine、rule)、確かさ (uncertain、below 0.6)、選手やテイク、時刻 (after 1:20、longer than 1 s)、ラベルなし (unlabelled)。すべてを満たすものを探します。「or」でどちらか、「not」で否定。付けたものと確信度は、指定した観点についてのものです。</translation>
    </message>
    <message>
        <source>What was understood</source>
        <translation>解釈された内容</translation>
    </message>
    <message>
        <source>Choose all that were found in this take: the next label goes to all of them, as one step</source>
        <translation>このテイクで見つかったすべてを選びます。次のラベルが履歴の1ステップとして全部に付きます</translation>
    </message>
    <message>
        <source>1 action</source>
        <translation>動作1件</translation>
    </message>
    <message>
        <source>%1 actions</source>
        <translation>動作%1件</translation>
    </message>
    <message>
        <source>Choose all %1</source>
        <translation>%1件すべて選択</translation>
    </message>
    <message>
        <source>The actions of the bout appear here once a recording is cut.</source>
        <translation>収録が分割されると、試合の動作がここに表示されます。</translation>
    </message>
    <message>
        <source>No action is like that.</source>
        <translation>当てはまる動作はありません。</translation>
    </message>
    <message>
        <source>Choose all</source>
        <translation>すべて選択</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FindingsPage</name>
    <message>
        <source>Findings in the recordings</source>
        <translation>収録での指摘</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>このページを閉じる (Esc)</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>What is odd or worth knowing about the recordings of a project is listed here. There is nothing.</source>
        <translation>プロジェクトの収録で奇妙な点や知っておくとよい点がここに並びます。今は何もありません。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FoundModel</name>
    <message>
        <source>%1, %2: %3, %4</source>
        <translation>%1、%2: %3、%4</translation>
    </message>
    <message>
        <source>, p %1</source>
        <translation>, p %1</translation>
    </message>
    <message>
        <source>Who says it; of several aspects the least sure</source>
        <translation>付けたもの。観点が複数なら最も不確かなもの</translation>
    </message>
    <message>
        <source>Confidence; of several aspects the least</source>
        <translation>確信度。観点が複数なら最小のもの</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>label</source>
        <translation>ラベル</translation>
    </message>
    <message>
        <source>by</source>
        <translation>付けたもの</translation>
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
        <translation>行列</translation>
    </message>
    <message>
        <source>Transitions as a matrix (V)</source>
        <translation>遷移を行列で表示 (V)</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Transitions as circles and edges (V)</source>
        <translation>遷移を円とエッジで表示 (V)</translation>
    </message>
    <message>
        <source>What %1 does next (Tab)</source>
        <translation>%1が次にすること (Tab)</translation>
    </message>
    <message>
        <source>compared with nothing</source>
        <translation>比較なし</translation>
    </message>
    <message>
        <source>with the other fighter</source>
        <translation>もう一方の選手と</translation>
    </message>
    <message>
        <source>with labels by hand alone</source>
        <translation>手動のラベルだけと</translation>
    </message>
    <message>
        <source>with EQU7</source>
        <translation>EQU7と</translation>
    </message>
    <message>
        <source>with EQU6</source>
        <translation>EQU6と</translation>
    </message>
    <message>
        <source>with EQU5</source>
        <translation>EQU5と</translation>
    </message>
    <message>
        <source>What it is compared with</source>
        <translation>比較の対象</translation>
    </message>
    <message>
        <source>Compares with another, side by side or as a difference</source>
        <translation>別のものと並べて、または差で比較します</translation>
    </message>
    <message>
        <source>What each fighter tends to do next</source>
        <translation>各選手が次にしがちなこと</translation>
    </message>
    <message>
        <source>Why nothing is shown</source>
        <translation>何も表示されない理由</translation>
    </message>
    <message>
        <source>Transitions are being learnt from the labels.</source>
        <translation>ラベルから遷移を学習しています。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphCommands</name>
    <message>
        <source>Export transitions</source>
        <translation>遷移を書き出す</translation>
    </message>
    <message>
        <source>Edges as a table (*.csv);;Graph and model (*.json);;Graph (*.graphml);;Picture (*.png);;Picture of lines (*.svg)</source>
        <translation>エッジの表 (*.csv);;グラフとモデル (*.json);;グラフ (*.graphml);;画像 (*.png);;線画 (*.svg)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き出しました: %1</translation>
    </message>
    <message>
        <source>&amp;Graph</source>
        <translation>グラフ(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Matrix or graph</source>
        <translation>行列／グラフ(&amp;M)</translation>
    </message>
    <message>
        <source>Graph in &amp;space</source>
        <translation>グラフを立体表示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Play what is behind it, the next each time</source>
        <translation>元の場面を再生、押すたびに次へ(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next surprise</source>
        <translation>次の意外な遷移(&amp;N)</translation>
    </message>
    <message>
        <source>Pre&amp;vious surprise</source>
        <translation>前の意外な遷移(&amp;V)</translation>
    </message>
    <message>
        <source>Surprise of bo&amp;th terms</source>
        <translation>両方の項の意外度(&amp;T)</translation>
    </message>
    <message>
        <source>S&amp;urprise of the label term</source>
        <translation>ラベル項の意外度(&amp;D)</translation>
    </message>
    <message>
        <source>Su&amp;rprise of the geometry term</source>
        <translation>幾何項の意外度(&amp;F)</translation>
    </message>
    <message>
        <source>Rows by &amp;own label</source>
        <translation>行を自分のラベルで(&amp;O)</translation>
    </message>
    <message>
        <source>Ro&amp;ws by opponent&apos;s label</source>
        <translation>行を相手のラベルで(&amp;H)</translation>
    </message>
    <message>
        <source>Rows by &amp;both labels</source>
        <translation>行を両方のラベルで(&amp;B)</translation>
    </message>
    <message>
        <source>Sort by &amp;count</source>
        <translation>件数順(&amp;C)</translation>
    </message>
    <message>
        <source>Sort by n&amp;ame</source>
        <translation>名前順(&amp;A)</translation>
    </message>
    <message>
        <source>Sort by &amp;likeness</source>
        <translation>類似順(&amp;L)</translation>
    </message>
    <message>
        <source>Lar&amp;ger cells</source>
        <translation>セルを大きく(&amp;G)</translation>
    </message>
    <message>
        <source>Smaller cells</source>
        <translation>セルを小さく</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>すべて表示(&amp;E)</translation>
    </message>
    <message>
        <source>E&amp;xport transitions…</source>
        <translation>遷移を書き出す(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphExport</name>
    <message>
        <source>Transitions</source>
        <translation>遷移</translation>
    </message>
    <message>
        <source>%1: the name must end in .csv, .json, .graphml, .png or .svg.</source>
        <translation>%1: 名前の末尾は.csv、.json、.graphml、.png、.svgのいずれかにしてください。</translation>
    </message>
    <message>
        <source>%1: it cannot be written there.</source>
        <translation>%1: そこには書き込めません。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphPanel</name>
    <message>
        <source>What a fighter does next, given what both are doing, and the moments of the recording behind each probability appear here.</source>
        <translation>両者の今の動作から見た選手の次の動作と、それぞれの確率の元になった収録の場面がここに表示されます。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphSession</name>
    <message>
        <source>%1: more often</source>
        <translation>%1: より多い</translation>
    </message>
    <message>
        <source>others</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>label</source>
        <translation>ラベル</translation>
    </message>
    <message>
        <source>geometry</source>
        <translation>幾何</translation>
    </message>
    <message>
        <source>both</source>
        <translation>両方</translation>
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
        <translation>意外度%1 (動きを見て%2): ラベル%3 (%4)、幾何%5</translation>
    </message>
    <message>
        <source>Learning transitions</source>
        <translation>遷移を学習中</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>何でも</translation>
    </message>
    <message>
        <source>all labels</source>
        <translation>全ラベル</translation>
    </message>
    <message>
        <source>labels by hand</source>
        <translation>手動のラベル</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphView</name>
    <message>
        <source>Graph of transitions</source>
        <translation>遷移のグラフ</translation>
    </message>
    <message>
        <source>A node is a label, an edge leads to what follows. A click shows the moments behind it.</source>
        <translation>ノードはラベル、エッジは続くものへの道です。クリックで元の場面を表示します。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Help</name>
    <message>
        <source>&amp;Help on this workspace</source>
        <translation>このワークスペースのヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>最初のステップ(&amp;F)</translation>
    </message>
    <message>
        <source>What the &amp;numbers mean</source>
        <translation>数値の意味(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;What is this? Click on it</source>
        <translation>これは何? クリックして確認(&amp;W)</translation>
    </message>
    <message>
        <source>What has the f&amp;ocus?</source>
        <translation>フォーカスのある項目は?(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>キーとマウス(&amp;K)</translation>
    </message>
    <message>
        <source>What is n&amp;ew</source>
        <translation>新機能(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;About Kumite</source>
        <translation>Kumiteについて(&amp;A)</translation>
    </message>
    <message>
        <source>About Kumite</source>
        <translation>Kumiteについて</translation>
    </message>
    <message>
        <source>Kumite %1

A studio for annotating two-player martial-arts motion capture.</source>
        <translation>Kumite %1

二人で行う格闘技のモーションキャプチャに注釈を付けるスタジオです。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HelpWindow</name>
    <message>
        <source>The page before</source>
        <translation>前のページ</translation>
    </message>
    <message>
        <source>On again</source>
        <translation>次へ進む</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Close the help (Esc)</source>
        <translation>ヘルプを閉じる (Esc)</translation>
    </message>
    <message>
        <source>Search all pages</source>
        <translation>全ページを検索</translation>
    </message>
    <message>
        <source>Shows the pages that hold all of these words. Return: the next place; Shift+Return: the one before. (Ctrl+F)</source>
        <translation>これらの語をすべて含むページを表示します。Return: 次の箇所、Shift+Return: 前の箇所。(Ctrl+F)</translation>
    </message>
    <message>
        <source>How often the words were found</source>
        <translation>語が見つかった回数</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目次</translation>
    </message>
    <message>
        <source>The pages of the help</source>
        <translation>ヘルプのページ</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>Tab leads from link to link, Return follows one.</source>
        <translation>Tabでリンクからリンクへ移り、Returnで開きます。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Found %1 times on this page</source>
        <translation>このページで%1回見つかりました</translation>
    </message>
    <message>
        <source>Show this page</source>
        <translation>このページを表示</translation>
    </message>
    <message>
        <source>No page holds these words.</source>
        <translation>これらの語を含むページはありません。</translation>
    </message>
    <message>
        <source>%1 of %2 on this page</source>
        <translation>このページの%2件中%1件目</translation>
    </message>
    <message>
        <source>%1 — Help</source>
        <translation>%1 — ヘルプ</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HistoryModel</name>
    <message>
        <source>%1
The project as it is now.</source>
        <translation>%1
今のプロジェクトです。</translation>
    </message>
    <message>
        <source>%1
Click to go back to this state.</source>
        <translation>%1
クリックでこの状態に戻ります。</translation>
    </message>
    <message>
        <source>%1
Undone. Click to redo up to here.</source>
        <translation>%1
取り消し済み。クリックでここまでやり直します。</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1、取り消し済み</translation>
    </message>
    <message>
        <source>%1, now</source>
        <translation>%1、今</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HitBox</name>
    <message>
        <source>Hit a target</source>
        <translation>ターゲットに当てる</translation>
    </message>
    <message>
        <source>Drag the target in the 3D view: the strike follows it. Dots: where whole examples hit; the box: what is reached.</source>
        <translation>3D ビューで的をドラッグすると打撃が追います。点：例そのものの混合が当たる所、箱：届く範囲。</translation>
    </message>
    <message>
        <source>Strike</source>
        <translation>打撃</translation>
    </message>
    <message>
        <source>Which strike; its examples are the actions with that label</source>
        <translation>打撃の種類。例はそのラベルを持つ動作です</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Aim at</source>
        <translation>狙い</translation>
    </message>
    <message>
        <source>A place in space, or the opponent as the recording&apos;s playhead shows it; a click on its marks in the 3D view aims there</source>
        <translation>空間の場所、または再生位置に映る相手。3D ビューの印をクリックするとそこを狙います</translation>
    </message>
    <message>
        <source>Distance of the opponent, metres</source>
        <translation>相手までの距離（メートル）</translation>
    </message>
    <message>
        <source>How far ahead the opponent stands, from pelvis to pelvis</source>
        <translation>相手が前方にどれだけ離れて立つか、骨盤から骨盤まで</translation>
    </message>
    <message>
        <source>Away, m</source>
        <translation>距離 (m)</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Target, metres %1</source>
        <translation>ターゲット、%1 (メートル)</translation>
    </message>
    <message>
        <source>Target, m</source>
        <translation>ターゲット, m</translation>
    </message>
    <message>
        <source>How well it is hit</source>
        <translation>命中の度合い</translation>
    </message>
    <message>
        <source>The strikes are being aligned.</source>
        <translation>打撃を揃えています。</translation>
    </message>
    <message>
        <source>A blend of whole examples reaches it.</source>
        <translation>例の全身ブレンドで届きます。</translation>
    </message>
    <message>
        <source>No blend of whole examples reaches it: parts of the body are blended and turned.</source>
        <translation>例の全身ブレンドでは届かないため、体の部位をブレンドして回します。</translation>
    </message>
    <message>
        <source>It is outside of the box that is reached.</source>
        <translation>届く範囲の外にあります。</translation>
    </message>
    <message>
        <source>Hit, %1 cm off. %2 %3 examples.</source>
        <translation>命中、ずれ%1 cm。%2 例は%3件。</translation>
    </message>
    <message>
        <source>Missed by %1 cm: the nearest that can be reached. %2 %3 examples.</source>
        <translation>%1 cm外れました。届く中で最も近い位置です。%2 例は%3件。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HitSession</name>
    <message>
        <source>Aim at the opponent</source>
        <translation>相手を狙う</translation>
    </message>
    <message>
        <source>Aim at a place</source>
        <translation>場所を狙う</translation>
    </message>
    <message>
        <source>Opponent %1 m away</source>
        <translation>相手を %1 m 先に</translation>
    </message>
    <message>
        <source>Strike with %1</source>
        <translation>%1で打つ</translation>
    </message>
    <message>
        <source>Aligning the strikes</source>
        <translation>打撃を揃えています</translation>
    </message>
    <message>
        <source>Move the target</source>
        <translation>ターゲットを移動</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ImportDialog</name>
    <message>
        <source>Open recordings</source>
        <translation>収録を開く</translation>
    </message>
    <message>
        <source>Not read. Choose the file again to read it.</source>
        <translation>読み込まれていません。読み込むにはファイルを選び直してください。</translation>
    </message>
    <message>
        <source>Choose a recording</source>
        <translation>収録を選ぶ</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>読み込み中…</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>読み込み中</translation>
    </message>
    <message>
        <source>Start, place and floor of %1 must be numbers, such as 0.25.</source>
        <translation>%1の開始、位置、床は0.25のような数にしてください。</translation>
    </message>
    <message>
        <source>Choose a recording for fighter 1.</source>
        <translation>選手1の収録を選んでください。</translation>
    </message>
    <message>
        <source>The rate must be a positive number of frames per second, such as 60.</source>
        <translation>レートは60のような正の数 (毎秒フレーム数) にしてください。</translation>
    </message>
    <message>
        <source>Frames read begin:end, such as 120:900; either may be left out.</source>
        <translation>読み込むフレームの開始:終了。例 120:900。どちらも省略できます。</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>調べています</translation>
    </message>
    <message>
        <source>Roles, %1 missing</source>
        <translation>役割、不足%1</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>役割</translation>
    </message>
    <message>
        <source>&lt;b&gt;Check:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;確認:&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>%1 (found)</source>
        <translation>%1（検出）</translation>
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
        <translation>検出どおり</translation>
    </message>
    <message>
        <source>%1:%2 of %3</source>
        <translation>%1:%2 / %3</translation>
    </message>
    <message>
        <source>Hz; header: %1</source>
        <translation>Hz、ヘッダー: %1</translation>
    </message>
    <message>
        <source> and </source>
        <translation> と </translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>begin:end</source>
        <translation>開始:終了</translation>
    </message>
    <message>
        <source>Fighter %1</source>
        <translation>選手%1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>収録</translation>
    </message>
    <message>
        <source>Path of the recording; the button beside it, or a drop, chooses one</source>
        <translation>収録のパス。横のボタンかドロップで選びます</translation>
    </message>
    <message>
        <source>a .bvh or .amc file</source>
        <translation>.bvhか.amcファイル</translation>
    </message>
    <message>
        <source>none: a single fighter</source>
        <translation>なし: 選手1人</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>スケルトン</translation>
    </message>
    <message>
        <source>Which skeleton of a file that holds several</source>
        <translation>ファイルに複数あるとき、どのスケルトンか</translation>
    </message>
    <message>
        <source>ASF skeleton</source>
        <translation>ASFスケルトン</translation>
    </message>
    <message>
        <source>the one beside it</source>
        <translation>同じ場所のもの</translation>
    </message>
    <message>
        <source>The .asf file that belongs to the .amc</source>
        <translation>.amcに対応する.asfファイル</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>長さの単位</translation>
    </message>
    <message>
        <source>What one unit of the file is</source>
        <translation>ファイルの1単位の長さ</translation>
    </message>
    <message>
        <source>found</source>
        <translation>検出済み</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>上の軸</translation>
    </message>
    <message>
        <source>The file&apos;s axis that points up</source>
        <translation>ファイルで上を向く軸</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Seconds on the take&apos;s clock at which its first frame stands</source>
        <translation>最初のフレームが当たる、テイクの時計での秒数</translation>
    </message>
    <message>
        <source>Place x</source>
        <translation>位置x</translation>
    </message>
    <message>
        <source>Metres along x from where the file stands</source>
        <translation>ファイルの位置からx方向へのメートル</translation>
    </message>
    <message>
        <source>Place z</source>
        <translation>位置z</translation>
    </message>
    <message>
        <source>Metres along z from where the file stands</source>
        <translation>ファイルの位置からz方向へのメートル</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Degrees about the vertical, about the file&apos;s origin</source>
        <translation>ファイルの原点を通る鉛直軸まわりの度数</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>Height of the floor in the file, metres</source>
        <translation>ファイルでの床の高さ (メートル)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選ぶ…</translation>
    </message>
    <message>
        <source>Choose the recording of %1</source>
        <translation>%1の収録を選ぶ</translation>
    </message>
    <message>
        <source>BVH, or AMC with its ASF; others go through Blender</source>
        <translation>BVH、またはAMCとそのASF。他の形式はBlender経由で</translation>
    </message>
    <message>
        <source>Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)</source>
        <translation>収録 (*.bvh *.BVH *.amc *.AMC);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>S&amp;wap</source>
        <translation>入れ替え(&amp;W)</translation>
    </message>
    <message>
        <source>Swap fighters</source>
        <translation>選手を入れ替える</translation>
    </message>
    <message>
        <source>Fighter 1 becomes fighter 2, with all that is said of them (Alt+W)</source>
        <translation>選手1を、設定ごと選手2にします (Alt+W)</translation>
    </message>
    <message>
        <source>Take name</source>
        <translation>テイク名</translation>
    </message>
    <message>
        <source>How the take is called in the project</source>
        <translation>プロジェクトでのテイクの名前</translation>
    </message>
    <message>
        <source>Rate in Hz</source>
        <translation>レート (Hz)</translation>
    </message>
    <message>
        <source>as the header</source>
        <translation>ヘッダーどおり</translation>
    </message>
    <message>
        <source>True frame rate, where the header is wrong: the preview shows it</source>
        <translation>ヘッダーが誤っている場合の正しいフレームレート。プレビューに反映されます</translation>
    </message>
    <message>
        <source>Frames, begin:end</source>
        <translation>フレーム、開始:終了</translation>
    </message>
    <message>
        <source>Frames of the files; the end is the first frame left out. Empty: all, without a leading T-pose.</source>
        <translation>ファイルのフレーム。終了は含まれません。空欄: 先頭のTポーズを除く全部。</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>テイク</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>レート</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>ASF file</source>
        <translation>ASFファイル</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Starts at, s</source>
        <translation>開始, s</translation>
    </message>
    <message>
        <source>Place x, m</source>
        <translation>位置x, m</translation>
    </message>
    <message>
        <source>Place z, m</source>
        <translation>位置z, m</translation>
    </message>
    <message>
        <source>Turned, °</source>
        <translation>回転, °</translation>
    </message>
    <message>
        <source>Floor, m</source>
        <translation>床, m</translation>
    </message>
    <message>
        <source>Add as a take to %1</source>
        <translation>テイクとして%1に追加</translation>
    </message>
    <message>
        <source>Otherwise it becomes a project of its own</source>
        <translation>オフなら独立したプロジェクトになります</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>Play or pause (Space in the preview, Alt+P)</source>
        <translation>再生／一時停止 (プレビューではSpace、Alt+P)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>What was found in the recordings</source>
        <translation>収録で見つかったこと</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Open nothing (Esc)</source>
        <translation>何も開きません (Esc)</translation>
    </message>
    <message>
        <source>Open bout</source>
        <translation>試合を開く</translation>
    </message>
    <message>
        <source>Make a take of these recordings (Enter)</source>
        <translation>これらの収録でテイクを作ります (Enter)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ImportPreview</name>
    <message>
        <source>Preview of both fighters</source>
        <translation>両選手のプレビュー</translation>
    </message>
    <message>
        <source>From above, from the side, and their distance over time</source>
        <translation>上から、横から、そして距離の時間変化</translation>
    </message>
    <message>
        <source>Space plays, ← → steps, a drag on the distance scrubs</source>
        <translation>Spaceで再生、← →でコマ送り、距離のドラッグでスクラブ</translation>
    </message>
    <message>
        <source>from above, grid %1 m</source>
        <translation>上から、格子%1 m</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>横から</translation>
    </message>
    <message>
        <source>%1   distance %2 m</source>
        <translation>%1   距離%2 m</translation>
    </message>
    <message>
        <source>distance of the pelvises, m</source>
        <translation>骨盤間の距離, m</translation>
    </message>
    <message>
        <source>Both fighters move here once their recordings are read. Choose them above, or drop them here.</source>
        <translation>収録が読み込まれると、ここで両選手が動きます。上で選ぶか、ここにドロップしてください。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JobBar</name>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JobRunner</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>メモリーが足りません。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JointBox</name>
    <message>
        <source>Joint</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Joint to turn</source>
        <translation>回す関節</translation>
    </message>
    <message>
        <source>Which joint has rings in the 3D view; J chooses the next one</source>
        <translation>3D ビューでリングが付く関節。J で次を選びます</translation>
    </message>
    <message>
        <source>Turn about %1, degrees</source>
        <translation>%1 軸まわりの回転（度）</translation>
    </message>
    <message>
        <source>About the parent&apos;s %1, degrees; turned about y first, then x, then z</source>
        <translation>親の %1 軸まわり（度）。y、x、z の順に回します</translation>
    </message>
    <message>
        <source>x y z, °</source>
        <translation>x y z (°)</translation>
    </message>
    <message>
        <source>How much of the joint&apos;s limits that takes</source>
        <translation>関節の可動域をどれだけ使うか</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Bent by %1° of %2°, twisted by %3° of %4° from rest.</source>
        <translation>曲げ %1°（限度 %2°）、ひねり %3°（限度 %4°）。</translation>
    </message>
    <message>
        <source>This joint has no limits.</source>
        <translation>この関節に限度はありません。</translation>
    </message>
    <message>
        <source>A chosen joint has rings in the 3D view: drag one to turn it.</source>
        <translation>選んだ関節には 3D ビューでリングが付きます。ドラッグして回します。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyBar</name>
    <message>
        <source>Time of the keys</source>
        <translation>キーポーズの時刻</translation>
    </message>
    <message>
        <source>the strike</source>
        <translation>打撃</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>フレーム%1</translation>
    </message>
    <message>
        <source> · the motion</source>
        <translation> · モーション</translation>
    </message>
    <message>
        <source> · the keys</source>
        <translation> · キーポーズ</translation>
    </message>
    <message>
        <source> · beside it without adjustment</source>
        <translation> · 隣に調整なし</translation>
    </message>
    <message>
        <source> · out of reach by %1 cm</source>
        <translation> · 届く範囲を%1 cm超過</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyCommands</name>
    <message>
        <source>Ke&amp;yframe</source>
        <translation>キーフレーム(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>再生／一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>1フレーム戻る</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>1フレーム進む</translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation>10フレーム戻る</translation>
    </message>
    <message>
        <source>Ten frames on</source>
        <translation>10フレーム進む</translation>
    </message>
    <message>
        <source>To the first key</source>
        <translation>最初のキーポーズへ</translation>
    </message>
    <message>
        <source>To the last key</source>
        <translation>最後のキーポーズへ</translation>
    </message>
    <message>
        <source>Show the &amp;motion instead of the keys</source>
        <translation>キーポーズの代わりにモーションを表示(&amp;M)</translation>
    </message>
    <message>
        <source>Beside it the motion without a&amp;djustment</source>
        <translation>調整なしの動きを隣に(&amp;D)</translation>
    </message>
    <message>
        <source>Keys before and after as &amp;ghosts</source>
        <translation>前後のキーを残像で表示(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Hit a target</source>
        <translation>ターゲットに当てる(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Add a key here</source>
        <translation>ここにキーポーズを追加(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove the key</source>
        <translation>キーポーズを削除(&amp;R)</translation>
    </message>
    <message>
        <source>Key before</source>
        <translation>前のキーポーズ</translation>
    </message>
    <message>
        <source>Key after</source>
        <translation>次のキーポーズ</translation>
    </message>
    <message>
        <source>Move the key earlier</source>
        <translation>キーポーズを前へ移動</translation>
    </message>
    <message>
        <source>Move the key later</source>
        <translation>キーポーズを後へ移動</translation>
    </message>
    <message>
        <source>Move the key and later ones earlier</source>
        <translation>このキーと後のキーを早める</translation>
    </message>
    <message>
        <source>Move the key and later ones later</source>
        <translation>このキーと後のキーを遅らせる</translation>
    </message>
    <message>
        <source>Later keys closer together</source>
        <translation>後のキーの間隔を詰める</translation>
    </message>
    <message>
        <source>Later keys farther apart</source>
        <translation>後のキーの間隔を広げる</translation>
    </message>
    <message>
        <source>&amp;Copy the key to the playhead, or behind the last</source>
        <translation>キーポーズを再生ヘッドか末尾の後へコピー(&amp;C)</translation>
    </message>
    <message>
        <source>M&amp;irror the pose</source>
        <translation>ポーズを左右反転(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Take the pose that the recording shows</source>
        <translation>収録に表示中のポーズを使う(&amp;T)</translation>
    </message>
    <message>
        <source>Copy the pose from an&amp;y take or clip…</source>
        <translation>テイクやクリップからポーズをコピー(&amp;Y)…</translation>
    </message>
    <message>
        <source>The handle &amp;stays where it is, or not</source>
        <translation>ハンドルの位置固定を切り替え(&amp;S)</translation>
    </message>
    <message>
        <source>Next handle</source>
        <translation>次のハンドル</translation>
    </message>
    <message>
        <source>Next &amp;joint to turn</source>
        <translation>次の回す関節(&amp;J)</translation>
    </message>
    <message>
        <source>Joint before</source>
        <translation>前の関節</translation>
    </message>
    <message>
        <source>Handle up</source>
        <translation>ハンドルを上へ</translation>
    </message>
    <message>
        <source>Handle down</source>
        <translation>ハンドルを下へ</translation>
    </message>
    <message>
        <source>Handle toward −x</source>
        <translation>ハンドルを−xへ</translation>
    </message>
    <message>
        <source>Handle toward +x</source>
        <translation>ハンドルを+xへ</translation>
    </message>
    <message>
        <source>Handle toward −z</source>
        <translation>ハンドルを−zへ</translation>
    </message>
    <message>
        <source>Handle toward +z</source>
        <translation>ハンドルを+zへ</translation>
    </message>
    <message>
        <source>The body from anywhere again</source>
        <translation>全身の出所を自動に戻す</translation>
    </message>
    <message>
        <source>Take the body from anywhere</source>
        <translation>全身の出所を自動にする</translation>
    </message>
    <message>
        <source>Remove all keys</source>
        <translation>キーポーズをすべて削除</translation>
    </message>
    <message>
        <source>Add clips of &amp;files…</source>
        <translation>ファイルのクリップを追加(&amp;F)…</translation>
    </message>
    <message>
        <source>Add cl&amp;ips of a folder…</source>
        <translation>フォルダーのクリップを追加(&amp;H)…</translation>
    </message>
    <message>
        <source>R&amp;eplace a part of a take…</source>
        <translation>テイクの一部を置き換え(&amp;B)…</translation>
    </message>
    <message>
        <source>&amp;Keep as a take…</source>
        <translation>テイクとして残す(&amp;K)…</translation>
    </message>
    <message>
        <source>E&amp;xport the motion…</source>
        <translation>モーションを書き出す(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyEditor</name>
    <message>
        <source>Remove keys</source>
        <translation>キーを外す</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>リセット</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>全キーをリセット</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>コマンドを検索</translation>
    </message>
    <message>
        <source>Shows the commands whose name, menu or key holds these letters.</source>
        <translation>名前、メニュー、キーにこの文字を含むコマンドを表示します。</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>コマンドとキー</translation>
    </message>
    <message>
        <source>Choose a command, then press its key in the field below</source>
        <translation>コマンドを選び、下の欄でキーを押してください</translation>
    </message>
    <message>
        <source>command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>The chosen command gets the key in the field.</source>
        <translation>選んだコマンドに欄のキーを割り当てます。</translation>
    </message>
    <message>
        <source>The chosen command is run from menus and the palette only.</source>
        <translation>選んだコマンドはメニューとパレットからだけ実行します。</translation>
    </message>
    <message>
        <source>The chosen command gets back the keys that the studio brings.</source>
        <translation>選んだコマンドのキーを既定に戻します。</translation>
    </message>
    <message>
        <source>All commands get back the keys that the studio brings.</source>
        <translation>すべてのコマンドのキーを既定に戻します。</translation>
    </message>
    <message>
        <source>Your own; the studio brings: %1</source>
        <translation>独自の設定。既定: %1</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>割り当て</translation>
    </message>
    <message>
        <source>Choose a command to give it another key.</source>
        <translation>コマンドを選ぶと、別のキーを割り当てられます。</translation>
    </message>
    <message>
        <source>Press the new key for “%1” in the field.</source>
        <translation>欄で「%1」の新しいキーを押してください。</translation>
    </message>
    <message>
        <source>%1 is its key already.</source>
        <translation>%1はすでにこのコマンドのキーです。</translation>
    </message>
    <message>
        <source>%1 is free.</source>
        <translation>%1は空いています。</translation>
    </message>
    <message>
        <source>Take it over</source>
        <translation>奪って割り当て</translation>
    </message>
    <message>
        <source>%1 is the key of %2. Taking it over leaves that command without it.</source>
        <translation>%1は%2のキーです。割り当てると、そのコマンドにはキーがなくなります。</translation>
    </message>
    <message>
        <source> and </source>
        <translation> と </translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyField</name>
    <message>
        <source>Press a key</source>
        <translation>キーを押す</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>新しいキー</translation>
    </message>
    <message>
        <source>Press the key here, alone or with Ctrl, Shift, Alt; then Tab goes on, and Shift+Tab always goes back</source>
        <translation>キーを単独で、またはCtrl、Shift、Altとともにここで押します。その後Tabで進み、Shift+Tabでいつでも戻れます</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyPanel</name>
    <message>
        <source>What appears here</source>
        <translation>ここに表示されるもの</translation>
    </message>
    <message>
        <source>Key pose</source>
        <translation>キーポーズ</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>モーション</translation>
    </message>
    <message>
        <source>Hit a target</source>
        <translation>ターゲットに当てる</translation>
    </message>
    <message>
        <source>A strike of the takes and clips that follows a target, instead of keys</source>
        <translation>キーポーズの代わりに、ターゲットを追うテイクとクリップの打撃</translation>
    </message>
    <message>
        <source>Back to the keys</source>
        <translation>キーポーズに戻る</translation>
    </message>
    <message>
        <source>Sho&amp;w the key pose</source>
        <translation>キーポーズを表示(&amp;E)</translation>
    </message>
    <message>
        <source>Show the motio&amp;n</source>
        <translation>動きを表示(&amp;L)</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>クリップ…</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>残す…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出す…</translation>
    </message>
    <message>
        <source>A few key poses become a motion that is put together from the takes and clips: it appears here.</source>
        <translation>いくつかのキーポーズから、テイクとクリップを組み合わせたモーションができ、ここに表示されます。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeySession</name>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2～%3</translation>
    </message>
    <message>
        <source>Preparing the clips</source>
        <translation>クリップを準備中</translation>
    </message>
    <message>
        <source>Making the motion</source>
        <translation>モーションを作成中</translation>
    </message>
    <message>
        <source>Add a key at frame %1</source>
        <translation>フレーム%1にキーポーズを追加</translation>
    </message>
    <message>
        <source>Take the pose of the recording</source>
        <translation>収録のポーズを使う</translation>
    </message>
    <message>
        <source>Remove the key at frame %1</source>
        <translation>フレーム%1のキーポーズを削除</translation>
    </message>
    <message>
        <source>A key stands at frame %1 already.</source>
        <translation>フレーム%1にはすでにキーポーズがあります。</translation>
    </message>
    <message>
        <source>Move the key to frame %1</source>
        <translation>キーポーズをフレーム%1へ移動</translation>
    </message>
    <message>
        <source>Move the key and later ones to frame %1</source>
        <translation>このキーと後のキーをフレーム %1 へ移動</translation>
    </message>
    <message>
        <source>Later keys %1 times as far</source>
        <translation>後のキーの間隔を %1 倍に</translation>
    </message>
    <message>
        <source>Copy the key to frame %1</source>
        <translation>キーポーズをフレーム%1へコピー</translation>
    </message>
    <message>
        <source>Mirror the key</source>
        <translation>キーポーズを左右反転</translation>
    </message>
    <message>
        <source>Change the way to the next key</source>
        <translation>次のキーポーズへの経過を変更</translation>
    </message>
    <message>
        <source>Remove all keys</source>
        <translation>キーポーズをすべて削除</translation>
    </message>
    <message>
        <source>Drag the %1</source>
        <translation>%1をドラッグ</translation>
    </message>
    <message>
        <source>Turn the %1</source>
        <translation>%1を回す</translation>
    </message>
    <message>
        <source>Move the %1 a little</source>
        <translation>%1を少し動かす</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyStrip</name>
    <message>
        <source>Key poses over time</source>
        <translation>時間に沿ったキーポーズ</translation>
    </message>
    <message>
        <source>The strike over time</source>
        <translation>時間に沿った打撃</translation>
    </message>
    <message>
        <source>The strikes are being aligned.</source>
        <translation>打撃を揃えています。</translation>
    </message>
    <message>
        <source>No strike to bring to a target.</source>
        <translation>ターゲットに当てる打撃がありません。</translation>
    </message>
    <message>
        <source>hit, %1</source>
        <translation>命中、%1</translation>
    </message>
    <message>
        <source>No key poses yet. Return makes the first one, of the pose that the take shows now.</source>
        <translation>キーポーズはまだありません。Returnで、テイクに表示中のポーズから最初の1つを作ります。</translation>
    </message>
    <message>
        <source>key at frame %1 · drag to move it</source>
        <translation>フレーム%1のキーポーズ · ドラッグで移動</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeysPage</name>
    <message>
        <source>Mouse on the timeline</source>
        <translation>タイムラインでのマウス</translation>
    </message>
    <message>
        <source>click, double-click</source>
        <translation>クリック、ダブルクリック</translation>
    </message>
    <message>
        <source>select a boundary; remove or restore it</source>
        <translation>境界を選択、削除または復元</translation>
    </message>
    <message>
        <source>× over a boundary</source>
        <translation>境界の上の×</translation>
    </message>
    <message>
        <source>remove it at once</source>
        <translation>すぐに削除</translation>
    </message>
    <message>
        <source>drag a boundary</source>
        <translation>境界をドラッグ</translation>
    </message>
    <message>
        <source>move it; Ctrl or Alt: without snapping; Esc: leave it</source>
        <translation>移動。CtrlかAlt: スナップなし、Esc: 元のまま</translation>
    </message>
    <message>
        <source>drag elsewhere</source>
        <translation>他の場所をドラッグ</translation>
    </message>
    <message>
        <source>scrub</source>
        <translation>スクラブ</translation>
    </message>
    <message>
        <source>drag a loop end on the ruler</source>
        <translation>ルーラーのループ端をドラッグ</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>click, double-click an action</source>
        <translation>動作をクリック、ダブルクリック</translation>
    </message>
    <message>
        <source>select it; show and loop it</source>
        <translation>選択、表示してループ</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>右クリック</translation>
    </message>
    <message>
        <source>what can be done there</source>
        <translation>そこでできること</translation>
    </message>
    <message>
        <source>wheel, Shift+wheel, middle drag</source>
        <translation>ホイール、Shift+ホイール、中ボタンドラッグ</translation>
    </message>
    <message>
        <source>scroll</source>
        <translation>スクロール</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+ホイール</translation>
    </message>
    <message>
        <source>zoom about the pointer</source>
        <translation>ポインターを中心にズーム</translation>
    </message>
    <message>
        <source>Mouse in the 3D view</source>
        <translation>3D表示でのマウス</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>ドラッグ</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>middle or Shift+drag</source>
        <translation>中ボタンまたはShift+ドラッグ</translation>
    </message>
    <message>
        <source>move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>click a fighter</source>
        <translation>選手をクリック</translation>
    </message>
    <message>
        <source>make it the active one</source>
        <translation>アクティブにする</translation>
    </message>
    <message>
        <source>measuring: click joints</source>
        <translation>計測中: 関節をクリック</translation>
    </message>
    <message>
        <source>distance; over a joint: its speed</source>
        <translation>距離。関節の上: その速さ</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>キーとマウス</translation>
    </message>
    <message>
        <source>Search keys and commands</source>
        <translation>キーとコマンドを検索</translation>
    </message>
    <message>
        <source>Shows the lines that hold these letters</source>
        <translation>この文字を含む行を表示します</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>印刷…</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>PDFで保存…</translation>
    </message>
    <message>
        <source>Change keys…</source>
        <translation>キーを変更…</translation>
    </message>
    <message>
        <source>The keys of all workspaces, on paper. (Ctrl+P)</source>
        <translation>全ワークスペースのキーを紙に。(Ctrl+P)</translation>
    </message>
    <message>
        <source>The keys of all workspaces, as a file.</source>
        <translation>全ワークスペースのキーをファイルに。</translation>
    </message>
    <message>
        <source>Gives commands other keys, in the preferences.</source>
        <translation>環境設定でコマンドに別のキーを割り当てます。</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>このページを閉じる (Esc)</translation>
    </message>
    <message>
        <source>No key and no command holds these letters.</source>
        <translation>この文字を含むキーもコマンドもありません。</translation>
    </message>
    <message>
        <source>Nobody is here to choose a printer.</source>
        <translation>プリンターを選ぶ人がいません。</translation>
    </message>
    <message>
        <source>Print the sheet of keys</source>
        <translation>キー一覧表を印刷</translation>
    </message>
    <message>
        <source>%1 does not take the sheet.</source>
        <translation>%1は一覧表を受け付けません。</translation>
    </message>
    <message>
        <source>Save the sheet of keys</source>
        <translation>キー一覧表を保存</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF文書 (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written there.</source>
        <translation>そこには%1を書き込めません。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelExchange</name>
    <message>
        <source>Labels (*.csv *.json *.eaf);;All files (*)</source>
        <translation>ラベル (*.csv *.json *.eaf);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>ラベルを取り込む</translation>
    </message>
    <message>
        <source>Compare with another person&apos;s labels</source>
        <translation>他の人のラベルと比較</translation>
    </message>
    <message>
        <source>Use another vocabulary</source>
        <translation>別の語彙を使う</translation>
    </message>
    <message>
        <source>Vocabularies (*.json)</source>
        <translation>語彙 (*.json)</translation>
    </message>
    <message>
        <source>Write labels</source>
        <translation>ラベルを書き出す</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json);;ELAN, the shown take (*.eaf)</source>
        <translation>表 (*.csv);;JSON (*.json);;ELAN、表示中のテイク (*.eaf)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1を読み込み中</translation>
    </message>
    <message>
        <source>%1: %2 of %3 labels found their action.</source>
        <translation>%1: %3件中%2件のラベルが動作と対応しました。</translation>
    </message>
    <message>
        <source>Labels written to %1.</source>
        <translation>ラベルを%1に書き出しました。</translation>
    </message>
    <message>
        <source>The vocabulary that the studio brings</source>
        <translation>既定の語彙</translation>
    </message>
    <message>
        <source>It has no word for these labels, which would be dropped (undo brings them back):</source>
        <translation>次のラベルに当たる語がないため、破棄されます (元に戻すと復活します):</translation>
    </message>
    <message>
        <source>The vocabulary is %1 now.</source>
        <translation>語彙は%1になりました。</translation>
    </message>
    <message>
        <source>%1: %2, %3 aspects.</source>
        <translation>%1: %2、観点%3個。</translation>
    </message>
    <message>
        <source>Use vocabulary</source>
        <translation>語彙を使う</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelLanes</name>
    <message>
        <source>%1 · action %2</source>
        <translation>%1 · 動作%2</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>メモ: %1</translation>
    </message>
    <message>
        <source>the machine would say %1</source>
        <translation>機械の判定は%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelLearning</name>
    <message>
        <source>Comparing actions</source>
        <translation>動作を比較中</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>学習中</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>較正中</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelPalette</name>
    <message>
        <source>Classes and their keys</source>
        <translation>クラスとキー</translation>
    </message>
    <message>
        <source>For two strikes in one action: this, then a class of another lane</source>
        <translation>1つの動作に打撃が2つあるとき: これを押してから別のレーンのクラス</translation>
    </message>
    <message>
        <source>
Right click: paint with it over actions of the timeline</source>
        <translation>
右クリック: タイムラインの動作に塗る</translation>
    </message>
    <message>
        <source>first, then two classes: both</source>
        <translation>を押してから2つのクラス：両方</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelPanel</name>
    <message>
        <source>Go on after an answer</source>
        <translation>回答後に次へ</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>キュー</translation>
    </message>
    <message>
        <source>Current action</source>
        <translation>現在の動作</translation>
    </message>
    <message>
        <source>Accept what is proposed</source>
        <translation>提案を承認します</translation>
    </message>
    <message>
        <source>Take the second best instead; of what a hand said, nothing any more</source>
        <translation>代わりに次点を採用します。手動で付けたものは「なし」になります</translation>
    </message>
    <message>
        <source>Why rules say so</source>
        <translation>ルールの根拠</translation>
    </message>
    <message>
        <source>Most useful first</source>
        <translation>役立つ順</translation>
    </message>
    <message>
        <source>Least sure first</source>
        <translation>不確かな順</translation>
    </message>
    <message>
        <source>In order of time</source>
        <translation>時間順</translation>
    </message>
    <message>
        <source>Order of the queue</source>
        <translation>キューの順序</translation>
    </message>
    <message>
        <source>Most useful: where the machine is torn, spread over different-looking actions</source>
        <translation>役立つ順: 機械が迷っているものを、見た目の異なる動作に広く分けて</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>質問</translation>
    </message>
    <message>
        <source>Sure from %1 on: %2</source>
        <translation>確実とみなす下限%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>動作%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>No action</source>
        <translation>動作なし</translation>
    </message>
    <message>
        <source>Actions appear here once a recording is open and cut.</source>
        <translation>収録を開いて分割すると、動作がここに表示されます。</translation>
    </message>
    <message>
        <source>%1 leads to the first question; or click an action.</source>
        <translation>%1で最初の質問へ。または動作をクリック。</translation>
    </message>
    <message>
        <source>%1 actions chosen</source>
        <translation>動作%1件を選択中</translation>
    </message>
    <message>
        <source>%1 · action %2 · %3</source>
        <translation>%1 · 動作%2 · %3</translation>
    </message>
    <message>
        <source>%1 · by hand</source>
        <translation>%1 · 手動</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>撤回</translation>
    </message>
    <message>
        <source>the only class so far</source>
        <translation>今のところ唯一のクラス</translation>
    </message>
    <message>
        <source>Nothing is proposed yet</source>
        <translation>まだ提案はありません</translation>
    </message>
    <message>
        <source>Something else: a class key</source>
        <translation>他のもの: クラスキー</translation>
    </message>
    <message>
        <source>Say what it is by a class key</source>
        <translation>クラスキーで答えてください</translation>
    </message>
    <message>
        <source>%1  %2  %3</source>
        <translation>%1  %2  %3</translation>
    </message>
    <message>
        <source>Queue %1</source>
        <translation>キュー %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelReview</name>
    <message>
        <source>There is no action to label.</source>
        <translation>ラベルを付ける動作がありません。</translation>
    </message>
    <message>
        <source>No question is left. Accept what rules and machine say of the rest.</source>
        <translation>質問は残っていません。残りはルールと機械の提案を承認してください。</translation>
    </message>
    <message>
        <source>No question was shown before.</source>
        <translation>前の質問はありません。</translation>
    </message>
    <message>
        <source>Said: %1. This is the next question.</source>
        <translation>回答: %1。次の質問です。</translation>
    </message>
    <message>
        <source>That is what a hand has said already.</source>
        <translation>すでに手動でそう付けてあります。</translation>
    </message>
    <message>
        <source>The machine proposes nothing yet: say what it is by a class key.</source>
        <translation>機械の提案はまだありません。クラスキーで答えてください。</translation>
    </message>
    <message>
        <source>There is no second best: say what it is by a class key.</source>
        <translation>次点がありません。クラスキーで答えてください。</translation>
    </message>
    <message>
        <source>%1 has no class %2.</source>
        <translation>%1にクラス%2はありません。</translation>
    </message>
    <message>
        <source>The next class key adds to the label.</source>
        <translation>次のクラスキーはラベルに追加されます。</translation>
    </message>
    <message>
        <source>Accepted as soon as the machine knows how sure it is.</source>
        <translation>機械の確かさがわかり次第、承認します。</translation>
    </message>
    <message>
        <source>Every action is labelled, all of them by hand.</source>
        <translation>すべての動作にラベルがあります。すべて手で付けたものです。</translation>
    </message>
    <message>
        <source>Every action is labelled; of these the machine was least sure. Return says that it is right.</source>
        <translation>すべての動作にラベルがあります。機械が最も自信のないものです。正しければ Enter を押します。</translation>
    </message>
    <message>
        <source>Said: %1. Now the class beside it.</source>
        <translation>回答：%1。次に一緒に付けるクラスを選びます。</translation>
    </message>
    <message numerus="yes">
        <source>Accepted: %n action(s). Ctrl+Z takes all of it back.</source>
        <translation>
            <numerusform>承認：%n 件の動作。Ctrl+Z でまとめて取り消せます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Accepted what rules say.</source>
        <translation>ルールの提案を承認しました。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelViews</name>
    <message>
        <source>Palette and questions</source>
        <translation>パレットと質問</translation>
    </message>
    <message>
        <source>Find actions by what is said of them</source>
        <translation>付けられた内容で動作を検索</translation>
    </message>
    <message>
        <source>Actions that look like the current one, side by side</source>
        <translation>現在の動作に似た動作を並べて表示</translation>
    </message>
    <message>
        <source>How well the machine knows the bout: confusion matrix and learning curve</source>
        <translation>機械の試合への理解度: 混同行列と学習曲線</translation>
    </message>
    <message>
        <source>Thresholds of the rules for move and react</source>
        <translation>移動と反応のルールのしきい値</translation>
    </message>
    <message>
        <source>Another person&apos;s labels beside these</source>
        <translation>他の人のラベルとの対照</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>ラベル</translation>
    </message>
    <message>
        <source>Find actions</source>
        <translation>動作を検索</translation>
    </message>
    <message>
        <source>Similar actions</source>
        <translation>似た動作</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>品質</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>ルール</translation>
    </message>
    <message>
        <source>Two people</source>
        <translation>二人の比較</translation>
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
        <translation>%1なし</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
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
        <translation>ルール</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>機械</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手動</translation>
    </message>
    <message>
        <source>accepted from a rule</source>
        <translation>ルールの提案を承認</translation>
    </message>
    <message>
        <source>accepted from the machine, %1</source>
        <translation>機械の提案を承認、%1</translation>
    </message>
    <message>
        <source>proposed by a rule</source>
        <translation>ルールの提案</translation>
    </message>
    <message>
        <source>proposed by a rule, %1</source>
        <translation>ルールの提案、%1</translation>
    </message>
    <message>
        <source>proposed: the only one seen so far</source>
        <translation>提案: 今までに見た唯一のもの</translation>
    </message>
    <message>
        <source>proposed by the machine, %1</source>
        <translation>機械の提案、%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LaneSource</name>
    <message>
        <source>labels</source>
        <translation>ラベル</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LearningPlot</name>
    <message>
        <source>Learning curve</source>
        <translation>学習曲線</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>期待値 %1</translation>
    </message>
    <message>
        <source>as asked %1</source>
        <translation>質問順 %1</translation>
    </message>
    <message>
        <source>random %1</source>
        <translation>無作為 %1</translation>
    </message>
    <message>
        <source>%1 labels: %2</source>
        <translation>ラベル%1個: %2</translation>
    </message>
    <message>
        <source>labels by hand</source>
        <translation>手動のラベル</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>期待値</translation>
    </message>
    <message>
        <source>as asked</source>
        <translation>質問順</translation>
    </message>
    <message>
        <source>random</source>
        <translation>無作為</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MadeMotion</name>
    <message>
        <source>Keep the motion as a take</source>
        <translation>モーションをテイクとして残す</translation>
    </message>
    <message>
        <source>Recordings (*.bvh)</source>
        <translation>収録 (*.bvh)</translation>
    </message>
    <message>
        <source>Keeping the motion</source>
        <translation>モーションを保存中</translation>
    </message>
    <message>
        <source>Kept as take %1.</source>
        <translation>テイク%1として残しました。</translation>
    </message>
    <message>
        <source>Export the motion</source>
        <translation>モーションを書き出す</translation>
    </message>
    <message>
        <source>Motion (*.bvh);;glTF: skeleton and animation (*.glb)</source>
        <translation>モーション (*.bvh);;glTF: スケルトンとアニメーション (*.glb)</translation>
    </message>
    <message>
        <source>Writing the motion</source>
        <translation>モーションを書き出し中</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き出しました: %1</translation>
    </message>
    <message>
        <source>Add clips</source>
        <translation>クリップを追加</translation>
    </message>
    <message>
        <source>Motion and projects (*.bvh *.amc *.kumite)</source>
        <translation>モーションとプロジェクト (*.bvh *.amc *.kumite)</translation>
    </message>
    <message>
        <source>Add all clips of a folder</source>
        <translation>フォルダーの全クリップを追加</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MainWindow</name>
    <message>
        <source>&amp;Segment</source>
        <translation>分割(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Remove or restore boundary</source>
        <translation>境界を削除／復元(&amp;R)</translation>
    </message>
    <message>
        <source>Split here: &amp;add a boundary</source>
        <translation>ここで分割: 境界を追加(&amp;A)</translation>
    </message>
    <message>
        <source>Join with the action &amp;before</source>
        <translation>前の動作と結合(&amp;B)</translation>
    </message>
    <message>
        <source>Join with the action af&amp;ter</source>
        <translation>後の動作と結合(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Previous boundary</source>
        <translation>前の境界(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next boundary</source>
        <translation>次の境界(&amp;N)</translation>
    </message>
    <message>
        <source>Move boundary one frame &amp;earlier</source>
        <translation>境界を1フレーム前へ(&amp;E)</translation>
    </message>
    <message>
        <source>Move boundary one frame &amp;later</source>
        <translation>境界を1フレーム後へ(&amp;L)</translation>
    </message>
    <message>
        <source>Select the action before</source>
        <translation>前の動作を選択</translation>
    </message>
    <message>
        <source>Select the action after</source>
        <translation>後の動作を選択</translation>
    </message>
    <message>
        <source>Sho&amp;w and loop the action</source>
        <translation>動作を表示してループ(&amp;W)</translation>
    </message>
    <message>
        <source>N&amp;ote on the action…</source>
        <translation>動作にメモ(&amp;O)…</translation>
    </message>
    <message>
        <source>Ne&amp;xt suspect</source>
        <translation>次の疑わしい極小(&amp;X)</translation>
    </message>
    <message>
        <source>Pre&amp;vious suspect</source>
        <translation>前の疑わしい極小(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Keep: it is a boundary</source>
        <translation>維持: 境界である(&amp;K)</translation>
    </message>
    <message>
        <source>Re&amp;move: it is spurious</source>
        <translation>削除: 偽の極小である(&amp;M)</translation>
    </message>
    <message>
        <source>De&amp;cide anew</source>
        <translation>判断し直す(&amp;C)</translation>
    </message>
    <message>
        <source>Compare with settings B</source>
        <translation>設定Bと比較</translation>
    </message>
    <message>
        <source>T&amp;imeline</source>
        <translation>タイムライン(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Height of the centre of mass</source>
        <translation>重心の高さ(&amp;H)</translation>
    </message>
    <message>
        <source>Force without &amp;smoothing</source>
        <translation>平滑化なしの力(&amp;S)</translation>
    </message>
    <message>
        <source>Speeds of the h&amp;ands</source>
        <translation>手の速さ(&amp;A)</translation>
    </message>
    <message>
        <source>Speeds of the &amp;feet</source>
        <translation>足の速さ(&amp;F)</translation>
    </message>
    <message>
        <source>Ruler in &amp;time and frames</source>
        <translation>ルーラーを時間とフレームで(&amp;T)</translation>
    </message>
    <message>
        <source>Ruler in time</source>
        <translation>ルーラーを時間で</translation>
    </message>
    <message>
        <source>Ruler in frames</source>
        <translation>ルーラーをフレームで</translation>
    </message>
    <message>
        <source>Next &amp;unit of the ruler</source>
        <translation>ルーラーの次の単位(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>ラベル(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Next question</source>
        <translation>次の質問(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Previous question</source>
        <translation>前の質問(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Accept what is proposed</source>
        <translation>提案を承認(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Reject: the second best instead</source>
        <translation>却下: 代わりに次点(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Take back what is said of the action</source>
        <translation>動作に付けたものを撤回(&amp;T)</translation>
    </message>
    <message>
        <source>Accept the &amp;sure rest</source>
        <translation>確実な残りを承認(&amp;S)</translation>
    </message>
    <message>
        <source>Less sure is sure eno&amp;ugh</source>
        <translation>確実の基準を緩める(&amp;U)</translation>
    </message>
    <message>
        <source>On&amp;ly surer is sure enough</source>
        <translation>確実の基準を厳しくする(&amp;L)</translation>
    </message>
    <message>
        <source>Answers &amp;go on to the next question</source>
        <translation>回答後に次の質問へ(&amp;G)</translation>
    </message>
    <message>
        <source>Lane abo&amp;ve</source>
        <translation>上のレーン(&amp;V)</translation>
    </message>
    <message>
        <source>Lane belo&amp;w</source>
        <translation>下のレーン(&amp;W)</translation>
    </message>
    <message>
        <source>Nothing of the lane&apos;s aspect</source>
        <translation>レーンの観点を「なし」に</translation>
    </message>
    <message>
        <source>Class %1 of the lane</source>
        <translation>レーンのクラス%1</translation>
    </message>
    <message>
        <source>Next class &amp;besides: a composite</source>
        <translation>次のクラスを加える: 複合(&amp;B)</translation>
    </message>
    <message>
        <source>Choose the action before as well</source>
        <translation>前の動作も選ぶ</translation>
    </message>
    <message>
        <source>Choose the action after as well</source>
        <translation>後の動作も選ぶ</translation>
    </message>
    <message>
        <source>Quick label %1</source>
        <translation>クイックラベル%1</translation>
    </message>
    <message>
        <source>Label: %1</source>
        <translation>ラベル: %1</translation>
    </message>
    <message>
        <source>Show pal&amp;ette and questions</source>
        <translation>パレットと質問を表示(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Find actions</source>
        <translation>動作を検索(&amp;F)</translation>
    </message>
    <message>
        <source>Show si&amp;milar actions</source>
        <translation>似た動作を表示(&amp;J)</translation>
    </message>
    <message>
        <source>Show &amp;quality</source>
        <translation>品質を表示(&amp;Q)</translation>
    </message>
    <message>
        <source>Show &amp;rules</source>
        <translation>ルールを表示(&amp;M)</translation>
    </message>
    <message>
        <source>Show &amp;two people&apos;s labels</source>
        <translation>二人のラベルを表示(&amp;X)</translation>
    </message>
    <message>
        <source>Ne&amp;xt action found</source>
        <translation>次の検索結果(&amp;Y)</translation>
    </message>
    <message>
        <source>Pre&amp;vious action found</source>
        <translation>前の検索結果(&amp;Z)</translation>
    </message>
    <message>
        <source>Choose &amp;all that were found</source>
        <translation>見つかったものをすべて選択(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Give similar actions the same label</source>
        <translation>似た動作に同じラベルを付ける(&amp;G)</translation>
    </message>
    <message>
        <source>Take t&amp;heirs</source>
        <translation>他者を採用(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>自分を維持(&amp;K)</translation>
    </message>
    <message>
        <source>Take theirs for all that are &amp;open</source>
        <translation>未決定のすべてに他者を採用(&amp;O)</translation>
    </message>
    <message>
        <source>Add what onl&amp;y they labelled</source>
        <translation>他者だけが付けたものを追加(&amp;A)</translation>
    </message>
    <message>
        <source>Next &amp;difference</source>
        <translation>次の違い(&amp;D)</translation>
    </message>
    <message>
        <source>Take &amp;over labels…</source>
        <translation>ラベルを取り込む(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Write labels…</source>
        <translation>ラベルを書き出す(&amp;W)…</translation>
    </message>
    <message>
        <source>&amp;Compare with labels of…</source>
        <translation>ラベルと比較(&amp;C)…</translation>
    </message>
    <message>
        <source>Use another voca&amp;bulary…</source>
        <translation>別の語彙を使う(&amp;B)…</translation>
    </message>
    <message>
        <source>Use the built-&amp;in vocabulary</source>
        <translation>内蔵の語彙を使う(&amp;I)</translation>
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
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>Open the &amp;demo bout</source>
        <translation>デモ試合を開く(&amp;D)</translation>
    </message>
    <message>
        <source>Open &amp;recordings…</source>
        <translation>収録を開く(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>プロジェクトを開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Opened &amp;lately</source>
        <translation>最近開いたもの(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>別名で保存(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Versions…</source>
        <translation>バージョン(&amp;V)…</translation>
    </message>
    <message>
        <source>&amp;Export actions…</source>
        <translation>動作を書き出す(&amp;E)…</translation>
    </message>
    <message>
        <source>Export &amp;motion…</source>
        <translation>モーションを書き出す(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Find recording…</source>
        <translation>収録を探す(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>Run a &amp;command by name…</source>
        <translation>名前でコマンドを実行(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>環境設定(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>再生／一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>Play &amp;backward, faster</source>
        <translation>逆再生、さらに速く(&amp;B)</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>Play &amp;forward, faster</source>
        <translation>再生、さらに速く(&amp;F)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>1フレーム戻る</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>1フレーム進む</translation>
    </message>
    <message>
        <source>Leap</source>
        <translation>大きく移動</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>先頭へ</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>末尾へ</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>遅く</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>速く</translation>
    </message>
    <message>
        <source>Loop begins here</source>
        <translation>ループをここから</translation>
    </message>
    <message>
        <source>Loop ends here</source>
        <translation>ループをここまで</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>ループ(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>すべて表示(&amp;A)</translation>
    </message>
    <message>
        <source>Show the &amp;fighter and what is selected</source>
        <translation>選手と選択範囲を表示(&amp;F)</translation>
    </message>
    <message>
        <source>Hide &amp;panels</source>
        <translation>パネルを隠す(&amp;P)</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>全画面(&amp;U)</translation>
    </message>
    <message>
        <source>Theme as the system</source>
        <translation>テーマはシステムに合わせる</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>ライトテーマ</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>ダークテーマ</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>文字を大きく</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>文字を小さく</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>分割</translation>
    </message>
    <message>
        <source>Correct the boundaries that cut the bout into actions.</source>
        <translation>試合を動作に区切る境界を直します。</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>ラベル</translation>
    </message>
    <message>
        <source>Say what a few actions are; the machine says it of the rest.</source>
        <translation>いくつかの動作が何かを示すと、残りは機械が答えます。</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>What each fighter tends to do next, and the moments behind it.</source>
        <translation>各選手が次にしがちなことと、その元の場面。</translation>
    </message>
    <message>
        <source>Label actions</source>
        <translation>動作にラベルを付ける</translation>
    </message>
    <message>
        <source>Go to the Label workspace</source>
        <translation>ラベルワークスペースへ移動</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>ラベルを取り込む</translation>
    </message>
    <message>
        <source>From a table of labels; of a made bout at once its truth</source>
        <translation>ラベルの表から。人工の試合なら正解をすぐに</translation>
    </message>
    <message>
        <source>Bout</source>
        <translation>試合</translation>
    </message>
    <message>
        <source>Let both fight on from what was learnt, or fight yourself.</source>
        <translation>学んだことから両者を戦わせ続けるか、自分で戦います。</translation>
    </message>
    <message>
        <source>Clips of sequences</source>
        <translation>シーケンスのクリップ</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>シーケンス</translation>
    </message>
    <message>
        <source>Play actions in any order, led over to each other.</source>
        <translation>動作を好きな順に、なめらかにつないで再生します。</translation>
    </message>
    <message>
        <source>Add clips…</source>
        <translation>クリップを追加…</translation>
    </message>
    <message>
        <source>Of motion files or other projects</source>
        <translation>モーションファイルや他のプロジェクトから</translation>
    </message>
    <message>
        <source>Keyframe</source>
        <translation>キーフレーム</translation>
    </message>
    <message>
        <source>A few key poses become a motion made of the recorded ones.</source>
        <translation>いくつかのキーポーズが、収録された動きからなるモーションになります。</translation>
    </message>
    <message>
        <source>%1 frames back</source>
        <translation>%1フレーム戻る</translation>
    </message>
    <message>
        <source>%1 frames on</source>
        <translation>%1フレーム進む</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>measure from or to it</source>
        <translation>そこから／そこまで測る</translation>
    </message>
    <message>
        <source>other fighter</source>
        <translation>もう一方の選手</translation>
    </message>
    <message>
        <source>leave measuring</source>
        <translation>計測をやめる</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>next suspect</source>
        <translation>次の疑わしい極小</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>維持</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>action</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>next question</source>
        <translation>次の質問</translation>
    </message>
    <message>
        <source>accept</source>
        <translation>承認</translation>
    </message>
    <message>
        <source>second best</source>
        <translation>次点</translation>
    </message>
    <message>
        <source>lane</source>
        <translation>レーン</translation>
    </message>
    <message>
        <source>… its classes</source>
        <translation>… そのクラス</translation>
    </message>
    <message>
        <source>fight</source>
        <translation>戦う</translation>
    </message>
    <message>
        <source>… lead the avatar</source>
        <translation>… アバターを操作</translation>
    </message>
    <message>
        <source>go on otherwise</source>
        <translation>別の展開で続ける</translation>
    </message>
    <message>
        <source>… play a block at once</source>
        <translation>… ブロックをすぐ再生</translation>
    </message>
    <message>
        <source>back to the sequence</source>
        <translation>シーケンスに戻る</translation>
    </message>
    <message>
        <source>find an action</source>
        <translation>動作を探す</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>追加する</translation>
    </message>
    <message>
        <source>block</source>
        <translation>ブロック</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>draw its transition anew</source>
        <translation>遷移を引き直す</translation>
    </message>
    <message>
        <source>map of poses</source>
        <translation>ポーズの地図</translation>
    </message>
    <message>
        <source>live</source>
        <translation>ライブ</translation>
    </message>
    <message>
        <source>add a key here</source>
        <translation>ここにキーポーズを追加</translation>
    </message>
    <message>
        <source>key</source>
        <translation>キーポーズ</translation>
    </message>
    <message>
        <source>take the recording&apos;s pose</source>
        <translation>収録のポーズを使う</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>ハンドル</translation>
    </message>
    <message>
        <source>pin it</source>
        <translation>留める</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>左右反転</translation>
    </message>
    <message>
        <source>back to the keys</source>
        <translation>キーポーズに戻る</translation>
    </message>
    <message>
        <source>hit a target</source>
        <translation>ターゲットに当てる</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>モーション</translation>
    </message>
    <message>
        <source>keep as a take</source>
        <translation>テイクとして残す</translation>
    </message>
    <message>
        <source>next surprise</source>
        <translation>次の意外な遷移</translation>
    </message>
    <message>
        <source>play what is behind</source>
        <translation>元の場面を再生</translation>
    </message>
    <message>
        <source>matrix or graph</source>
        <translation>行列／グラフ</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>境界</translation>
    </message>
    <message>
        <source>add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>any command</source>
        <translation>任意のコマンド</translation>
    </message>
    <message>
        <source>help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>1 finding</source>
        <translation>指摘1件</translation>
    </message>
    <message>
        <source>%1 findings</source>
        <translation>指摘%1件</translation>
    </message>
    <message>
        <source>What was found in the recordings</source>
        <translation>収録で見つかったこと</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>テイク(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Add recordings as a take…</source>
        <translation>収録をテイクとして追加(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Rename take</source>
        <translation>テイクの名前を変更(&amp;R)</translation>
    </message>
    <message>
        <source>Re&amp;move take</source>
        <translation>テイクを削除(&amp;M)</translation>
    </message>
    <message>
        <source>Move take &amp;up</source>
        <translation>テイクを上へ移動(&amp;U)</translation>
    </message>
    <message>
        <source>Move take &amp;down</source>
        <translation>テイクを下へ移動(&amp;D)</translation>
    </message>
    <message>
        <source>Show the take &amp;before</source>
        <translation>前のテイクを表示(&amp;B)</translation>
    </message>
    <message>
        <source>Show the take a&amp;fter</source>
        <translation>次のテイクを表示(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Other fighter active</source>
        <translation>もう一方の選手をアクティブに(&amp;O)</translation>
    </message>
    <message>
        <source>Fighter &amp;properties…</source>
        <translation>選手のプロパティ(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Swap fighters</source>
        <translation>選手を入れ替える(&amp;S)</translation>
    </message>
    <message>
        <source>F&amp;indings on the recordings</source>
        <translation>収録での指摘(&amp;I)</translation>
    </message>
    <message>
        <source>Removed take %1. %2 brings it back.</source>
        <translation>テイク%1を削除しました。%2で元に戻せます。</translation>
    </message>
    <message>
        <source>leave the field or button</source>
        <translation>欄やボタンから離れる</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MatrixPage</name>
    <message>
        <source>log</source>
        <translation>対数</translation>
    </message>
    <message>
        <source>by own label</source>
        <translation>自分のラベル別</translation>
    </message>
    <message>
        <source>by opponent&apos;s label</source>
        <translation>相手のラベル別</translation>
    </message>
    <message>
        <source>by both labels</source>
        <translation>両方のラベル別</translation>
    </message>
    <message>
        <source>What the rows know</source>
        <translation>行の条件</translation>
    </message>
    <message>
        <source>What the rows know: what the fighter does, what the opponent does, or both. What is left out is summed over.</source>
        <translation>行の条件: 選手の動作、相手の動作、または両方。除いたものは合計されます。</translation>
    </message>
    <message>
        <source>by count</source>
        <translation>件数順</translation>
    </message>
    <message>
        <source>by name</source>
        <translation>名前順</translation>
    </message>
    <message>
        <source>by likeness</source>
        <translation>類似順</translation>
    </message>
    <message>
        <source>Order of rows and columns</source>
        <translation>行と列の順序</translation>
    </message>
    <message>
        <source>By likeness rows that lead to the same labels become neighbours; a line parts the groups.</source>
        <translation>類似順では、同じラベルにつながる行が隣り合い、線がグループを分けます。</translation>
    </message>
    <message>
        <source>P, EQU7</source>
        <translation>P、EQU7</translation>
    </message>
    <message>
        <source>P, EQU6</source>
        <translation>P、EQU6</translation>
    </message>
    <message>
        <source>P, EQU5</source>
        <translation>P、EQU5</translation>
    </message>
    <message>
        <source>as counted</source>
        <translation>数えたまま</translation>
    </message>
    <message>
        <source>How probabilities are estimated</source>
        <translation>確率の推定方法</translation>
    </message>
    <message>
        <source>EQU7: P(next | own) · P(next | opponent). EQU6: over pairs of label elements. EQU5: counts of whole triples. All three with a prior, so that nothing is impossible; as counted: without.</source>
        <translation>EQU7: P(次 | 自分) · P(次 | 相手)。EQU6: ラベル要素の対から。EQU5: 三つ組全体の件数から。3つとも事前分布付きで、あり得ないものはなくなります。数えたまま: 事前分布なし。</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>並べて</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>How two are compared</source>
        <translation>2つの比較方法</translation>
    </message>
    <message>
        <source>Colours over the logarithm: rare transitions become visible</source>
        <translation>対数による色分け: まれな遷移も見えます</translation>
    </message>
    <message>
        <source>Matrix of transitions to compare with</source>
        <translation>比較対象の遷移行列</translation>
    </message>
    <message>
        <source>P(next | own)</source>
        <translation>P(次 | 自分)</translation>
    </message>
    <message>
        <source>P(next | opponent)</source>
        <translation>P(次 | 相手)</translation>
    </message>
    <message>
        <source>P(next | own, opponent)</source>
        <translation>P(次 | 自分, 相手)</translation>
    </message>
    <message>
        <source>%1 − %2</source>
        <translation>%1 − %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>difference %1</source>
        <translation>差 %1</translation>
    </message>
    <message>
        <source>P %1</source>
        <translation>P %1</translation>
    </message>
    <message>
        <source>%1 → %2   ·   %3   ·   seen %4 of %5 times</source>
        <translation>%1 → %2   ·   %3   ·   %5回中%4回</translation>
    </message>
    <message>
        <source>%1   ·   %2 transitions begin so</source>
        <translation>%1   ·   ここから始まる遷移%2件</translation>
    </message>
    <message>
        <source>%1   ·   %2 transitions lead here</source>
        <translation>%1   ·   ここに至る遷移%2件</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MatrixView</name>
    <message>
        <source>Matrix of transitions</source>
        <translation>遷移の行列</translation>
    </message>
    <message>
        <source>A row is what goes on, a column what follows. Arrows lead from cell to cell; the moments behind the chosen one are listed beside it.</source>
        <translation>行は今していること、列は次に来ること。矢印キーでセルを移動すると、選んだセルの元の場面が横に並びます。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MessageStrip</name>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>起きたこと</translation>
    </message>
    <message numerus="yes">
        <source> And %n more.</source>
        <translation>
            <numerusform> 他%n件。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::MotionBox</name>
    <message>
        <source>joints adjusted</source>
        <translation>関節を調整</translation>
    </message>
    <message>
        <source>What the motion is made of</source>
        <translation>モーションの構成</translation>
    </message>
    <message>
        <source>whole body</source>
        <translation>全身</translation>
    </message>
    <message>
        <source>What is looked for</source>
        <translation>探すもの</translation>
    </message>
    <message>
        <source>In what the places are like the keys: the whole body or one part</source>
        <translation>どこがキーに似ているか：全身か一つの部位</translation>
    </message>
    <message>
        <source>Similar in</source>
        <translation>似ている部位</translation>
    </message>
    <message>
        <source>The keys and places like them</source>
        <translation>キーとそれに似た場所</translation>
    </message>
    <message>
        <source>First the keys, then what is most like them; a click takes it</source>
        <translation>まずキー、次に最も似たもの。クリックで採用</translation>
    </message>
    <message>
        <source>Places that are like the keys</source>
        <translation>キーポーズに似た場所</translation>
    </message>
    <message>
        <source>The places that are most like the keys, the best first; a click, or Return, takes the body or the part from there</source>
        <translation>キーに最も似た場所を良い順に。クリックか Enter でそこから体や部位を採ります</translation>
    </message>
    <message>
        <source>what fits better</source>
        <translation>より合うもの</translation>
    </message>
    <message>
        <source>with the body</source>
        <translation>全身と同じ</translation>
    </message>
    <message>
        <source>its own best</source>
        <translation>部位ごとの最良</translation>
    </message>
    <message>
        <source>as chosen above</source>
        <translation>上で選んだとおり</translation>
    </message>
    <message>
        <source>Where the %1 comes from</source>
        <translation>%1の出所</translation>
    </message>
    <message>
        <source>Take a part from elsewhere</source>
        <translation>部位を別の場所から取る</translation>
    </message>
    <message>
        <source>Where parts are joined the joints&apos; mean and spread become those of the keys (paper C, 4.2.2)</source>
        <translation>部位をつなぐ所で、関節の平均と広がりをキーポーズのものに合わせます (論文C、4.2.2)</translation>
    </message>
    <message>
        <source>How far the motion is drawn to the keys</source>
        <translation>モーションをキーポーズに引き寄せる度合い</translation>
    </message>
    <message>
        <source>Left: as it was found; right: through the keys&apos; poses</source>
        <translation>左: 見つかったまま、右: キーポーズを通る</translation>
    </message>
    <message>
        <source>Meet keys</source>
        <translation>キーポーズに合わせる</translation>
    </message>
    <message>
        <source>Join parts otherwise</source>
        <translation>部位を別の方法でつなぐ</translation>
    </message>
    <message>
        <source>Draw the motion to the keys</source>
        <translation>モーションをキーポーズに引き寄せる</translation>
    </message>
    <message>
        <source>Two keys or more become a motion, put together from the takes and clips.</source>
        <translation>キーポーズが2つ以上あると、テイクとクリップを組み合わせたモーションになります。</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>モーションを作成中です。</translation>
    </message>
    <message>
        <source>Body: %1, %2 of %3 features differ, %4 cm from the keys.</source>
        <translation>全身: %1、特徴%3個中%2個が相違、キーポーズから%4 cm。</translation>
    </message>
    <message>
        <source>%1 features differ, %2 cm from the keys</source>
        <translation>特徴%1個が相違、キーポーズから%2 cm</translation>
    </message>
    <message>
        <source>%1, %2 features differ</source>
        <translation>%1、特徴%2個が相違</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Take the %1 from elsewhere</source>
        <translation>%1を別の所から採る</translation>
    </message>
    <message>
        <source>Take the body from elsewhere</source>
        <translation>全身を別の場所から取る</translation>
    </message>
</context>
<context>
    <name>kumite::studio::NodePage</name>
    <message>
        <source>cross edges</source>
        <translation>選手間エッジ</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Fighter 1&apos;s graph before fighter 2&apos;s, cross edges between; drag turns</source>
        <translation>選手1のグラフを選手2の手前に置き、間に選手間エッジを表示。ドラッグで回転</translation>
    </message>
    <message>
        <source>Also what a fighter does next given what the opponent is doing; those of what is selected show always</source>
        <translation>相手の動作を踏まえた選手の次の動作も表示。選択中のものは常に表示します</translation>
    </message>
    <message>
        <source>Of each side only what it does more often than the other, as wide as the difference</source>
        <translation>それぞれ他方より多くすることだけを、差の分の太さで</translation>
    </message>
    <message>
        <source>Least probability of an edge</source>
        <translation>エッジの最小確率</translation>
    </message>
    <message>
        <source>Edges that are less probable are not drawn.</source>
        <translation>これより確率の低いエッジは描きません。</translation>
    </message>
    <message>
        <source>Most edges from a node</source>
        <translation>ノードごとの最大エッジ数</translation>
    </message>
    <message>
        <source>So many edges of each node are drawn, the likeliest ones.</source>
        <translation>ノードごとに、確率の高い順にこの数のエッジを描きます。</translation>
    </message>
    <message>
        <source>ΔP ≥ 0.000</source>
        <translation>ΔP ≥ 0.000</translation>
    </message>
    <message>
        <source>12 a node</source>
        <translation>各12本</translation>
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
        <translation>各%1本</translation>
    </message>
    <message>
        <source>%1: %2   ·   %3 actions</source>
        <translation>%1: %2   ·   動作%3件</translation>
    </message>
    <message>
        <source>%1: %2 → %3   ·   %4 %5   ·   seen %6 times</source>
        <translation>%1: %2 → %3   ·   %4 %5   ·   %6回</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%2に対する%1</translation>
    </message>
    <message>
        <source>more often by</source>
        <translation>多い分</translation>
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
        <translation>動作のメモ</translation>
    </message>
    <message>
        <source>Return keeps the note, Esc leaves it as it was; no text removes it.</source>
        <translation>Returnで保存、Escで元のまま、空にすると削除します。</translation>
    </message>
    <message>
        <source>Note on this action</source>
        <translation>この動作のメモ</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PartDialog</name>
    <message>
        <source>joints adjusted</source>
        <translation>関節を調整</translation>
    </message>
    <message>
        <source>Replace a part of a take</source>
        <translation>テイクの一部を置き換え</translation>
    </message>
    <message>
        <source>In</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>take that is changed</source>
        <translation>変更するテイク</translation>
    </message>
    <message>
        <source>Part that is replaced</source>
        <translation>置き換える部位</translation>
    </message>
    <message>
        <source>Where the part hangs on the rest its joint keeps the take&apos;s mean and spread</source>
        <translation>部位がつながる関節は、テイクの平均とばらつきを保ちます</translation>
    </message>
    <message>
        <source>The</source>
        <translation>部位</translation>
    </message>
    <message>
        <source>By that of</source>
        <translation>提供元</translation>
    </message>
    <message>
        <source>take or clip that lends the part</source>
        <translation>部位を提供するテイクかクリップ</translation>
    </message>
    <message>
        <source>The take, what lends the part, and the result</source>
        <translation>テイク、部位の提供元、結果</translation>
    </message>
    <message>
        <source>What becomes of it</source>
        <translation>どうなるか</translation>
    </message>
    <message>
        <source>Keep as a take…</source>
        <translation>テイクとして残す…</translation>
    </message>
    <message>
        <source>The %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>First frame of the %1</source>
        <translation>%1の最初のフレーム</translation>
    </message>
    <message>
        <source>Last frame of the %1</source>
        <translation>%1の最後のフレーム</translation>
    </message>
    <message>
        <source>%1, at %2 Hz</source>
        <translation>%1、%2 Hz</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>元のまま</translation>
    </message>
    <message>
        <source>what lends the %1</source>
        <translation>%1の提供元</translation>
    </message>
    <message>
        <source>the result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>%1 of the take&apos;s %2 are changed, in the %3 only; all else stays.</source>
        <translation>テイクの %2 のうち %1 を変更、%3だけ。他はそのまま。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PartWords</name>
    <message>
        <source>left arm</source>
        <translation>左腕</translation>
    </message>
    <message>
        <source>right arm</source>
        <translation>右腕</translation>
    </message>
    <message>
        <source>left leg</source>
        <translation>左脚</translation>
    </message>
    <message>
        <source>right leg</source>
        <translation>右脚</translation>
    </message>
    <message>
        <source>trunk, head</source>
        <translation>胴、頭</translation>
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
        <translation>左足</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>右足</translation>
    </message>
    <message>
        <source>hips</source>
        <translation>腰</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>胸</translation>
    </message>
    <message>
        <source>head</source>
        <translation>頭</translation>
    </message>
    <message>
        <source>even</source>
        <translation>均等</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>なめらか</translation>
    </message>
    <message>
        <source>from rest</source>
        <translation>静止から</translation>
    </message>
    <message>
        <source>to rest</source>
        <translation>静止へ</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>stays where it is</source>
        <translation>位置を固定</translation>
    </message>
    <message>
        <source>and later keys</source>
        <translation>後のキーも</translation>
    </message>
    <message>
        <source>The chosen key</source>
        <translation>選択中のキーポーズ</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>ハンドル</translation>
    </message>
    <message>
        <source>What is drawn: drag it in the 3D view, or give its place below</source>
        <translation>動かす部位: 3D表示でドラッグするか、下で位置を入力します</translation>
    </message>
    <message>
        <source>While another handle is drawn this one stays; Ctrl and a click on it does the same</source>
        <translation>他のハンドルを動かす間、これは動きません。Ctrl+クリックでも同じです</translation>
    </message>
    <message>
        <source>Place, %1 in metres</source>
        <translation>位置、%1 (メートル)</translation>
    </message>
    <message>
        <source>%1, metres; y is up</source>
        <translation>%1、メートル。yが上</translation>
    </message>
    <message>
        <source>x y z, m</source>
        <translation>x y z, m</translation>
    </message>
    <message>
        <source>Way to the next key</source>
        <translation>次のキーポーズへの経過</translation>
    </message>
    <message>
        <source>How the way to the next key goes</source>
        <translation>次のキーポーズまでの進み方</translation>
    </message>
    <message>
        <source>Way on</source>
        <translation>経過</translation>
    </message>
    <message>
        <source>Frame of the key</source>
        <translation>キーのフレーム</translation>
    </message>
    <message>
        <source>Moves the key to that frame</source>
        <translation>キーをそのフレームへ移動します</translation>
    </message>
    <message>
        <source>Later keys go as many frames along</source>
        <translation>後のキーも同じフレーム数だけ動きます</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Time from this key on, times</source>
        <translation>このキーからの時間の倍率</translation>
    </message>
    <message>
        <source>All later keys that many times as far from this one: 2 is half as fast</source>
        <translation>後のキーをすべてこの倍率だけ離します。2 なら半分の速さ</translation>
    </message>
    <message>
        <source>Time on</source>
        <translation>以後の時間</translation>
    </message>
    <message>
        <source>Frame %1. Drag hands, feet, hips, chest or head in the 3D view.</source>
        <translation>フレーム%1。3D表示で手、足、腰、胸、頭をドラッグします。</translation>
    </message>
    <message>
        <source>Return makes a key.</source>
        <translation>Returnでキーポーズを作ります。</translation>
    </message>
    <message>
        <source>Choose a key to change its pose.</source>
        <translation>キーポーズを選ぶと、ポーズを変えられます。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PoseDialog</name>
    <message>
        <source>Copy a pose</source>
        <translation>ポーズをコピー</translation>
    </message>
    <message>
        <source>Take or clip</source>
        <translation>テイクかクリップ</translation>
    </message>
    <message>
        <source>Whose pose is copied: a fighter of a take, or a clip</source>
        <translation>誰のポーズをコピーするか：テイクの選手かクリップ</translation>
    </message>
    <message>
        <source>The pose</source>
        <translation>ポーズ</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>時点</translation>
    </message>
    <message>
        <source>Which moment; arrow keys go on by one frame</source>
        <translation>どの時点か。矢印キーで 1 フレームずつ進みます</translation>
    </message>
    <message>
        <source>Frame of the take or clip</source>
        <translation>テイクやクリップのフレーム</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Copy the pose</source>
        <translation>ポーズをコピー</translation>
    </message>
    <message>
        <source>frame %1 at %2 Hz</source>
        <translation>フレーム %1（%2 Hz）</translation>
    </message>
    <message>
        <source>Copy the pose of %1</source>
        <translation>%1のポーズをコピー</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>環境設定</translation>
    </message>
    <message>
        <source>General</source>
        <translation>一般</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>既定値に戻す</translation>
    </message>
    <message>
        <source>All values of the General page as the studio brings them.</source>
        <translation>一般ページの値をすべて既定に戻します。</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>このページを閉じる (Esc)</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>外観</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>テーマ</translation>
    </message>
    <message>
        <source>Colours of the whole window.</source>
        <translation>ウィンドウ全体の色です。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Of all texts, numbers and dates in the window; files do not know it. The window is made anew at once, with what is open in it.</source>
        <translation>ウィンドウの文字、数、日付の言語。ファイルには影響しません。開いているものを保ったままウィンドウをすぐ作り直します。</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Text size, percent</source>
        <translation>文字の大きさ（パーセント）</translation>
    </message>
    <message>
        <source>How large all text is; pages that it makes too large can be scrolled.</source>
        <translation>すべての文字の大きさ。大きくなりすぎたページはスクロールできます。</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>文字の大きさ</translation>
    </message>
    <message>
        <source>Reduce motion</source>
        <translation>動きを減らす</translation>
    </message>
    <message>
        <source>Nothing begins to move by itself: questions and similar actions stand still until you play them.</source>
        <translation>何も自動では動き出しません。問いや似た動作は再生するまで止まっています。</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Playback speed of a bout that is opened, percent</source>
        <translation>開いた試合の再生速度 (パーセント)</translation>
    </message>
    <message>
        <source>How fast a bout plays when it is opened. While it is open, - and + change it.</source>
        <translation>試合を開いたときの再生の速さ。開いた後は-と+で変えられます。</translation>
    </message>
    <message>
        <source>Speed at opening</source>
        <translation>開いたときの速度</translation>
    </message>
    <message>
        <source>Play in a loop</source>
        <translation>ループ再生</translation>
    </message>
    <message>
        <source>Whether a bout loops when it is opened.</source>
        <translation>試合を開いたときにループするかどうか。</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> フレーム</translation>
    </message>
    <message>
        <source>Frames of a leap</source>
        <translation>一度に移動するフレーム数</translation>
    </message>
    <message>
        <source>How far Shift+← and Shift+→ go.</source>
        <translation>Shift+←とShift+→で移動する量。</translation>
    </message>
    <message>
        <source>Shift+← → goes</source>
        <translation>Shift+← →の移動量</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>Mouse sensitivity in the 3D view, percent</source>
        <translation>3D表示でのマウス感度 (パーセント)</translation>
    </message>
    <message>
        <source>How fast a drag turns and the wheel zooms in the 3D view.</source>
        <translation>3D表示でのドラッグによる回転とホイールによるズームの速さ。</translation>
    </message>
    <message>
        <source>Sensitivity in 3D</source>
        <translation>3Dでの感度</translation>
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
        <translation>自動保存の間隔 (秒)</translation>
    </message>
    <message>
        <source>After how long at most changes are kept for a recovery. The project file itself is written only when you save.</source>
        <translation>復旧用に変更を残すまでの最長時間。プロジェクトファイル自体は、保存したときだけ書き込まれます。</translation>
    </message>
    <message>
        <source>Autosave every</source>
        <translation>自動保存の間隔</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ProgressBox</name>
    <message>
        <source>Progress of labelling</source>
        <translation>ラベル付けの進み具合</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>次にすること</translation>
    </message>
    <message>
        <source>Keep what machine and rules propose where they are at least so sure; one step of the history (Ctrl+Return)</source>
        <translation>確信度がこれ以上の、機械とルールの提案を採用します。履歴の1ステップです (Ctrl+Return)</translation>
    </message>
    <message>
        <source>Labelled by hand, accepted, open</source>
        <translation>手動、承認済み、未定</translation>
    </message>
    <message>
        <source>How sure the machine must be of what is accepted: 0.90 is nine of ten right. Ctrl+Down and Ctrl+Up move it.</source>
        <translation>承認するものに求める機械の確かさ。0.90なら10件中9件が正解。Ctrl+DownとCtrl+Upで変えます。</translation>
    </message>
    <message>
        <source>Least probability of what is accepted</source>
        <translation>承認するものの最小確率</translation>
    </message>
    <message>
        <source>Proposals that are at least so probable are accepted.</source>
        <translation>確率がこれ以上の提案を承認します。</translation>
    </message>
    <message>
        <source>%1 actions: %2 labelled by hand (dark), %3 accepted (light), %4 open</source>
        <translation>動作%1件: 手動%2 (濃色)、承認済み%3 (淡色)、未定%4</translation>
    </message>
    <message>
        <source>%1 labelled</source>
        <translation>ラベル済み%1</translation>
    </message>
    <message>
        <source>, expected accuracy %1</source>
        <translation>, 期待正解率%1</translation>
    </message>
    <message>
        <source>Accept rules</source>
        <translation>ルールを承認</translation>
    </message>
    <message>
        <source>Accept %1 sure</source>
        <translation>確実な%1件を承認</translation>
    </message>
    <message>
        <source>Accept the sure</source>
        <translation>確実なものを承認</translation>
    </message>
    <message>
        <source>Every action is labelled. File &gt; Save keeps it; Label &gt; Write labels… makes a table.</source>
        <translation>すべての動作にラベルがあります。ファイル &gt; 保存 で残り、ラベル &gt; ラベルを書き出す… で表になります。</translation>
    </message>
    <message>
        <source>No recording is cut into actions yet.</source>
        <translation>動作に分割された収録がまだありません。</translation>
    </message>
    <message>
        <source>Label a few actions by hand; the machine proposes the others. N leads to the one that says most.</source>
        <translation>いくつかの動作に手動でラベルを付けると、他は機械が提案します。Nで最も役立つものへ進みます。</translation>
    </message>
    <message>
        <source>Go on: N leads to the next one that says most.</source>
        <translation>続けましょう。Nで次に役立つものへ進みます。</translation>
    </message>
    <message>
        <source>What rules say is left to be accepted.</source>
        <translation>ルールの提案が承認待ちです。</translation>
    </message>
    <message>
        <source>Nothing of %1 was labelled so far: if there is any, show the machine one.</source>
        <translation>%1にはまだラベルがありません。該当するものがあれば、機械に1つ示してください。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Accept %1 guesses</source>
        <translation>推測 %1 件を承認</translation>
    </message>
    <message>
        <source>Every action has a label, but of ten that the machine gave only about %1 are right. N leads through those of which it was least sure; or undo the acceptance and answer more questions.</source>
        <translation>すべての動作にラベルがありますが、機械が付けた十件のうち正しいのは約 %1 件です。N で自信のないものから確認するか、承認を取り消してさらに質問に答えてください。</translation>
    </message>
    <message numerus="yes">
        <source>%n minima are still suspect. Half actions are hard to label: correct them in Segment first, or go on with N.</source>
        <translation>
            <numerusform>疑わしい極小が %n 個残っています。半端な動作はラベルを付けにくいので、先に分割で直すか、N で進みます。</numerusform>
        </translation>
    </message>
    <message>
        <source>How many of the machine&apos;s answers should be right where no hand has spoken</source>
        <translation>手で答えていない動作で、機械の答えが正しいと見込まれる割合</translation>
    </message>
    <message>
        <source>More labels by hand will hardly help: accept the sure rest (%1), lower the bar for the others (%2), then look through the least sure (%3).</source>
        <translation>手のラベルを増やしても効果はわずかです。確実な残りを承認し (%1)、ほかはしきい値を下げ (%2)、最後に自信のないものを見直します (%3)。</translation>
    </message>
    <message>
        <source>Go on: the next ones tell the machine most.</source>
        <translation>続けましょう。次の質問が機械に最も役立ちます。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::QualityBox</name>
    <message>
        <source>Actions of the cell</source>
        <translation>セルの動作</translation>
    </message>
    <message>
        <source>Aspect of the confusion matrix</source>
        <translation>混同行列の観点</translation>
    </message>
    <message>
        <source>Whose classes the matrix and the list are about.</source>
        <translation>行列と一覧で扱うクラスの観点。</translation>
    </message>
    <message>
        <source>What the cell says</source>
        <translation>セルの意味</translation>
    </message>
    <message>
        <source>Share of actions whose learnt aspects are all right. Expected: cross-validation over the hand labels as the session went. As asked and random: the hand labels are dealt into folds; one is held out, and from the others the machine learns more and more labels, in the order in which the queue asks for them and in random orders. Both are judged on the same held-out labels. What was asked for is harder than the rest, so the bout as a whole fares better.</source>
        <translation>学習した観点がすべて正しい動作の割合。期待値: セッションの経過に沿った、手動ラベルでの交差検証。質問順と無作為: 手動ラベルを分割し、1つを取り分け、残りから機械がキューの質問順または無作為の順にラベルを増やして学習します。どちらも取り分けた同じラベルで評価します。質問されたものは残りより難しいため、試合全体ではもっと良くなります。</translation>
    </message>
    <message>
        <source>Judging</source>
        <translation>評価中</translation>
    </message>
    <message>
        <source>Comparing orders</source>
        <translation>順序を比較中</translation>
    </message>
    <message>
        <source>How often machine and rules say the same as your hand appears here, once some actions are labelled by hand.</source>
        <translation>いくつかの動作に手動でラベルを付けると、機械とルールが手動とどれだけ一致するかがここに表示されます。</translation>
    </message>
    <message>
        <source>No hand has said anything of this aspect.</source>
        <translation>この観点には手動のラベルがありません。</translation>
    </message>
    <message>
        <source>Rows by hand, columns %1. %2 of %3 right, F1 %4.</source>
        <translation>行は手動、列は%1。%3件中%2件正解、F1 %4。</translation>
    </message>
    <message>
        <source>by rule</source>
        <translation>ルール</translation>
    </message>
    <message>
        <source>by machine, unseen</source>
        <translation>機械 (未見)</translation>
    </message>
    <message>
        <source>A click on a cell, or Enter, opens its actions.</source>
        <translation>セルをクリックするかEnterで、その動作を開きます。</translation>
    </message>
    <message>
        <source>No action is in this cell.</source>
        <translation>このセルに動作はありません。</translation>
    </message>
    <message>
        <source>%1 labels as asked do what %2 in random order do.</source>
        <translation>質問順の%1ラベルは、無作為の%2ラベルに相当します。</translation>
    </message>
    <message>
        <source>With %1 hand labels the order of the questions is compared with a random one.</source>
        <translation>手動ラベルが%1個になると、質問の順序を無作為な順序と比較します。</translation>
    </message>
    <message>
        <source>More labels will hardly help.</source>
        <translation>ラベルを増やしても、ほとんど効果はありません。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Questions</name>
    <message>
        <source>%1: nobody is here to choose a file.</source>
        <translation>%1: ファイルを選ぶ人がいません。</translation>
    </message>
    <message>
        <source>%1 Nobody is here to answer: %2.</source>
        <translation>%1 答える人がいません: %2。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RecentButton</name>
    <message>
        <source>Open %1, %2</source>
        <translation>%1を開く、%2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Recovery</name>
    <message>
        <source>Saving a copy</source>
        <translation>コピーを保存中</translation>
    </message>
    <message>
        <source>Recovery copies cannot be written. %1</source>
        <translation>復旧用のコピーを書き込めません。%1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RecoveryDialog</name>
    <message>
        <source>Recover</source>
        <translation>復旧</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>復旧</translation>
    </message>
    <message>
        <source>Kumite ended unexpectedly. The edits that were not saved are kept here; recovered, they stand in the project as unsaved changes.</source>
        <translation>Kumiteが予期せず終了しました。保存されていない編集はここに残っています。復旧すると、保存していない変更としてプロジェクトに入ります。</translation>
    </message>
    <message>
        <source>Projects that can be recovered</source>
        <translation>復旧できるプロジェクト</translation>
    </message>
    <message>
        <source>What was not saved; a double-click recovers it</source>
        <translation>保存されていないもの。ダブルクリックで復旧します</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Last edit</source>
        <translation>最後の編集</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>保存なし</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>後で</translation>
    </message>
    <message>
        <source>Delete the chosen edits for good (Del)</source>
        <translation>選んだ編集を完全に削除します (Del)</translation>
    </message>
    <message>
        <source>Open the chosen project with its unsaved edits (Enter)</source>
        <translation>選んだプロジェクトを、未保存の編集とともに開きます (Enter)</translation>
    </message>
    <message>
        <source>Keep them and ask again at the next start (Esc)</source>
        <translation>残しておき、次の起動時にまた尋ねます (Esc)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Review</name>
    <message numerus="yes">
        <source>What you decided clears %n more.</source>
        <translation>
            <numerusform>この判断で、さらに%n件の疑いが晴れました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n suspect(s) left.</source>
        <translation>
            <numerusform>疑わしい極小は残り%n件。</numerusform>
        </translation>
    </message>
    <message>
        <source>Every minimum of this take is decided.</source>
        <translation>このテイクの極小はすべて判断済みです。</translation>
    </message>
    <message>
        <source>No suspect is left. N leads through the other minima.</source>
        <translation>疑わしい極小は残っていません。Nで他の極小へ進みます。</translation>
    </message>
    <message>
        <source>No boundary is selected. N leads to the most suspicious minimum.</source>
        <translation>境界が選択されていません。Nで最も疑わしい極小へ進みます。</translation>
    </message>
    <message>
        <source>No minimum is left to decide.</source>
        <translation>判断する極小は残っていません。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RoleTable</name>
    <message>
        <source>read off the skeleton&apos;s shape</source>
        <translation>スケルトンの形から判定</translation>
    </message>
    <message>
        <source>no human body found</source>
        <translation>人体が見つかりません</translation>
    </message>
    <message>
        <source>by %1 names</source>
        <translation>%1の名前から</translation>
    </message>
    <message>
        <source>Joints of the roles</source>
        <translation>役割の関節</translation>
    </message>
    <message>
        <source>Which joint of the recording is which part of the body</source>
        <translation>収録のどの関節が体のどの部分か</translation>
    </message>
    <message>
        <source>fighter 1</source>
        <translation>選手1</translation>
    </message>
    <message>
        <source>fighter 2</source>
        <translation>選手2</translation>
    </message>
    <message>
        <source>Fighter %1: %2 of %3 roles, %4.</source>
        <translation>選手%1: 役割%3個中%2個、%4。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>set by hand</source>
        <translation>手動で設定</translation>
    </message>
    <message>
        <source>found</source>
        <translation>検出済み</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>見つかりません</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RulesBox</name>
    <message>
        <source>Lands below</source>
        <translation>接地の高さ</translation>
    </message>
    <message>
        <source>Height below which a foot lands</source>
        <translation>足が接地する高さの上限</translation>
    </message>
    <message>
        <source>A foot stands once its toes are lower than this above their rest height …</source>
        <translation>つま先が静止時の高さからこれより低く …</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>slower than</source>
        <translation>接地の速さ</translation>
    </message>
    <message>
        <source>Speed below which a foot lands</source>
        <translation>足が接地する速さの上限</translation>
    </message>
    <message>
        <source>… and slower than this.</source>
        <translation>… これより遅くなると接地とみなします。</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Lifts above</source>
        <translation>離地の高さ</translation>
    </message>
    <message>
        <source>Height above which a foot lifts</source>
        <translation>足が離れる高さの下限</translation>
    </message>
    <message>
        <source>It no longer stands once its toes are higher than this …</source>
        <translation>つま先がこれより高くなるか …</translation>
    </message>
    <message>
        <source>faster than</source>
        <translation>離地の速さ</translation>
    </message>
    <message>
        <source>Speed above which a foot lifts</source>
        <translation>足が離れる速さの下限</translation>
    </message>
    <message>
        <source>… or faster than this.</source>
        <translation>… これより速くなると離地とみなします。</translation>
    </message>
    <message>
        <source>Stands for</source>
        <translation>接地の長さ</translation>
    </message>
    <message>
        <source>Shortest stance</source>
        <translation>最短の接地</translation>
    </message>
    <message>
        <source>A stance that is shorter does not count.</source>
        <translation>これより短い接地は数えません。</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Closes at</source>
        <translation>接近の速さ</translation>
    </message>
    <message>
        <source>Speed at which an attack must close</source>
        <translation>攻撃が接近すべき速さ</translation>
    </message>
    <message>
        <source>An attack counts for the react rule if its fist or foot closes on the trunk or head faster than this at some moment.</source>
        <translation>反応のルールで攻撃とみなすのは、拳か足がある瞬間にこれより速く胴か頭に近づくものです。</translation>
    </message>
    <message>
        <source>Usual thresholds</source>
        <translation>通常のしきい値</translation>
    </message>
    <message>
        <source>Back to the thresholds that the studio brings</source>
        <translation>既定のしきい値に戻します</translation>
    </message>
    <message>
        <source>What the thresholds change</source>
        <translation>しきい値による変化</translation>
    </message>
    <message>
        <source>Why the rules say so</source>
        <translation>ルールの根拠</translation>
    </message>
    <message>
        <source>%1: no action</source>
        <translation>%1: 動作なし</translation>
    </message>
    <message>
        <source>%1: %2 of %3 actions</source>
        <translation>%1: 動作%3件中%2件</translation>
    </message>
    <message>
        <source>How many actions get another label stands here while a threshold is changed.</source>
        <translation>しきい値を変える間、ラベルが変わる動作の数がここに表示されます。</translation>
    </message>
    <message>
        <source>Changed: %1.</source>
        <translation>変化: %1。</translation>
    </message>
    <message>
        <source>React: %1</source>
        <translation>反応: %1</translation>
    </message>
    <message>
        <source>Move: %1</source>
        <translation>移動: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SegmentPanel</name>
    <message>
        <source>Keep</source>
        <translation>維持</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Suspect minima</source>
        <translation>疑わしい極小</translation>
    </message>
    <message>
        <source>Minima of the force curves that cut actions appear here, the most suspicious first. Lower the prominence below to see more.</source>
        <translation>動作を区切る力の曲線の極小が、疑わしい順にここに表示されます。もっと見るには下のプロミネンスを下げてください。</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>Detection</source>
        <translation>検出</translation>
    </message>
    <message>
        <source>Why the minimum is suspected</source>
        <translation>極小が疑わしい理由</translation>
    </message>
    <message>
        <source>It is a boundary: no suspect any more; goes on to the next</source>
        <translation>境界です。疑いは解け、次へ進みます</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>A boundary that a hand has set.</source>
        <translation>手動で置いた境界です。</translation>
    </message>
    <message>
        <source>No suspect is left. %1 leads through the others.</source>
        <translation>疑わしい極小は残っていません。%1で他へ進みます。</translation>
    </message>
    <message>
        <source>Bring the boundary back</source>
        <translation>境界を復活させます</translation>
    </message>
    <message>
        <source>It is spurious; goes on to the next</source>
        <translation>偽の極小です。次へ進みます</translation>
    </message>
    <message>
        <source>%1 leads to the most suspicious minimum. Remove it where the body hardly dips: a kick down and up again is one action. Keep it where one ends and another begins.</source>
        <translation>%1 で最も疑わしい極小に進みます。体の沈みがわずかなら削除します。下ろしてまた上げる蹴りは1つの動作です。動作が終わり、次が始まる所は維持します。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceBar</name>
    <message>
        <source>Time of the sequence</source>
        <translation>シーケンスの時刻</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>/ %1</translation>
    </message>
    <message>
        <source>the chosen action, %1 s; Esc: back to the sequence</source>
        <translation>選択中の動作、%1 s。Esc: シーケンスに戻る</translation>
    </message>
    <message>
        <source>live: 1 … 9 play blocks at once</source>
        <translation>ライブ: 1 … 9でブロックをすぐ再生</translation>
    </message>
    <message>
        <source> · last %1, cost %2</source>
        <translation> · 直前は%1、コスト %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceCommands</name>
    <message>
        <source>Se&amp;quence</source>
        <translation>シーケンス(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>再生／一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>1フレーム戻る</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>1フレーム進む</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>先頭へ</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>末尾へ</translation>
    </message>
    <message>
        <source>Play it &amp;over and over</source>
        <translation>繰り返し再生(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Live: keys play blocks at once</source>
        <translation>ライブ: キーでブロックをすぐ再生(&amp;L)</translation>
    </message>
    <message>
        <source>Live: block %1</source>
        <translation>ライブ: ブロック%1</translation>
    </message>
    <message>
        <source>Back to the sequence</source>
        <translation>シーケンスに戻る</translation>
    </message>
    <message>
        <source>The playhead is not inside the chosen block.</source>
        <translation>再生ヘッドが選択中のブロックの中にありません。</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>%1をトリム</translation>
    </message>
    <message>
        <source>&amp;Add the chosen action</source>
        <translation>選択中の動作を追加(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;wap the block for the chosen action</source>
        <translation>ブロックを選択中の動作と交換(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Remove the block</source>
        <translation>ブロックを削除(&amp;R)</translation>
    </message>
    <message>
        <source>Block before</source>
        <translation>前のブロック</translation>
    </message>
    <message>
        <source>Block after</source>
        <translation>次のブロック</translation>
    </message>
    <message>
        <source>Move the block &amp;earlier</source>
        <translation>ブロックを前へ移動(&amp;E)</translation>
    </message>
    <message>
        <source>Move the &amp;block later</source>
        <translation>ブロックを後へ移動(&amp;B)</translation>
    </message>
    <message>
        <source>Once &amp;more</source>
        <translation>もう1回増やす(&amp;M)</translation>
    </message>
    <message>
        <source>Repeat the block</source>
        <translation>ブロックを繰り返す</translation>
    </message>
    <message>
        <source>Once less</source>
        <translation>1回減らす</translation>
    </message>
    <message>
        <source>Repeat the block less</source>
        <translation>ブロックの繰り返しを減らす</translation>
    </message>
    <message>
        <source>Block begins at the playhead</source>
        <translation>ブロックを再生ヘッドから始める</translation>
    </message>
    <message>
        <source>Block ends at the playhead</source>
        <translation>ブロックを再生ヘッドで終える</translation>
    </message>
    <message>
        <source>The whole action again</source>
        <translation>動作全体に戻す</translation>
    </message>
    <message>
        <source>Trim nothing</source>
        <translation>トリムなし</translation>
    </message>
    <message>
        <source>&amp;Draw the transition anew</source>
        <translation>遷移を引き直す(&amp;D)</translation>
    </message>
    <message>
        <source>Draw all that are not locked anew</source>
        <translation>ロックされていないものをすべて引き直す</translation>
    </message>
    <message>
        <source>Loc&amp;k the transition, or let it go</source>
        <translation>遷移をロック／解除(&amp;K)</translation>
    </message>
    <message>
        <source>Unlock the transition</source>
        <translation>遷移のロックを解除</translation>
    </message>
    <message>
        <source>Lock the transition</source>
        <translation>遷移をロック</translation>
    </message>
    <message>
        <source>Clear the sequence</source>
        <translation>シーケンスを空にする</translation>
    </message>
    <message>
        <source>&amp;Find an action</source>
        <translation>動作を探す(&amp;F)</translation>
    </message>
    <message>
        <source>Show all of it</source>
        <translation>全体を表示</translation>
    </message>
    <message>
        <source>Map of po&amp;ses</source>
        <translation>ポーズの地図(&amp;G)</translation>
    </message>
    <message>
        <source>Add &amp;clips of files…</source>
        <translation>ファイルのクリップを追加(&amp;C)…</translation>
    </message>
    <message>
        <source>Add cl&amp;ips of a folder…</source>
        <translation>フォルダーのクリップを追加(&amp;H)…</translation>
    </message>
    <message>
        <source>Keep as a &amp;take…</source>
        <translation>テイクとして残す(&amp;T)…</translation>
    </message>
    <message>
        <source>E&amp;xport the sequence…</source>
        <translation>シーケンスを書き出す(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequencePanel</name>
    <message>
        <source>What appears here</source>
        <translation>ここに表示されるもの</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>動作を検索</translation>
    </message>
    <message>
        <source>Shows the actions in which every word appears: right kick</source>
        <translation>すべての語を含む動作を表示します: 右 蹴り</translation>
    </message>
    <message>
        <source>Actions to choose from</source>
        <translation>選べる動作</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>クリップ…</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>残す…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出す…</translation>
    </message>
    <message>
        <source>Actions of the takes, and clips of other files, in any order, led over to each other: they appear here.</source>
        <translation>テイクの動作と他のファイルのクリップを好きな順に、なめらかにつないだものがここに表示されます。</translation>
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
        <translation>クリップを準備中</translation>
    </message>
    <message>
        <source>Making the motion</source>
        <translation>モーションを作成中</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1を追加</translation>
    </message>
    <message>
        <source>Swap for %1</source>
        <translation>%1と交換</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1を削除</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1を移動</translation>
    </message>
    <message>
        <source>Clear the sequence</source>
        <translation>シーケンスを空にする</translation>
    </message>
    <message>
        <source>Draw the transition anew</source>
        <translation>遷移を引き直す</translation>
    </message>
    <message>
        <source>Draw all anew</source>
        <translation>すべて引き直す</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceStrip</name>
    <message>
        <source>Blocks of the sequence</source>
        <translation>シーケンスのブロック</translation>
    </message>
    <message>
        <source>  (%1 of %2)</source>
        <translation>  (%1 / %2)</translation>
    </message>
    <message>
        <source>Actions in the order in which they shall be played. Choose one at the right and press Return to add it.</source>
        <translation>再生する順の動作です。右で1つ選び、Returnで追加します。</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>モーションを作成中です。</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>%1をトリム</translation>
    </message>
    <message>
        <source>Drag to trim</source>
        <translation>ドラッグでトリム</translation>
    </message>
    <message>
        <source>transition to %1 · %2 to %3</source>
        <translation>%1への遷移 · %2～%3</translation>
    </message>
    <message>
        <source>%1 · %2 to %3</source>
        <translation>%1 · %2～%3</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Session</name>
    <message>
        <source>The edit that waited was dropped: another take is shown.</source>
        <translation>別のテイクが表示されたため、待っていた編集は破棄されました。</translation>
    </message>
    <message>
        <source>The edit waits until the force curves are computed.</source>
        <translation>編集は力の曲線の計算が終わるまで待ちます。</translation>
    </message>
    <message>
        <source>No boundary of %1 lies within 0.1 s of the playhead.</source>
        <translation>再生ヘッドから0.1 s以内に%1の境界はありません。</translation>
    </message>
    <message>
        <source>This is the first action: nothing comes before it.</source>
        <translation>最初の動作です。前には何もありません。</translation>
    </message>
    <message>
        <source>This is the last action: nothing comes after it.</source>
        <translation>最後の動作です。後には何もありません。</translation>
    </message>
    <message>
        <source>A removed boundary does not move. Del restores it.</source>
        <translation>削除した境界は動かせません。Delで復元します。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SettingsFields</name>
    <message>
        <source>Cutoff of the low-pass in Hz</source>
        <translation>ローパスのカットオフ (Hz)</translation>
    </message>
    <message>
        <source>Low-pass over the centre of mass: lower gives smoother curves and fewer minima.</source>
        <translation>重心へのローパス: 低いほど曲線がなめらかになり、極小が減ります。</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>Least prominence in body weights</source>
        <translation>最小のプロミネンス (体重比)</translation>
    </message>
    <message>
        <source>A minimum must be at least this deep to be a boundary.</source>
        <translation>境界になる極小に必要な深さです。</translation>
    </message>
    <message>
        <source> BW</source>
        <translation> BW</translation>
    </message>
    <message>
        <source>Cutoff</source>
        <translation>カットオフ</translation>
    </message>
    <message>
        <source>Promin.</source>
        <translation>プロミネンス</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>length of the force</source>
        <translation>力の大きさ</translation>
    </message>
    <message>
        <source>vertical part</source>
        <translation>鉛直成分</translation>
    </message>
    <message>
        <source>Curve that is cut at its minima</source>
        <translation>極小で区切る曲線</translation>
    </message>
    <message>
        <source>Which curve is cut at its minima: the length of the contact force or its vertical part.</source>
        <translation>極小で区切る曲線: 接地力の大きさか、その鉛直成分。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SimilarBox</name>
    <message>
        <source>this one, %1</source>
        <translation>これ、%1</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>承認済み</translation>
    </message>
    <message>
        <source>%1, %2%3</source>
        <translation>%1、%2%3</translation>
    </message>
    <message>
        <source> ⇄</source>
        <translation> ⇄</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>両者</translation>
    </message>
    <message>
        <source>Nearest by the numbers from which the machine learns; ⇄: its mirror image is near, and it is seen from the other side. All begin and end together.</source>
        <translation>機械が学習に使う数値で最も近いもの。⇄: 鏡像が近く、反対側から見たもの。すべて同時に始まり、同時に終わります。</translation>
    </message>
    <message>
        <source>The chosen ones get the label of the first one, said by a hand, as one step of the history. A click or Space chooses, a double click or Enter goes there.</source>
        <translation>選んだものに最初のもののラベルを手動として付けます。履歴の1ステップです。クリックかSpaceで選択、ダブルクリックかEnterでそこへ移動します。</translation>
    </message>
    <message>
        <source>Show both fighters: the opponent, too</source>
        <translation>両選手を表示: 相手も</translation>
    </message>
    <message>
        <source>Comparing actions</source>
        <translation>動作を比較中</translation>
    </message>
    <message>
        <source>The actions most like the current one.</source>
        <translation>現在の動作に最も似た動作。</translation>
    </message>
    <message>
        <source>The actions most like the current one appear here, once there is an action at the playhead.</source>
        <translation>再生ヘッドの位置に動作があると、最も似た動作がここに表示されます。</translation>
    </message>
    <message>
        <source>Same label for all</source>
        <translation>すべてに同じラベル</translation>
    </message>
    <message>
        <source>Same label for %1</source>
        <translation>%1件に同じラベル</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageCommands</name>
    <message>
        <source>Save a picture of the 3D view</source>
        <translation>3D表示の画像を保存</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Picture of the 3D view</source>
        <translation>3D表示の画像</translation>
    </message>
    <message>
        <source>%1: the picture cannot be written there.</source>
        <translation>%1: そこには画像を書き込めません。</translation>
    </message>
    <message>
        <source>3&amp;D view</source>
        <translation>3D表示(&amp;D)</translation>
    </message>
    <message>
        <source>From the f&amp;ront</source>
        <translation>正面から(&amp;R)</translation>
    </message>
    <message>
        <source>From the &amp;side</source>
        <translation>横から(&amp;S)</translation>
    </message>
    <message>
        <source>From a&amp;bove</source>
        <translation>上から(&amp;B)</translation>
    </message>
    <message>
        <source>Over the shoulder of fighter 1</source>
        <translation>選手1の肩越しに</translation>
    </message>
    <message>
        <source>Over the shoulder of fighter 2</source>
        <translation>選手2の肩越しに</translation>
    </message>
    <message>
        <source>&amp;Follow the fighters</source>
        <translation>選手を追う(&amp;F)</translation>
    </message>
    <message>
        <source>Foot &amp;contacts</source>
        <translation>足の接地(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Trails of hands and feet</source>
        <translation>手足の軌跡(&amp;T)</translation>
    </message>
    <message>
        <source>Centre of &amp;mass</source>
        <translation>重心(&amp;M)</translation>
    </message>
    <message>
        <source>Contact f&amp;orce</source>
        <translation>接地力(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Ghosts</source>
        <translation>ゴースト(&amp;G)</translation>
    </message>
    <message>
        <source>Longer trails</source>
        <translation>軌跡を長く</translation>
    </message>
    <message>
        <source>Shorter trails</source>
        <translation>軌跡を短く</translation>
    </message>
    <message>
        <source>&amp;Leave a ghost here</source>
        <translation>ここにゴーストを残す(&amp;L)</translation>
    </message>
    <message>
        <source>Remove all ghosts</source>
        <translation>ゴーストをすべて削除</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>計測(&amp;A)</translation>
    </message>
    <message>
        <source>Measure: next joint</source>
        <translation>計測: 次の関節</translation>
    </message>
    <message>
        <source>Measure: joint before</source>
        <translation>計測: 前の関節</translation>
    </message>
    <message>
        <source>Measure from, then to this joint</source>
        <translation>この関節から、次にこの関節まで測る</translation>
    </message>
    <message>
        <source>Leave measuring</source>
        <translation>計測をやめる</translation>
    </message>
    <message>
        <source>Co&amp;py a picture</source>
        <translation>画像をコピー(&amp;P)</translation>
    </message>
    <message>
        <source>Save a p&amp;icture…</source>
        <translation>画像を保存(&amp;I)…</translation>
    </message>
    <message>
        <source>Click two joints; or %1 and %2 lead to a joint, %3 takes it</source>
        <translation>関節を2つクリック。または%1と%2で関節へ移動し、%3で選択</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageTools</name>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Where the camera stands</source>
        <translation>カメラの位置</translation>
    </message>
    <message>
        <source>Shown in 3D</source>
        <translation>3Dでの表示</translation>
    </message>
    <message>
        <source>What the 3D view shows</source>
        <translation>3D表示に出すもの</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>測る</translation>
    </message>
    <message>
        <source>Trails, frames</source>
        <translation>軌跡、フレーム数</translation>
    </message>
    <message>
        <source>Frames of trail before the shown one</source>
        <translation>表示フレームより前の軌跡のフレーム数</translation>
    </message>
    <message>
        <source>Frames of trail after the shown one</source>
        <translation>表示フレームより後の軌跡のフレーム数</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageView</name>
    <message>
        <source>3D view</source>
        <translation>3D表示</translation>
    </message>
    <message>
        <source>The fighters at the playhead: a drag turns, the wheel zooms</source>
        <translation>再生ヘッド位置の選手。ドラッグで回転、ホイールでズーム</translation>
    </message>
    <message>
        <source>before the action</source>
        <translation>動作の前</translation>
    </message>
    <message>
        <source>after the action</source>
        <translation>動作の後</translation>
    </message>
    <message>
        <source>grid 1 m</source>
        <translation>格子1 m</translation>
    </message>
    <message>
        <source>   ·   left limbs lighter</source>
        <translation>   ·   左の手足は淡色</translation>
    </message>
    <message>
        <source>   ·   arrow: contact force, 0.5 m per BW</source>
        <translation>   ·   矢印: 接地力、1 BWあたり0.5 m</translation>
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
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%2から%3まで%1</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%2から%1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>%1から</translation>
    </message>
    <message>
        <source>No joint is chosen. %1</source>
        <translation>関節が選ばれていません。%1</translation>
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
        <translation>区切られた動作の数</translation>
    </message>
    <message>
        <source>min/s</source>
        <translation>極小/s</translation>
    </message>
    <message>
        <source>Minima a second that cut by themselves</source>
        <translation>単独で区切る極小の毎秒の数</translation>
    </message>
    <message>
        <source>corr.</source>
        <translation>修正</translation>
    </message>
    <message>
        <source>Share of boundaries that a hand removed, moved or added</source>
        <translation>手動で削除、移動、追加した境界の割合</translation>
    </message>
    <message>
        <source>left</source>
        <translation>残り</translation>
    </message>
    <message>
        <source>Suspects that nobody has decided yet. Every decision teaches what is suspect, so that others may be cleared, too</source>
        <translation>まだ誰も判断していない疑わしい極小。判断のたびに何が疑わしいかを学ぶため、他の疑いも晴れることがあります</translation>
    </message>
    <message>
        <source>take</source>
        <translation>テイク</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SurpriseStrip</name>
    <message>
        <source>Surprise of the transitions</source>
        <translation>遷移の意外度</translation>
    </message>
    <message>
        <source>Both terms</source>
        <translation>両方の項</translation>
    </message>
    <message>
        <source>−log P(next | own, opponent, motion): seen how it moves, another label was likelier. Finds labels that are wrong.</source>
        <translation>−log P(次 | 自分, 相手, 動き): 動きから見て別のラベルの方があり得たもの。誤ったラベルが見つかります。</translation>
    </message>
    <message>
        <source>Label term alone</source>
        <translation>ラベル項のみ</translation>
    </message>
    <message>
        <source>−log P(next | own, opponent): a label that seldom follows. Finds rare decisions.</source>
        <translation>−log P(次 | 自分, 相手): めったに続かないラベル。まれな判断が見つかります。</translation>
    </message>
    <message>
        <source>Geometry term alone</source>
        <translation>幾何項のみ</translation>
    </message>
    <message>
        <source>−log density of places, facing and poses under the label, from its mean: no probability. Finds odd poses and places.</source>
        <translation>−log ラベル内での位置、向き、ポーズの密度 (平均からの差)。確率ではありません。奇妙なポーズや位置が見つかります。</translation>
    </message>
    <message>
        <source>How unexpected each transition was to a model that had not seen it, in nats.
%1</source>
        <translation>その遷移を見ていないモデルにとって、それぞれの遷移がどれだけ予想外だったか (nat)。
%1</translation>
    </message>
    <message>
        <source>Which surprise is shown</source>
        <translation>表示する意外度</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>意外度</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 → %4 while %5   ·   %6</source>
        <translation>%1 · %2 · %3 → %4、相手: %5   ·   %6</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SuspectsModel</name>
    <message>
        <source>, removed</source>
        <translation>, 削除済み</translation>
    </message>
    <message>
        <source>, accepted</source>
        <translation>, 承認済み</translation>
    </message>
    <message>
        <source>, set by hand</source>
        <translation>, 手動で設置</translation>
    </message>
    <message>
        <source>%1, suspicion %2: %3</source>
        <translation>%1、疑い%2: %3</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>What speaks against the minimum, and how deep it is</source>
        <translation>極小を疑う理由と、その深さ</translation>
    </message>
    <message>
        <source>How likely the minimum is spurious, learnt from what hands removed and accepted; ✓ accepted or set by hand, × removed</source>
        <translation>極小が偽である確からしさ。手動の削除と承認から学習。✓ 承認または手動で設置、× 削除</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>why</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>susp.</source>
        <translation>疑い</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TakesList</name>
    <message>
        <source>%1
Double-click or F2 renames, Alt+↑ ↓ or a drag moves it.</source>
        <translation>%1
ダブルクリックかF2で名前を変更、Alt+↑ ↓かドラッグで移動します。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TimelineView</name>
    <message>
        <source>time, frame</source>
        <translation>時間、フレーム</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Release to move the boundary here, Esc to leave it, Ctrl or Alt to place it freely.</source>
        <translation>放すと境界をここへ移動、Escで元のまま、CtrlかAltで自由に配置。</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>Force curves of the fighters, the boundaries that cut them, and the actions between</source>
        <translation>選手の力の曲線、それを区切る境界、その間の動作</translation>
    </message>
    <message>
        <source>Preparing curves</source>
        <translation>曲線を準備中</translation>
    </message>
    <message>
        <source>%1 · frame %2</source>
        <translation>%1 · フレーム%2</translation>
    </message>
    <message>
        <source>%1 · %2 · frame %3</source>
        <translation>%1 · %2 · フレーム%3</translation>
    </message>
    <message>
        <source> · action %1</source>
        <translation> · 動作%1</translation>
    </message>
    <message>
        <source> · note: %1</source>
        <translation> · メモ: %1</translation>
    </message>
    <message>
        <source> · removed boundary</source>
        <translation> · 削除した境界</translation>
    </message>
    <message>
        <source> · accepted boundary</source>
        <translation> · 承認した境界</translation>
    </message>
    <message>
        <source> · moved boundary</source>
        <translation> · 移動した境界</translation>
    </message>
    <message>
        <source> · added boundary</source>
        <translation> · 追加した境界</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Tour</name>
    <message>
        <source>&amp;Tour on the demo bout</source>
        <translation>デモ試合のツアー(&amp;T)</translation>
    </message>
    <message>
        <source>Tour: next step</source>
        <translation>ツアー: 次のステップ</translation>
    </message>
    <message>
        <source>Tour: step before</source>
        <translation>ツアー: 前のステップ</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>ツアーを終了</translation>
    </message>
    <message>
        <source>Correct a suspect</source>
        <translation>疑わしい極小を直す</translation>
    </message>
    <message>
        <source>Label an action</source>
        <translation>動作にラベルを付ける</translation>
    </message>
    <message>
        <source>%1 leads to the action that says most; it loops. Say what it is: %2 is a left punch forward, %3 a right one; the palette shows the other keys.</source>
        <translation>%1で最も役立つ動作へ進み、ループします。何かを答えましょう: %2は左突き・前、%3は右突き・前。他のキーはパレットにあります。</translation>
    </message>
    <message>
        <source>Let the machine say the rest</source>
        <translation>残りは機械に任せる</translation>
    </message>
    <message>
        <source>A machine learns from your labels. One is few: here a third of the bout can be labelled for you. Then %1 accepts all that the machine is sure of; %2 takes it back.</source>
        <translation>機械はラベルから学びます。1つでは足りないので、ここでは試合の3分の1に代わりにラベルを付けられます。その後%1で機械が確信するものをすべて承認し、%2で元に戻します。</translation>
    </message>
    <message>
        <source>Label a third for me</source>
        <translation>3分の1に自動でラベル付け</translation>
    </message>
    <message>
        <source>See what follows what</source>
        <translation>続き方を見る</translation>
    </message>
    <message>
        <source>A row is what goes on, a column what comes next. Click a cell: the moments behind it are listed, a click plays one. %1 leads to the most surprising moment.</source>
        <translation>行は今していること、列は次に来ること。セルをクリックすると元の場面が並び、クリックで再生します。%1で最も意外な場面へ進みます。</translation>
    </message>
    <message>
        <source>Let them fight on</source>
        <translation>両者を戦わせ続ける</translation>
    </message>
    <message>
        <source>%1 starts a bout that was never fought, made from what was learnt. Every choice stands at the right; a click takes another one. Back with %2, on otherwise with %3.</source>
        <translation>%1で、学んだことから作られる、実際にはなかった試合が始まります。選択はすべて右に並び、クリックで別のものを選べます。%2で戻り、%3で別の展開に進みます。</translation>
    </message>
    <message>
        <source>The minima of the force cut the bout into actions; a few are wrong. %1 leads to the likeliest, plays it and says why; %2 stops. %3 keeps it, %4 removes it.</source>
        <translation>力の極小が試合を動作に区切りますが、いくつかは誤りです。%1で最も疑わしいものへ進み、前後を再生して理由を示します。%2で停止。%3で維持、%4で削除します。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TourBox</name>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ 完了</translation>
    </message>
    <message>
        <source>This step is done</source>
        <translation>このステップは完了です</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>やめる</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 / %2: %3</translation>
    </message>
    <message>
        <source>Tour, step %1</source>
        <translation>ツアー、ステップ%1</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TraceBox</name>
    <message>
        <source>Behind it</source>
        <translation>元の場面</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>選択中のもの</translation>
    </message>
    <message>
        <source>Transitions behind it</source>
        <translation>元になった遷移</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>意外度</translation>
    </message>
    <message>
        <source>Choose a cell, a node, an edge or a row above: the moments behind it appear here, and a click plays them.</source>
        <translation>上のセル、ノード、エッジ、行を選ぶと、元の場面がここに表示され、クリックで再生します。</translation>
    </message>
    <message>
        <source>%1. Never seen.</source>
        <translation>%1。見られません。</translation>
    </message>
    <message>
        <source>%1. Seen once.</source>
        <translation>%1。1回見られました。</translation>
    </message>
    <message>
        <source>%1. Seen %2 times.</source>
        <translation>%1。%2回見られました。</translation>
    </message>
    <message>
        <source>%1. Never seen so; these share the own label.</source>
        <translation>%1。この形では見られません。以下は自分のラベルが同じものです。</translation>
    </message>
    <message>
        <source>%1. Never seen so; these share the opponent&apos;s label.</source>
        <translation>%1。この形では見られません。以下は相手のラベルが同じものです。</translation>
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
        <translation>%1、%2: %3
%4
クリックで再生</translation>
    </message>
    <message>
        <source>Surprise (%1), nats: how unexpected it was to a model that had not seen it</source>
        <translation>意外度 (%1)、nat: 見たことのないモデルにとってどれだけ予想外だったか</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>own → next</source>
        <translation>自分 → 次</translation>
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
        <translation>%1の収録が見つかりません。ファイル ▸ 収録を探す… で場所を指定してください。</translation>
    </message>
    <message>
        <source>No contact force: this skeleton has no body that is known here. S adds boundaries by hand.</source>
        <translation>接地力なし: このスケルトンには既知の体がありません。Sで境界を手動で追加します。</translation>
    </message>
    <message>
        <source>force, BW</source>
        <translation>力, BW</translation>
    </message>
    <message>
        <source>unsmoothed</source>
        <translation>平滑化なし</translation>
    </message>
    <message>
        <source>COM, m</source>
        <translation>重心, m</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>hands, m/s</source>
        <translation>手, m/s</translation>
    </message>
    <message>
        <source>feet, m/s</source>
        <translation>足, m/s</translation>
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
        <translation>遷移</translation>
    </message>
    <message>
        <source>The transition</source>
        <translation>この遷移</translation>
    </message>
    <message>
        <source>Ways that the transition can go</source>
        <translation>遷移の取り得る道</translation>
    </message>
    <message>
        <source>A click, or Return, takes another way</source>
        <translation>クリックかReturnで別の道を選びます</translation>
    </message>
    <message>
        <source>Choose a block, or the transition before it.</source>
        <translation>ブロックか、その前の遷移を選んでください。</translation>
    </message>
    <message>
        <source>The first block begins where it was recorded.</source>
        <translation>最初のブロックは収録された場所から始まります。</translation>
    </message>
    <message>
        <source>There is no transition.</source>
        <translation>遷移はありません。</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>モーションを作成中です。</translation>
    </message>
    <message>
        <source>straight from pose to pose</source>
        <translation>ポーズからポーズへ直線で</translation>
    </message>
    <message>
        <source>on a curve</source>
        <translation>曲線で</translation>
    </message>
    <message>
        <source>along recorded clips past %1 poses</source>
        <translation>収録クリップに沿い、%1個のポーズを経由</translation>
    </message>
    <message>
        <source>between poses that are alike</source>
        <translation>似たポーズの間で</translation>
    </message>
    <message>
        <source>To %1: %2 s, %3%4</source>
        <translation>%1へ: %2 s、%3%4</translation>
    </message>
    <message>
        <source>. Locked.</source>
        <translation>。ロック中。</translation>
    </message>
    <message>
        <source>drawn by cost</source>
        <translation>コストによる抽選</translation>
    </message>
    <message>
        <source>path %1 · they meet as they are</source>
        <translation>経路%1 · そのままつながります</translation>
    </message>
    <message>
        <source>path %1 · cost %2 · clips: %3</source>
        <translation>経路%1 · コスト%2 · クリップ: %3</translation>
    </message>
    <message>
        <source>curve (Bézier)</source>
        <translation>曲線 (ベジェ)</translation>
    </message>
    <message>
        <source>straight, for comparison</source>
        <translation>直線、比較用</translation>
    </message>
    <message>
        <source>Take another transition</source>
        <translation>別の遷移を選ぶ</translation>
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
        <translation>フレーム%1</translation>
    </message>
    <message>
        <source>Playback speed: - slower, + faster</source>
        <translation>再生速度: -で遅く、+で速く</translation>
    </message>
    <message>
        <source>Rows ▾</source>
        <translation>行 ▾</translation>
    </message>
    <message>
        <source>Rows of the timeline</source>
        <translation>タイムラインの行</translation>
    </message>
    <message>
        <source>What the timeline shows: curves, speeds, units of the ruler</source>
        <translation>タイムラインの表示内容: 曲線、速さ、ルーラーの単位</translation>
    </message>
    <message>
        <source>selected: boundary of %1 at %2</source>
        <translation>選択: %1の境界、%2</translation>
    </message>
    <message>
        <source>selected: action of %1, %2 to %3</source>
        <translation>選択: %1の動作、%2～%3</translation>
    </message>
    <message>
        <source>active: %1</source>
        <translation>アクティブ: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::UnmatchedBox</name>
    <message>
        <source>Put boundary</source>
        <translation>境界を置く</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>忘れる</translation>
    </message>
    <message>
        <source>Corrections without a minimum</source>
        <translation>極小のない修正</translation>
    </message>
    <message>
        <source>With the present settings these corrections mean nothing any more.</source>
        <translation>今の設定では、これらの修正はもう意味がありません。</translation>
    </message>
    <message>
        <source>Put a boundary by hand where the correction had one</source>
        <translation>修正があった位置に手動で境界を置きます</translation>
    </message>
    <message>
        <source>Drop the correction from the project</source>
        <translation>修正をプロジェクトから破棄します</translation>
    </message>
</context>
<context>
    <name>kumite::studio::VersionsDialog</name>
    <message>
        <source>Restore</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>コピーを開く</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>バージョン</translation>
    </message>
    <message>
        <source>Versions, the newest first</source>
        <translation>バージョン、新しい順</translation>
    </message>
    <message>
        <source>States that were saved over; a double-click restores one</source>
        <translation>上書きされた状態。ダブルクリックで復元します</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>保存日時</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>テイク</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>修正</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Open the chosen version as a project without a file</source>
        <translation>選んだバージョンを、ファイルのないプロジェクトとして開きます</translation>
    </message>
    <message>
        <source>Make the chosen version the open project; undo takes it back (Enter)</source>
        <translation>選んだバージョンを開いているプロジェクトにします。元に戻せます (Enter)</translation>
    </message>
    <message>
        <source>Leave everything as it is (Esc)</source>
        <translation>すべてそのままにします (Esc)</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>調べています…</translation>
    </message>
    <message>
        <source>Reading versions</source>
        <translation>バージョンを読み込み中</translation>
    </message>
    <message>
        <source>No earlier version yet. Every save keeps what the file held before; the last ten are listed here.</source>
        <translation>以前のバージョンはまだありません。保存するたびにファイルの直前の内容を残し、最新の10件をここに並べます。</translation>
    </message>
    <message>
        <source>What the project file held before each of the last saves. Restoring is an edit: undo takes it back, and the file changes only when you save.</source>
        <translation>最近の各保存の直前にプロジェクトファイルにあった内容です。復元は編集の1つで、元に戻せます。ファイルは保存したときだけ変わります。</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>読み込めません</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WelcomePage</name>
    <message>
        <source>Cut a recorded bout into actions: both fighters in 3D over the force that they exert against the ground. Its minima are the boundaries; you correct the few that are wrong. Then say what a few actions are, and the machine says it of the rest.</source>
        <translation>収録した試合を動作に分割します。両選手を3Dで、地面に加える力の上に表示します。力の極小が境界です。誤った少数を直してください。その後いくつかの動作が何かを示すと、残りは機械が答えます。</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>始める</translation>
    </message>
    <message>
        <source>Or drop recordings (BVH, or AMC with its ASF) or a project on this window.</source>
        <translation>または、収録 (BVH、もしくはAMCとそのASF) かプロジェクトをこのウィンドウにドロップ。</translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation>最近開いたもの</translation>
    </message>
    <message>
        <source>Projects and recordings that you open appear here, with the day and the folder.</source>
        <translation>開いたプロジェクトと収録が、日付とフォルダーとともにここに表示されます。</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WelcomePicture</name>
    <message>
        <source>Two fighters over the curves of their contact force, which is cut into actions at its minima</source>
        <translation>接地力の曲線の上に立つ二人の選手。曲線は極小で動作に区切られています</translation>
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
        <translation>再生ヘッドの位置</translation>
    </message>
    <message>
        <source>Both labels are those of the moment that is shown</source>
        <translation>両方のラベルを表示中の瞬間のものにします</translation>
    </message>
    <message>
        <source>own</source>
        <translation>自分</translation>
    </message>
    <message>
        <source>What the fighter does now</source>
        <translation>選手の今の動作</translation>
    </message>
    <message>
        <source>opponent</source>
        <translation>相手</translation>
    </message>
    <message>
        <source>What the opponent does now</source>
        <translation>相手の今の動作</translation>
    </message>
    <message>
        <source>What comes next</source>
        <translation>次に来るもの</translation>
    </message>
    <message>
        <source>What next?</source>
        <translation>次は?</translation>
    </message>
    <message>
        <source>What %1 may do next, the likeliest first</source>
        <translation>%1の次の動作の候補、有力な順</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>何でも</translation>
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
        <translation>ラベル %1</translation>
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
        <translation>%1: P %2、ラベル項%3</translation>
    </message>
    <message>
        <source>, geometry term %1</source>
        <translation>, 幾何項%1</translation>
    </message>
    <message>
        <source>
Seen %1 times with both labels, %2 with the own, %3 with the opponent&apos;s</source>
        <translation>
両方のラベルで%1回、自分のラベルで%2回、相手のラベルで%3回見られました</translation>
    </message>
    <message>
        <source>
This is what came next</source>
        <translation>
実際に次に来たものです</translation>
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
        <translation>プロミネンス%1</translation>
    </message>
    <message>
        <source>slow left kick, %1</source>
        <translation>左の遅い蹴り、%1</translation>
    </message>
    <message>
        <source>slow right kick, %1</source>
        <translation>右の遅い蹴り、%1</translation>
    </message>
    <message>
        <source>left foot moves at %1 m/s, %2</source>
        <translation>左足が%1 m/sで移動、%2</translation>
    </message>
    <message>
        <source>right foot moves at %1 m/s, %2</source>
        <translation>右足が%1 m/sで移動、%2</translation>
    </message>
    <message>
        <source>shallow, %1</source>
        <translation>浅い、%1</translation>
    </message>
    <message>
        <source>%1 s from the next minimum, %2</source>
        <translation>次の極小まで%1 s、%2</translation>
    </message>
    <message>
        <source>hardly dips (to %1), %2</source>
        <translation>ほとんど下がらない (%1まで)、%2</translation>
    </message>
    <message>
        <source>nothing unusual, %1</source>
        <translation>異常なし、%1</translation>
    </message>
    <message>
        <source>left kick</source>
        <translation>左蹴り</translation>
    </message>
    <message>
        <source>right kick</source>
        <translation>右蹴り</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>左足</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>右足</translation>
    </message>
    <message>
        <source>shallow</source>
        <translation>浅い</translation>
    </message>
    <message>
        <source>crowded</source>
        <translation>密集</translation>
    </message>
    <message>
        <source>hardly dips</source>
        <translation>下がりが小さい</translation>
    </message>
    <message>
        <source>%1, suspicion %2</source>
        <translation>%1、疑い%2</translation>
    </message>
    <message>
        <source>removal at %1</source>
        <translation>%1の削除</translation>
    </message>
    <message>
        <source>addition at %1</source>
        <translation>%1の追加</translation>
    </message>
    <message>
        <source>move from %1 to %2</source>
        <translation>%1から%2への移動</translation>
    </message>
    <message>
        <source>acceptance at %1</source>
        <translation>%1の承認</translation>
    </message>
    <message>
        <source>fighter %1</source>
        <translation>選手%1</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>今日 %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>昨日 %1</translation>
    </message>
    <message>
        <source>Computer %1, process %2, since %3.</source>
        <translation>コンピューター%1、プロセス%2、%3から。</translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s)</source>
        <translation>
            <numerusform>編集%n件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::WorkspaceBar</name>
    <message>
        <source>Workspaces</source>
        <translation>ワークスペース</translation>
    </message>
    <message>
        <source>%1 workspace</source>
        <translation>%1ワークスペース</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Workspaces</name>
    <message>
        <source>%1 workspace</source>
        <translation>%1ワークスペース</translation>
    </message>
</context>
</TS>
