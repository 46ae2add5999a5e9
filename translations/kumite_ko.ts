<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
<context>
    <name>Core</name>
    <message>
        <source>Open</source>
        <translation>열기</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>복구</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>레이블 가져오기</translation>
    </message>
    <message>
        <source>Take over labels of %1</source>
        <translation>%1의 레이블 가져오기</translation>
    </message>
    <message>
        <source>Remove boundary %1</source>
        <translation>경계 제거: %1</translation>
    </message>
    <message>
        <source>Restore boundary %1</source>
        <translation>경계 복원: %1</translation>
    </message>
    <message>
        <source>Add boundary %1</source>
        <translation>경계 추가: %1</translation>
    </message>
    <message>
        <source>Move boundary %1</source>
        <translation>경계 이동: %1</translation>
    </message>
    <message>
        <source>Accept boundary %1</source>
        <translation>경계 수락: %1</translation>
    </message>
    <message>
        <source>Change segmentation settings</source>
        <translation>분할 설정 변경</translation>
    </message>
    <message>
        <source>Change body model to %1</source>
        <translation>신체 모델을 %1(으)로 변경</translation>
    </message>
    <message>
        <source>Restore the version of %1</source>
        <translation>%1 버전 복원</translation>
    </message>
    <message>
        <source>Add clips</source>
        <translation>클립 추가</translation>
    </message>
    <message>
        <source>Remove clips</source>
        <translation>클립 제거</translation>
    </message>
    <message>
        <source>Add take %1</source>
        <translation>테이크 %1 추가</translation>
    </message>
    <message>
        <source>Remove take %1</source>
        <translation>테이크 %1 제거</translation>
    </message>
    <message>
        <source>Rename take to %1</source>
        <translation>테이크 이름을 %1(으)로 변경</translation>
    </message>
    <message>
        <source>Move take %1 to place %2</source>
        <translation>테이크 %1을(를) %2번 자리로 이동</translation>
    </message>
    <message>
        <source>Swap fighters</source>
        <translation>선수 맞바꾸기</translation>
    </message>
    <message>
        <source>Change time offset, fighter %1</source>
        <translation>시간 오프셋 변경, 선수 %1</translation>
    </message>
    <message>
        <source>Change floor, fighter %1</source>
        <translation>바닥 변경, 선수 %1</translation>
    </message>
    <message>
        <source>Change role %1, fighter %2</source>
        <translation>%1 역할 변경, 선수 %2</translation>
    </message>
    <message>
        <source>Relink recording, fighter %1</source>
        <translation>녹화 다시 연결, 선수 %1</translation>
    </message>
    <message>
        <source>Keep bout as take %1</source>
        <translation>대련을 테이크 %1(으)로 보관</translation>
    </message>
    <message>
        <source>Keep motion as take %1</source>
        <translation>모션을 테이크 %1(으)로 보관</translation>
    </message>
    <message>
        <source>Label action %1, fighter %2: %3</source>
        <translation>동작 %1 레이블, 선수 %2: %3</translation>
    </message>
    <message>
        <source>Label action %1, fighter %2</source>
        <translation>동작 %1 레이블, 선수 %2</translation>
    </message>
    <message>
        <source>Label %1 actions, fighter %2: %3</source>
        <translation>동작 %1개 레이블, 선수 %2: %3</translation>
    </message>
    <message>
        <source>Label %1 actions, fighter %2</source>
        <translation>동작 %1개 레이블, 선수 %2</translation>
    </message>
    <message>
        <source>Label %1 actions: %2</source>
        <translation>동작 %1개 레이블: %2</translation>
    </message>
    <message>
        <source>Label %1 actions</source>
        <translation>동작 %1개 레이블</translation>
    </message>
    <message>
        <source>Clear label, action %1, fighter %2</source>
        <translation>레이블 지우기, 동작 %1, 선수 %2</translation>
    </message>
    <message>
        <source>Clear label, %1 actions, fighter %2</source>
        <translation>레이블 지우기, 동작 %1개, 선수 %2</translation>
    </message>
    <message>
        <source>Accept labels</source>
        <translation>레이블 수락</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>레이블 불러오기</translation>
    </message>
    <message>
        <source>Merge labels</source>
        <translation>레이블 병합</translation>
    </message>
    <message>
        <source>Change vocabulary to %1</source>
        <translation>어휘를 %1(으)로 변경</translation>
    </message>
    <message>
        <source>Change rules</source>
        <translation>규칙 변경</translation>
    </message>
    <message>
        <source>Change learning settings</source>
        <translation>학습 설정 변경</translation>
    </message>
    <message>
        <source>Keep model</source>
        <translation>모델 보관</translation>
    </message>
    <message>
        <source>Remove note %1</source>
        <translation>메모 제거: %1</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>메모: %1</translation>
    </message>
    <message>
        <source>Accept what rules say</source>
        <translation>규칙의 제안 수락</translation>
    </message>
    <message>
        <source>Accept 1 label</source>
        <translation>레이블 1개 수락</translation>
    </message>
    <message>
        <source>Accept %1 labels</source>
        <translation>레이블 %1개 수락</translation>
    </message>
    <message>
        <source>at %1, fighter %2</source>
        <translation>%1, 선수 %2</translation>
    </message>
    <message>
        <source>A model of two fighters needs a take with two of them.</source>
        <translation>두 선수의 모델에는 두 명이 있는 테이크가 필요합니다.</translation>
    </message>
    <message>
        <source>No action is labelled yet: label some by hand and let the machine do the rest, or import labels.</source>
        <translation>레이블이 붙은 동작이 아직 없습니다. 몇 개를 수동으로 붙이고 나머지는 학습기에 맡기거나 레이블을 가져오세요.</translation>
    </message>
    <message>
        <source>No transition has the labels of all its three actions: label more of both fighters.</source>
        <translation>세 동작 모두에 레이블이 있는 전이가 없습니다. 두 선수에게 더 붙이세요.</translation>
    </message>
    <message>
        <source>cannot be read: %1.</source>
        <translation>읽을 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>cannot read: %1.</source>
        <translation>읽을 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>cannot write: %1.</source>
        <translation>쓸 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>cannot make this folder: %1.</source>
        <translation>이 폴더를 만들 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>is a folder, expected a file.</source>
        <translation>파일이어야 하는데 폴더입니다.</translation>
    </message>
    <message>
        <source>is no regular file; save it as one first.</source>
        <translation>일반 파일이 아닙니다. 먼저 파일로 저장하세요.</translation>
    </message>
    <message>
        <source>is a folder, expected a file to write.</source>
        <translation>쓸 파일이어야 하는데 폴더입니다.</translation>
    </message>
    <message>
        <source>is what is read here; write to another file.</source>
        <translation>지금 읽는 파일입니다. 다른 파일에 쓰세요.</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>그런 파일이 없습니다.</translation>
    </message>
    <message>
        <source>Every motion has too few frames for %1 key poses.</source>
        <translation>어느 모션도 키 포즈 %1개를 담을 만큼 프레임이 많지 않습니다.</translation>
    </message>
    <message>
        <source>There is no frame of %1 to write.</source>
        <translation>%1에 내보낼 프레임이 없습니다.</translation>
    </message>
    <message>
        <source>The file holds %1 skeletons: %2. The first is read unless --root names another.</source>
        <translation>파일에 골격이 %1개 있습니다: %2. --root로 다른 것을 지정하지 않으면 첫 번째를 읽습니다.</translation>
    </message>
    <message>
        <source>found several skeletons beside it (%1), expected one (name it with --asf)</source>
        <translation>옆에 골격이 하나만 있어야 하는데 여럿 있습니다(%1). --asf로 지정하세요</translation>
    </message>
    <message>
        <source>found %1, expected %2</source>
        <translation>%2이(가) 와야 하는데 %1이(가) 나왔습니다</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>파일의 끝</translation>
    </message>
    <message>
        <source>only the %1 channels that CHANNELS announces</source>
        <translation>CHANNELS에 적힌 개수(%1개)까지의 채널</translation>
    </message>
    <message>
        <source>A split by takes needs two takes or more with labelled transitions.</source>
        <translation>테이크별로 나누려면 레이블이 붙은 전이가 있는 테이크가 둘 이상 필요합니다.</translation>
    </message>
    <message>
        <source>There are too few labelled transitions to set some apart.</source>
        <translation>일부를 따로 떼어 두기에는 레이블이 붙은 전이가 너무 적습니다.</translation>
    </message>
    <message>
        <source>For labelling, these joints take their parents&apos; place: %1.</source>
        <translation>레이블을 붙일 때 다음 관절은 부모 관절로 대신합니다: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no aspect of the vocabulary %2.</source>
        <translation>“%1”은(는) 어휘 %2의 측면이 아닙니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no qualifier of %2.</source>
        <translation>“%1”은(는) %2의 수식어가 아닙니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names an aspect twice.</source>
        <translation>“%1”에 같은 측면이 두 번 나옵니다.</translation>
    </message>
    <message>
        <source>After %1 a confidence is expected, such as 0.6 or 60 %.</source>
        <translation>%1 뒤에는 0.6이나 60 % 같은 확신도를 적어야 합니다.</translation>
    </message>
    <message>
        <source>After %1 a confidence is expected, such as 0.6 or 60 %, not %2.</source>
        <translation>%1 뒤에는 %2이(가) 아니라 0.6이나 60 % 같은 확신도를 적어야 합니다.</translation>
    </message>
    <message>
        <source>Say whether the confidence is &quot;below %1&quot; or &quot;above %1&quot;.</source>
        <translation>확신도가 “below %1”인지 “above %1”인지 적으세요.</translation>
    </message>
    <message>
        <source>After %1 a time is expected, such as %2.</source>
        <translation>%1 뒤에는 %2 같은 시간을 적어야 합니다.</translation>
    </message>
    <message>
        <source>After %1 a time is expected, such as %2, not %3.</source>
        <translation>%1 뒤에는 %3이(가) 아니라 %2 같은 시간을 적어야 합니다.</translation>
    </message>
    <message>
        <source>After %1 two times are expected, such as 0:30 to 1:00.</source>
        <translation>%1 뒤에는 0:30 to 1:00처럼 두 시간을 적어야 합니다.</translation>
    </message>
    <message>
        <source>After %1 1 or 2 is expected.</source>
        <translation>%1 뒤에는 1이나 2를 적어야 합니다.</translation>
    </message>
    <message>
        <source>After %1 1 or 2 is expected, not %2.</source>
        <translation>%1 뒤에는 %2이(가) 아니라 1이나 2를 적어야 합니다.</translation>
    </message>
    <message>
        <source>There is no take %1; the takes are %2.</source>
        <translation>테이크 %1이(가) 없습니다. 있는 테이크: %2.</translation>
    </message>
    <message>
        <source>Say which take; the takes are %1.</source>
        <translation>어느 테이크인지 적으세요. 있는 테이크: %1.</translation>
    </message>
    <message>
        <source>No aspect has a &quot;strike&quot;: %1 will never find anything to react to.</source>
        <translation>“strike”가 있는 측면이 없어 %1이(가) 반응할 대상을 찾을 수 없습니다.</translation>
    </message>
    <message>
        <source>The key %1 stands for both %2 and %3.</source>
        <translation>단축키 %1이(가) %2과(와) %3에 함께 지정되어 있습니다.</translation>
    </message>
    <message>
        <source>In %1 the key %2 stands for both %3 and %4.</source>
        <translation>%1에서 단축키 %2이(가) %3과(와) %4에 함께 지정되어 있습니다.</translation>
    </message>
    <message>
        <source>The target has no %1: their turns go to the joints below them.</source>
        <translation>대상 골격에 없는 관절: %1. 그 회전은 하위 관절에 넘깁니다.</translation>
    </message>
    <message>
        <source>The source has no %1: they keep their rest relative to their parent.</source>
        <translation>원본 골격에 없는 관절: %1. 부모에 대한 레스트 포즈를 유지합니다.</translation>
    </message>
    <message>
        <source>No joint was found for: %1.</source>
        <translation>다음 역할의 관절을 찾지 못했습니다: %1.</translation>
    </message>
    <message>
        <source>Joint %1 does not stand behind its parent.</source>
        <translation>관절 %1이(가) 부모보다 뒤에 있지 않습니다.</translation>
    </message>
    <message>
        <source>The channels of joint %1 do not follow the ones before.</source>
        <translation>관절 %1의 채널이 앞의 채널에 이어지지 않습니다.</translation>
    </message>
    <message>
        <source>The End Site %1 has channels.</source>
        <translation>End Site %1에 채널이 있습니다.</translation>
    </message>
    <message>
        <source>The offset of joint %1 is not a finite number.</source>
        <translation>관절 %1의 오프셋이 유한한 수가 아닙니다.</translation>
    </message>
    <message>
        <source>Frame 0 is a rest pose, not motion; takes leave it out.</source>
        <translation>프레임 0은 모션이 아니라 레스트 포즈입니다. 테이크에서 뺍니다.</translation>
    </message>
    <message>
        <source>Frames 0 to %1 are a rest pose, not motion; takes leave them out.</source>
        <translation>프레임 0~%1은(는) 모션이 아니라 레스트 포즈입니다. 테이크에서 뺍니다.</translation>
    </message>
    <message>
        <source>Fighter %1 has no boundary near frame %2.</source>
        <translation>선수 %1의 프레임 %2 근처에 경계가 없습니다.</translation>
    </message>
    <message>
        <source>Fighter %1 has no boundary near frame %2; the nearest is at %3.</source>
        <translation>선수 %1의 프레임 %2 근처에 경계가 없습니다. 가장 가까운 것은 %3에 있습니다.</translation>
    </message>
    <message>
        <source>the recording is missing; its boundaries cannot be edited.</source>
        <translation>녹화가 없어 경계를 편집할 수 없습니다.</translation>
    </message>
    <message>
        <source>A time offset must be a number.</source>
        <translation>시간 오프셋은 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>A placement must be a number.</source>
        <translation>위치는 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>The floor&apos;s height must be a number.</source>
        <translation>바닥 높이는 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>There is a take named &quot;%1&quot; already.</source>
        <translation>“%1”(이)라는 테이크가 이미 있습니다.</translation>
    </message>
    <message>
        <source>%1 has another skeleton: it is not the recording that is missing.</source>
        <translation>%1의 골격이 다릅니다. 없어진 녹화가 아닙니다.</translation>
    </message>
    <message>
        <source>the suffix says what to write, expected .bvh, .glb, .npz, .csv, .json or .eaf.</source>
        <translation>확장자가 쓸 형식을 정합니다. .bvh, .glb, .npz, .csv, .json, .eaf 중 하나여야 합니다.</translation>
    </message>
    <message>
        <source>the recording is missing; the take cannot be written without it.</source>
        <translation>녹화가 없어 테이크를 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>a graph is written as .csv, .json or .graphml.</source>
        <translation>그래프는 .csv, .json 또는 .graphml로 씁니다.</translation>
    </message>
    <message>
        <source>there is no joint named &quot;%1&quot;; there is: %2.</source>
        <translation>“%1”(이)라는 관절이 없습니다. 있는 관절: %2.</translation>
    </message>
    <message>
        <source>the name holds bytes that are no UTF-8 text; rename the file or folder.</source>
        <translation>이름에 UTF-8이 아닌 바이트가 있습니다. 파일이나 폴더의 이름을 바꾸세요.</translation>
    </message>
    <message>
        <source>the key pose of clip &quot;%1&quot; is not in the project</source>
        <translation>클립 “%1”의 키 포즈가 프로젝트에 없습니다</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no source.</source>
        <translation>“%1”(이)라는 출처는 없습니다.</translation>
    </message>
    <message>
        <source>labels are written as .csv, .json or .eaf.</source>
        <translation>레이블은 .csv, .json 또는 .eaf로 씁니다.</translation>
    </message>
    <message>
        <source>labels are read from .csv, .json and .eaf files.</source>
        <translation>레이블은 .csv, .json, .eaf 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>the project has no take &quot;%1&quot;.</source>
        <translation>프로젝트에 테이크 “%1”이(가) 없습니다.</translation>
    </message>
    <message>
        <source>the take has no such fighter.</source>
        <translation>테이크에 그런 선수가 없습니다.</translation>
    </message>
    <message>
        <source>no action there.</source>
        <translation>그곳에 동작이 없습니다.</translation>
    </message>
    <message>
        <source>its action takes the label of %1.</source>
        <translation>그 동작에는 %1의 레이블이 붙습니다.</translation>
    </message>
    <message>
        <source>no joint has the role pelvis, so its actions cannot be compared.</source>
        <translation>골반 역할의 관절이 없어 동작을 비교할 수 없습니다.</translation>
    </message>
    <message>
        <source>the recording is missing; its actions cannot be labelled.</source>
        <translation>녹화가 없어 동작에 레이블을 붙일 수 없습니다.</translation>
    </message>
    <message>
        <source>has no body with two legs; it is left out.</source>
        <translation>두 다리가 있는 몸이 없어 제외합니다.</translation>
    </message>
    <message>
        <source>%1 It is left out.</source>
        <translation>%1 제외합니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: expected frames as A:B after the @.</source>
        <translation>“%1”: @ 뒤에 프레임을 A:B로 적어야 합니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: these frames are not in it; it has %2 to %3.</source>
        <translation>“%1”: 이 프레임은 없습니다. 있는 프레임은 %2~%3입니다.</translation>
    </message>
    <message>
        <source>No action of the library is labelled &quot;%1&quot;.</source>
        <translation>라이브러리에 레이블이 “%1”인 동작이 없습니다.</translation>
    </message>
    <message>
        <source>No action of the library is labelled &quot;%1&quot; of that player.</source>
        <translation>라이브러리에 레이블이 “%1”인 그 선수의 동작이 없습니다.</translation>
    </message>
    <message>
        <source>None of these clips is of that player.</source>
        <translation>이 가운데 그 선수의 클립이 없습니다.</translation>
    </message>
    <message>
        <source>joint &quot;%1&quot; is gone; the role %2 has no joint now.</source>
        <translation>관절 “%1”이(가) 없어져 이제 %2 역할에 관절이 없습니다.</translation>
    </message>
    <message>
        <source>%1 The recording is left out; its corrections are kept.</source>
        <translation>%1 이 녹화를 제외합니다. 수정은 남겨 둡니다.</translation>
    </message>
    <message>
        <source>the recording is missing; put it back or relink it. Its corrections are kept.</source>
        <translation>녹화가 없습니다. 제자리에 돌려놓거나 다시 연결하세요. 수정은 남겨 둡니다.</translation>
    </message>
    <message>
        <source>the recording has changed since it became part of the project; check the boundaries, then relink it to accept the change.</source>
        <translation>프로젝트에 넣은 뒤 녹화가 바뀌었습니다. 경계를 확인한 다음 다시 연결하면 변경을 받아들입니다.</translation>
    </message>
    <message>
        <source>the recording is missing; the take cannot be shown without it.</source>
        <translation>녹화가 없어 테이크를 표시할 수 없습니다.</translation>
    </message>
    <message>
        <source>There is no take named &quot;%1&quot;; the project has none.</source>
        <translation>“%1”(이)라는 테이크가 없습니다. 프로젝트에 테이크가 하나도 없습니다.</translation>
    </message>
    <message>
        <source>There is no take named &quot;%1&quot;; there is: %2.</source>
        <translation>“%1”(이)라는 테이크가 없습니다. 있는 테이크: %2.</translation>
    </message>
    <message>
        <source>no contact force without a body; no joint has the role %1.</source>
        <translation>몸이 없으면 접촉력도 없습니다. %1 역할의 관절이 없습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; of fighter %2 is no correction without a minimum.</source>
        <translation>선수 %2의 “%1”은(는) 극소점이 없는 수정이 아닙니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; leaves no boundary that could be added.</source>
        <translation>“%1”에는 추가할 수 있는 경계가 없습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be reached: the nearest target that can is %2.</source>
        <translation>“%1”에 닿을 수 없습니다. 닿을 수 있는 가장 가까운 표적은 %2입니다.</translation>
    </message>
    <message>
        <source>What was saved before could not be kept. %1</source>
        <translation>이전에 저장한 내용을 보관하지 못했습니다. %1</translation>
    </message>
    <message>
        <source>holds %1 frames only; the take ends there for this fighter.</source>
        <translation>프레임이 %1개뿐입니다. 이 선수의 테이크는 거기서 끝납니다.</translation>
    </message>
    <message>
        <source>holds %1 frames now, the take begins at frame %2; the recording is left out.</source>
        <translation>이제 프레임이 %1개인데 테이크는 프레임 %2에서 시작합니다. 이 녹화를 제외합니다.</translation>
    </message>
    <message>
        <source>holds %1 frames now; the take ends there.</source>
        <translation>이제 프레임이 %1개입니다. 테이크는 거기서 끝납니다.</translation>
    </message>
    <message>
        <source>a cutoff of %1 Hz smooths nothing at %2 frames a second; choose one below %3 Hz.</source>
        <translation>초당 프레임이 %2개일 때 차단 주파수 %1 Hz로는 아무것도 평활화되지 않습니다. %3 Hz보다 낮은 값을 고르세요.</translation>
    </message>
    <message>
        <source>the annotation &quot;%1&quot; has no time and is left out.</source>
        <translation>주석 “%1”에 시간이 없어 제외합니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no action that can be asked for; there are %2, what they strike with, and ASPECT:QUALIFIER.</source>
        <translation>“%1”은(는) 요청할 수 있는 동작이 아닙니다. %2, 그 타격의 종류, ASPECT:QUALIFIER 가운데 하나를 쓰세요.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing.</source>
        <translation>“%1”이(가) 없습니다.</translation>
    </message>
    <message>
        <source>expected a list.</source>
        <translation>목록이어야 합니다.</translation>
    </message>
    <message>
        <source>expected an object.</source>
        <translation>객체여야 합니다.</translation>
    </message>
    <message>
        <source>expected a whole number.</source>
        <translation>정수여야 합니다.</translation>
    </message>
    <message>
        <source>expected a number.</source>
        <translation>숫자여야 합니다.</translation>
    </message>
    <message>
        <source>expected a finite number.</source>
        <translation>유한한 수여야 합니다.</translation>
    </message>
    <message>
        <source>expected a number above 0.</source>
        <translation>0보다 큰 수여야 합니다.</translation>
    </message>
    <message>
        <source>expected true or false.</source>
        <translation>true 또는 false여야 합니다.</translation>
    </message>
    <message>
        <source>expected text.</source>
        <translation>텍스트여야 합니다.</translation>
    </message>
    <message>
        <source>expected 0 or more.</source>
        <translation>0 이상이어야 합니다.</translation>
    </message>
    <message>
        <source>expected [begin, end] with 0 &lt;= begin &lt; end.</source>
        <translation>0 &lt;= begin &lt; end인 [begin, end]여야 합니다.</translation>
    </message>
    <message>
        <source>expected an object with &quot;key_poses&quot;: 1, &quot;rate&quot; and &quot;keys&quot;.</source>
        <translation>&quot;key_poses&quot;: 1, &quot;rate&quot;, &quot;keys&quot;가 있는 객체여야 합니다.</translation>
    </message>
    <message>
        <source>expected a colour like #3a86d8.</source>
        <translation>#3a86d8 같은 색이어야 합니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no joint role.</source>
        <translation>“%1”은(는) 관절 역할이 아닙니다.</translation>
    </message>
    <message>
        <source>is no joint role.</source>
        <translation>관절 역할이 아닙니다.</translation>
    </message>
    <message>
        <source>is no vocabulary: it has no &quot;vocabulary&quot; version.</source>
        <translation>어휘가 아닙니다. “vocabulary” 버전이 없습니다.</translation>
    </message>
    <message>
        <source>is the id of two qualifiers.</source>
        <translation>두 수식어의 id가 같습니다.</translation>
    </message>
    <message>
        <source>is the id of two aspects.</source>
        <translation>두 측면의 id가 같습니다.</translation>
    </message>
    <message>
        <source>is the name of two takes.</source>
        <translation>두 테이크의 이름이 같습니다.</translation>
    </message>
    <message>
        <source>a take has one or two fighters.</source>
        <translation>테이크의 선수는 한 명 또는 두 명입니다.</translation>
    </message>
    <message>
        <source>a vocabulary has one aspect or more.</source>
        <translation>어휘에는 측면이 하나 이상 있어야 합니다.</translation>
    </message>
    <message>
        <source>an aspect has two qualifiers or more.</source>
        <translation>측면에는 수식어가 둘 이상 있어야 합니다.</translation>
    </message>
    <message>
        <source>is none of the qualifiers.</source>
        <translation>수식어 중에 그런 것이 없습니다.</translation>
    </message>
    <message>
        <source>there is no aspect &quot;%1&quot;.</source>
        <translation>측면 “%1”이(가) 없습니다.</translation>
    </message>
    <message>
        <source>The system&apos;s OpenSSL library cannot compute SHA-256.</source>
        <translation>시스템의 OpenSSL 라이브러리로 SHA-256을 계산할 수 없습니다.</translation>
    </message>
    <message>
        <source>A demo bout lasts from 1 second to 24 hours; %1 seconds were asked for.</source>
        <translation>데모 대련의 길이는 1초에서 24시간까지입니다. 요청한 길이는 %1초입니다.</translation>
    </message>
    <message>
        <source>A demo bout has 24 to 240 frames a second; %1 were asked for.</source>
        <translation>데모 대련의 프레임 속도는 초당 24~240프레임입니다. 요청한 속도는 %1입니다.</translation>
    </message>
    <message>
        <source>There is no key pose to make a motion of.</source>
        <translation>모션을 만들 키 포즈가 없습니다.</translation>
    </message>
    <message>
        <source>The library holds no motion.</source>
        <translation>라이브러리에 모션이 없습니다.</translation>
    </message>
    <message>
        <source>There is no key at frame %1.</source>
        <translation>프레임 %1에 키가 없습니다.</translation>
    </message>
    <message>
        <source>Frame %1 is not behind the key before.</source>
        <translation>프레임 %1이(가) 이전 키보다 뒤에 있지 않습니다.</translation>
    </message>
    <message>
        <source>Keys can be brought nearer or farther by a factor above 0 only.</source>
        <translation>키 사이의 간격은 0보다 큰 배율로만 바꿀 수 있습니다.</translation>
    </message>
    <message>
        <source>Keys cannot be brought that far.</source>
        <translation>키를 그렇게 멀리 옮길 수 없습니다.</translation>
    </message>
    <message>
        <source>Key poses need a skeleton.</source>
        <translation>키 포즈에는 골격이 필요합니다.</translation>
    </message>
    <message>
        <source>Key poses need a rate above 0.</source>
        <translation>키 포즈의 프레임 속도는 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>The key at frame %1 is a pose of another skeleton.</source>
        <translation>프레임 %1의 키는 다른 골격의 포즈입니다.</translation>
    </message>
    <message>
        <source>The key at frame %1 comes after one at frame %2.</source>
        <translation>프레임 %1의 키가 프레임 %2의 키 다음에 옵니다.</translation>
    </message>
    <message>
        <source>Frames %1:%2 are not in the take, which has %3.</source>
        <translation>프레임 %1:%2은(는) 테이크에 없습니다. 테이크의 프레임은 %3개입니다.</translation>
    </message>
    <message>
        <source>The part comes from another skeleton.</source>
        <translation>부위가 다른 골격에서 온 것입니다.</translation>
    </message>
    <message>
        <source>Frames %1 to %2 are not in the source, which has %3.</source>
        <translation>프레임 %1~%2은(는) 출처에 없습니다. 출처의 프레임은 %3개입니다.</translation>
    </message>
    <message>
        <source>There is no key pose to look for.</source>
        <translation>찾을 키 포즈가 없습니다.</translation>
    </message>
    <message>
        <source>At most 1000 key poses can be looked for.</source>
        <translation>키 포즈는 한 번에 1000개까지 찾을 수 있습니다.</translation>
    </message>
    <message>
        <source>Every key pose needs its features and its frame.</source>
        <translation>모든 키 포즈에는 특징과 프레임이 필요합니다.</translation>
    </message>
    <message>
        <source>Key poses must stand in the order of their frames, one per frame.</source>
        <translation>키 포즈는 프레임 순서대로, 프레임마다 하나씩 있어야 합니다.</translation>
    </message>
    <message>
        <source>Two examples of the strike cannot be aligned in time.</source>
        <translation>타격의 두 예를 시간에 맞춰 정렬할 수 없습니다.</translation>
    </message>
    <message>
        <source>There is no example of the strike to blend.</source>
        <translation>혼합할 타격의 예가 없습니다.</translation>
    </message>
    <message>
        <source>The skeleton has no %1: its roles tell nothing that could hit.</source>
        <translation>골격에 %1이(가) 없습니다. 역할에서 타격할 부위를 찾을 수 없습니다.</translation>
    </message>
    <message>
        <source>Strike &quot;%1&quot; is of another skeleton.</source>
        <translation>타격 “%1”의 골격이 다릅니다.</translation>
    </message>
    <message>
        <source>Feature poses must come in pairs, one of the query and one of the clip.</source>
        <translation>특징 포즈는 질의와 클립에서 하나씩, 쌍으로 있어야 합니다.</translation>
    </message>
    <message>
        <source>Feature poses must follow each other in time.</source>
        <translation>특징 포즈는 시간 순서여야 합니다.</translation>
    </message>
    <message>
        <source>An AMC file does not say its frame rate: 120 Hz is assumed; give another with --rate.</source>
        <translation>AMC 파일에는 프레임 속도가 없어 120 Hz로 봅니다. --rate로 다른 값을 지정할 수 있습니다.</translation>
    </message>
    <message>
        <source>Frame %1, the last, is cut: it is dropped.</source>
        <translation>마지막 프레임 %1이(가) 잘려 있어 버립니다.</translation>
    </message>
    <message>
        <source>Frame %1 does not follow the one before it by number: the frames are taken one after the other.</source>
        <translation>프레임 %1의 번호가 앞 프레임에 이어지지 않습니다. 프레임을 나온 순서대로 읽습니다.</translation>
    </message>
    <message>
        <source>found %1 numbers, expected %2 for bone %3 in frame %4</source>
        <translation>프레임 %4의 뼈 %3에 숫자가 %2개 와야 하는데 %1개 나왔습니다</translation>
    </message>
    <message>
        <source>found no line for bone %1 in frame %2, expected one for each bone with a dof</source>
        <translation>dof가 있는 뼈마다 한 줄이 있어야 하는데 프레임 %2에 뼈 %1의 줄이 없습니다</translation>
    </message>
    <message>
        <source>found %1, expected a unit of length greater than zero</source>
        <translation>길이 단위는 0보다 커야 하는데 %1입니다</translation>
    </message>
    <message>
        <source>found a bone without name, expected one</source>
        <translation>이름이 있어야 하는데 이름 없는 뼈가 나왔습니다</translation>
    </message>
    <message>
        <source>found a second bone %1, expected one</source>
        <translation>뼈 %1이(가) 하나만 있어야 하는데 또 나왔습니다</translation>
    </message>
    <message>
        <source>found bone %1 a second time, expected one parent for each</source>
        <translation>뼈마다 부모가 하나여야 하는데 뼈 %1이(가) 두 번 나왔습니다</translation>
    </message>
    <message>
        <source>found bone %1 that does not hang on the root, expected it in :hierarchy</source>
        <translation>뼈 %1이(가) :hierarchy에 있어야 하는데 루트에 이어져 있지 않습니다</translation>
    </message>
    <message>
        <source>found a skeleton without any dof, expected an order for the root</source>
        <translation>루트에 order가 있어야 하는데 골격에 dof가 하나도 없습니다</translation>
    </message>
    <message>
        <source>Bone %1 changes its length: that is not used.</source>
        <translation>뼈 %1의 길이가 바뀌지만 쓰지 않습니다.</translation>
    </message>
    <message>
        <source>found more joints than a skeleton can have, expected %1 at most</source>
        <translation>골격의 관절은 최대 %1개인데 그보다 많습니다</translation>
    </message>
    <message>
        <source>%1 has no OFFSET: taken as 0 0 0.</source>
        <translation>%1에 OFFSET이 없어 0 0 0으로 봅니다.</translation>
    </message>
    <message>
        <source>%1 has channels or children: read as a joint.</source>
        <translation>%1에 채널이나 자식이 있어 관절로 읽습니다.</translation>
    </message>
    <message>
        <source>found a second %1, expected one in joint %2</source>
        <translation>관절 %2에는 %1이(가) 하나만 있어야 하는데 또 나왔습니다</translation>
    </message>
    <message>
        <source>found a skeleton without any channel, expected CHANNELS</source>
        <translation>CHANNELS가 있어야 하는데 골격에 채널이 하나도 없습니다</translation>
    </message>
    <message>
        <source>found %1 numbers after Frame Time, expected at least one frame of %2 numbers</source>
        <translation>Frame Time 뒤에 숫자 %2개로 된 프레임이 하나 이상 와야 하는데 숫자가 %1개 나왔습니다</translation>
    </message>
    <message>
        <source>found more frames than can be counted, expected fewer</source>
        <translation>셀 수 있는 것보다 프레임이 많습니다. 더 적어야 합니다</translation>
    </message>
    <message>
        <source>A .glb file cannot hold more than 4 GB: export a shorter range.</source>
        <translation>.glb 파일은 4 GB를 넘을 수 없습니다. 더 짧은 구간을 내보내세요.</translation>
    </message>
    <message>
        <source>There is no figure to write.</source>
        <translation>내보낼 골격이 없습니다.</translation>
    </message>
    <message>
        <source>A glTF skeleton cannot have more than 65 535 joints.</source>
        <translation>glTF 골격의 관절은 65,535개를 넘을 수 없습니다.</translation>
    </message>
    <message>
        <source>is not valid JSON here.</source>
        <translation>여기서부터 올바른 JSON이 아닙니다.</translation>
    </message>
    <message>
        <source>holds a number that is too large.</source>
        <translation>너무 큰 수가 있습니다.</translation>
    </message>
    <message>
        <source>A .npz file cannot hold more than 4 GB: export a shorter range.</source>
        <translation>.npz 파일은 4 GB를 넘을 수 없습니다. 더 짧은 구간을 내보내세요.</translation>
    </message>
    <message>
        <source>found no skeleton beside it, expected an .asf file (name it with --asf)</source>
        <translation>옆에 .asf 파일이 있어야 하는데 골격이 없습니다(--asf로 지정하세요)</translation>
    </message>
    <message>
        <source>found an ASF skeleton, which holds no motion, expected the .amc file that belongs to it.</source>
        <translation>모션이 없는 ASF 골격입니다. 딸린 .amc 파일을 고르세요.</translation>
    </message>
    <message>
        <source>The recording holds no skeleton.</source>
        <translation>녹화에 골격이 없습니다.</translation>
    </message>
    <message>
        <source>found UTF-16 text, expected plain text (save the file as UTF-8)</source>
        <translation>일반 텍스트여야 하는데 UTF-16 텍스트입니다(파일을 UTF-8로 저장하세요)</translation>
    </message>
    <message>
        <source>has a quote that is not closed.</source>
        <translation>닫히지 않은 따옴표가 있습니다.</translation>
    </message>
    <message>
        <source>No joint has the role pelvis: actions cannot be compared.</source>
        <translation>골반 역할의 관절이 없어 동작을 비교할 수 없습니다.</translation>
    </message>
    <message>
        <source>Nothing stands before &quot;or&quot;.</source>
        <translation>“or” 앞에 아무것도 없습니다.</translation>
    </message>
    <message>
        <source>Nothing stands after &quot;or&quot;.</source>
        <translation>“or” 뒤에 아무것도 없습니다.</translation>
    </message>
    <message>
        <source>Something is missing after &quot;not&quot;.</source>
        <translation>“not” 뒤에 빠진 것이 있습니다.</translation>
    </message>
    <message>
        <source>Points to be aligned must come in pairs.</source>
        <translation>정렬할 점은 쌍으로 있어야 합니다.</translation>
    </message>
    <message>
        <source>Points to be aligned need a weight above zero.</source>
        <translation>정렬할 점의 가중치는 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>A rate must be a positive number of frames a second.</source>
        <translation>프레임 속도는 초당 프레임 수를 나타내는 양수여야 합니다.</translation>
    </message>
    <message>
        <source>Foot locking needs a frame to show.</source>
        <translation>발 고정에는 표시할 프레임이 필요합니다.</translation>
    </message>
    <message>
        <source>Foot locking needs to know of every frame which feet stand.</source>
        <translation>발 고정에는 프레임마다 어느 발이 디디고 있는지가 필요합니다.</translation>
    </message>
    <message>
        <source>A clip without frames cannot be joined.</source>
        <translation>프레임이 없는 클립은 이을 수 없습니다.</translation>
    </message>
    <message>
        <source>Clips can be joined only at one rate and on one skeleton.</source>
        <translation>클립은 프레임 속도와 골격이 같아야 이을 수 있습니다.</translation>
    </message>
    <message>
        <source>A motion needs a skeleton.</source>
        <translation>모션에는 골격이 필요합니다.</translation>
    </message>
    <message>
        <source>A motion&apos;s frame time must be a positive number of seconds.</source>
        <translation>모션의 프레임 시간은 0보다 큰 초여야 합니다.</translation>
    </message>
    <message>
        <source>A motion&apos;s channel values do not fill its frames.</source>
        <translation>모션의 채널 값이 프레임을 채우지 못합니다.</translation>
    </message>
    <message>
        <source>A channel value is not a finite number.</source>
        <translation>채널 값이 유한한 수가 아닙니다.</translation>
    </message>
    <message>
        <source>A clip&apos;s rig does not have the joints of its motion.</source>
        <translation>클립의 릭에 모션의 관절이 없습니다.</translation>
    </message>
    <message>
        <source>A clip of %1 joints cannot be written with the %2 joints of another skeleton: retarget it first.</source>
        <translation>관절 %1개의 클립을 관절 %2개인 다른 골격으로 쓸 수 없습니다. 먼저 리타기팅하세요.</translation>
    </message>
    <message>
        <source>Ways are scaled by %1 for the legs&apos; lengths.</source>
        <translation>다리 길이에 맞춰 이동 거리를 %1배로 조정합니다.</translation>
    </message>
    <message>
        <source>%1 moves by up to %2 cm of its own, which is not kept: %3 carries the body.</source>
        <translation>%1 자체의 이동(최대 %2 cm)은 버립니다. 몸을 옮기는 것은 %3입니다.</translation>
    </message>
    <message>
        <source>The bone to %1 changes by up to %2 cm; its mean is kept.</source>
        <translation>%1까지의 뼈 길이가 최대 %2 cm 달라집니다. 평균을 씁니다.</translation>
    </message>
    <message>
        <source>No neck: the chest (%1) stands in for it.</source>
        <translation>목이 없습니다. 가슴(%1)이 대신합니다.</translation>
    </message>
    <message>
        <source>The joint names say nothing; the roles were read off the skeleton&apos;s shape. Check left and right.</source>
        <translation>관절 이름으로는 알 수 없어 골격의 모양에서 역할을 읽었습니다. 왼쪽과 오른쪽을 확인하세요.</translation>
    </message>
    <message>
        <source>This skeleton is not a human body that is known here: it is shown and measured, but the contact force needs joint roles. Name them by hand if it is one.</source>
        <translation>이 골격에서 알려진 인체를 찾지 못했습니다. 표시하고 측정할 수는 있지만 접촉력에는 관절 역할이 필요합니다. 인체라면 역할을 직접 지정하세요.</translation>
    </message>
    <message>
        <source>A skeleton needs at least one joint.</source>
        <translation>골격에는 관절이 하나 이상 필요합니다.</translation>
    </message>
    <message>
        <source>A skeleton&apos;s channel count does not add up.</source>
        <translation>골격의 채널 수가 맞지 않습니다.</translation>
    </message>
    <message>
        <source>The body lies along the x axis; y was taken for up. Say which axis is up.</source>
        <translation>몸이 x축을 따라 누워 있어 y를 위쪽으로 보았습니다. 어느 축이 위쪽인지 지정하세요.</translation>
    </message>
    <message>
        <source>Without legs the unit cannot be found; centimetres are assumed.</source>
        <translation>다리가 없어 단위를 찾을 수 없습니다. 센티미터로 봅니다.</translation>
    </message>
    <message>
        <source>The labels belong to another segmentation.</source>
        <translation>다른 분할의 레이블입니다.</translation>
    </message>
    <message>
        <source>The differences belong to another segmentation or vocabulary.</source>
        <translation>다른 분할이나 어휘의 차이입니다.</translation>
    </message>
    <message>
        <source>Fighter %1 has no removed boundary near frame %2.</source>
        <translation>선수 %1의 프레임 %2 근처에 제거한 경계가 없습니다.</translation>
    </message>
    <message>
        <source>Fighter %1 has another boundary at frame %2; move that one first.</source>
        <translation>선수 %1의 프레임 %2에 다른 경계가 있습니다. 그것을 먼저 옮기세요.</translation>
    </message>
    <message>
        <source>Frame %1 is not inside the take, whose last frame is %2: a boundary cannot stand there.</source>
        <translation>프레임 %1은(는) 테이크 안에 있지 않습니다. 마지막 프레임은 %2입니다. 그곳에는 경계를 둘 수 없습니다.</translation>
    </message>
    <message>
        <source>The boundary can move between its neighbours only: frames %1 to %2.</source>
        <translation>경계는 이웃한 경계 사이에서만 옮길 수 있습니다: 프레임 %1~%2.</translation>
    </message>
    <message>
        <source>The boundary at frame %1 is an end of the take, which stays.</source>
        <translation>프레임 %1의 경계는 테이크의 끝이라 그대로 둡니다.</translation>
    </message>
    <message>
        <source>Take %1, player %2: its skeleton has other joints than that of the first take, so it is left out of bouts.</source>
        <translation>테이크 %1, 선수 %2: 골격의 관절이 첫 테이크와 달라 대련에서 제외합니다.</translation>
    </message>
    <message>
        <source>No action of player %1 begins in frames %2 to %3 of take %4.</source>
        <translation>테이크 %4의 프레임 %2~%3에서 시작하는 선수 %1의 동작이 없습니다.</translation>
    </message>
    <message>
        <source>Player %1 does not attack in frames %2 to %3 of take %4.</source>
        <translation>선수 %1은(는) 테이크 %4의 프레임 %2~%3에서 공격하지 않습니다.</translation>
    </message>
    <message>
        <source>Player %1 never attacks.</source>
        <translation>선수 %1은(는) 공격하지 않습니다.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2.</source>
        <translation>폴더 %1을(를) 만들 수 없습니다: %2.</translation>
    </message>
    <message>
        <source>The cutoff must be a positive number of Hz.</source>
        <translation>차단 주파수는 Hz 단위의 양수여야 합니다.</translation>
    </message>
    <message>
        <source>The prominence must be a number of body weights, 0 or more.</source>
        <translation>돌출도는 체중 단위로 0 이상이어야 합니다.</translation>
    </message>
    <message>
        <source>A take needs a name.</source>
        <translation>테이크에는 이름이 필요합니다.</translation>
    </message>
    <message>
        <source>A take has one or two fighters.</source>
        <translation>테이크의 선수는 한 명 또는 두 명입니다.</translation>
    </message>
    <message>
        <source>There is no such place in the list of takes.</source>
        <translation>테이크 목록에 그런 자리가 없습니다.</translation>
    </message>
    <message>
        <source>There is one fighter only: nothing to swap.</source>
        <translation>선수가 한 명뿐이라 맞바꿀 수 없습니다.</translation>
    </message>
    <message>
        <source>The skeleton has no such joint.</source>
        <translation>골격에 그런 관절이 없습니다.</translation>
    </message>
    <message>
        <source>%1 holds %2 frames, but the take reaches to frame %3: it is not the recording that is missing.</source>
        <translation>%1의 프레임은 %2개인데 테이크는 프레임 %3까지입니다. 없어진 녹화가 아닙니다.</translation>
    </message>
    <message>
        <source>The placement cannot be written: neither the root nor a joint right below it has all position and rotation channels.</source>
        <translation>위치를 쓸 수 없습니다. 루트나 그 바로 아래 관절에 위치 채널과 회전 채널이 모두 있어야 합니다.</translation>
    </message>
    <message>
        <source>A take is made of one or two recordings.</source>
        <translation>테이크는 녹화 한두 개로 만듭니다.</translation>
    </message>
    <message>
        <source>The take&apos;s name holds bytes that are no UTF-8 text.</source>
        <translation>테이크 이름에 UTF-8이 아닌 바이트가 있습니다.</translation>
    </message>
    <message>
        <source>A frame rate lies between 1 and 10000 Hz.</source>
        <translation>프레임 속도는 1~10000 Hz여야 합니다.</translation>
    </message>
    <message>
        <source>The recordings run at %1 and %2 Hz; each keeps its own rate.</source>
        <translation>녹화의 프레임 속도가 %1 Hz와 %2 Hz입니다. 각자의 속도를 유지합니다.</translation>
    </message>
    <message>
        <source>Take %1, player %2: no pelvis or no centre of mass is known, so its actions are left out.</source>
        <translation>테이크 %1, 선수 %2: 골반이나 질량 중심을 알 수 없어 그 동작을 제외합니다.</translation>
    </message>
    <message>
        <source>Player %1: %2 of %3 actions have no label and are left out, with every transition that touches them.</source>
        <translation>선수 %1: 동작 %3개 중 %2개에 레이블이 없어, 관련된 모든 전이와 함께 제외합니다.</translation>
    </message>
    <message>
        <source>No take of two has a recording of player %1 with the skeleton of the bout: it was removed since the bout was begun.</source>
        <translation>두 선수의 테이크 중에 대련의 골격을 쓰는 선수 %1의 녹화가 없습니다. 대련을 시작한 뒤 제거되었습니다.</translation>
    </message>
    <message>
        <source>An .eaf file holds one take: say which.</source>
        <translation>.eaf 파일에는 테이크가 하나만 들어갑니다. 어느 것인지 지정하세요.</translation>
    </message>
    <message>
        <source>is empty.</source>
        <translation>비어 있습니다.</translation>
    </message>
    <message>
        <source>has no column %1; a label table needs begin_s, end_s and label.</source>
        <translation>%1 열이 없습니다. 레이블 표에는 begin_s, end_s, label이 필요합니다.</translation>
    </message>
    <message>
        <source>holds no labels: it has neither &quot;kumite_labels&quot; nor &quot;players&quot;.</source>
        <translation>레이블이 없습니다. “kumite_labels”도 “players”도 없습니다.</translation>
    </message>
    <message>
        <source>There is no action %1; the fighter has %2.</source>
        <translation>동작 %1이(가) 없습니다. 선수의 동작은 %2개입니다.</translation>
    </message>
    <message>
        <source>The vocabulary has no aspect %1.</source>
        <translation>어휘에 측면 %1이(가) 없습니다.</translation>
    </message>
    <message>
        <source>%1 has no qualifier %2.</source>
        <translation>%1에 수식어 %2이(가) 없습니다.</translation>
    </message>
    <message>
        <source>The label belongs to another vocabulary.</source>
        <translation>다른 어휘의 레이블입니다.</translation>
    </message>
    <message>
        <source>The thresholds of the rules must be numbers, 0 or more.</source>
        <translation>규칙의 임곗값은 0 이상의 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>A cross-validation has two folds or more.</source>
        <translation>교차 검증에는 겹이 둘 이상 필요합니다.</translation>
    </message>
    <message>
        <source>A library&apos;s rate lies between %1 and %2 Hz.</source>
        <translation>라이브러리의 프레임 속도는 %1~%2 Hz여야 합니다.</translation>
    </message>
    <message>
        <source>The library is empty: no source holds the motion of a body.</source>
        <translation>라이브러리가 비어 있습니다. 인체의 모션이 있는 출처가 없습니다.</translation>
    </message>
    <message>
        <source>The library has no clip &quot;%1&quot;; it has %2.</source>
        <translation>라이브러리에 클립 “%1”이(가) 없습니다. 있는 클립: %2.</translation>
    </message>
    <message>
        <source>None of these clips shows a hand or a foot that strikes.</source>
        <translation>이 가운데 손이나 발로 타격하는 클립이 없습니다.</translation>
    </message>
    <message>
        <source>No strike of the %1 was found in &quot;%2&quot;.</source>
        <translation>“%2”에서 %1의 타격을 찾지 못했습니다.</translation>
    </message>
    <message>
        <source>%1 was not where the project says; the same recording was found at %2.</source>
        <translation>%1이(가) 프로젝트에 적힌 곳에 없습니다. 같은 녹화를 %2에서 찾았습니다.</translation>
    </message>
    <message>
        <source>%1 is there already: choose another name.</source>
        <translation>%1이(가) 이미 있습니다. 다른 이름을 고르세요.</translation>
    </message>
    <message>
        <source>is a recording; make a project of it with kumite new.</source>
        <translation>녹화입니다. kumite new로 프로젝트를 만드세요.</translation>
    </message>
    <message>
        <source>is not a Kumite project: it has no &quot;kumite&quot; version.</source>
        <translation>Kumite 프로젝트가 아닙니다. “kumite” 버전이 없습니다.</translation>
    </message>
    <message>
        <source>was written by a newer Kumite (file version %1, this one reads up to %2); open it with that one.</source>
        <translation>더 새로운 Kumite에서 쓴 파일입니다(파일 버전 %1, 여기서는 %2까지 읽음). 그 Kumite로 여세요.</translation>
    </message>
    <message>
        <source>No motion from key poses of %1: %2</source>
        <translation>%1의 키 포즈로 모션을 만들지 못했습니다: %2</translation>
    </message>
    <message>
        <source>There is no clip to rate.</source>
        <translation>평가할 클립이 없습니다.</translation>
    </message>
    <message>
        <source>Frame %1 is not inside the take: a boundary cannot stand there.</source>
        <translation>프레임 %1은(는) 테이크 안에 있지 않습니다. 그곳에는 경계를 둘 수 없습니다.</translation>
    </message>
    <message>
        <source>Fighter %1 has another boundary at frame %2; forget this one.</source>
        <translation>선수 %1의 프레임 %2에 다른 경계가 있습니다. 이 수정은 ‘잊기’로 없애세요.</translation>
    </message>
    <message>
        <source>Fighter %1 has no action at frame %2.</source>
        <translation>선수 %1의 프레임 %2에 동작이 없습니다.</translation>
    </message>
    <message>
        <source>The budget is a share of all actions, above 0 and at most 1.</source>
        <translation>예산은 전체 동작에서 차지하는 비율로, 0보다 크고 1 이하여야 합니다.</translation>
    </message>
    <message>
        <source>Player %1 has no labelled action that follows another labelled one: label more of it.</source>
        <translation>선수 %1에는 레이블이 붙은 동작이 연달아 나오는 곳이 없습니다. 레이블을 더 붙이세요.</translation>
    </message>
    <message>
        <source>The captured attack holds no action.</source>
        <translation>캡처된 공격에 동작이 없습니다.</translation>
    </message>
    <message>
        <source>No take of two shows player %1.</source>
        <translation>두 선수의 테이크 중에 선수 %1이(가) 나오는 것이 없습니다.</translation>
    </message>
    <message>
        <source>The captured attack cannot be shown: its take is missing.</source>
        <translation>테이크가 없어 캡처된 공격을 표시할 수 없습니다.</translation>
    </message>
    <message>
        <source>Player %1 shows nothing but attacks outside of the captured one.</source>
        <translation>캡처된 공격을 빼면 선수 %1에게는 공격밖에 없습니다.</translation>
    </message>
    <message>
        <source>No recorded moment shows both fighters labelled.</source>
        <translation>두 선수 모두 레이블이 붙어 있는 녹화 장면이 없습니다.</translation>
    </message>
    <message>
        <source>Only a bout with an avatar can be steered.</source>
        <translation>아바타가 있는 대련만 조종할 수 있습니다.</translation>
    </message>
    <message>
        <source>The library was made without an avatar&apos;s model.</source>
        <translation>이 라이브러리는 아바타 모델 없이 만들어졌습니다.</translation>
    </message>
    <message>
        <source>Player %1 never shows &quot;%2&quot; after another labelled action.</source>
        <translation>선수 %1은(는) 레이블이 붙은 다른 동작에 이어 “%2”을(를) 하지 않습니다.</translation>
    </message>
    <message>
        <source>A weight is 0 (never) or a positive factor.</source>
        <translation>가중치는 0(절대 안 함)이거나 양수여야 합니다.</translation>
    </message>
    <message>
        <source>A temperature is 0 or positive.</source>
        <translation>온도는 0 이상이어야 합니다.</translation>
    </message>
    <message>
        <source>No action of the avatar is followed by half a second of its take.</source>
        <translation>뒤로 테이크가 0.5초 더 이어지는 아바타의 동작이 없습니다.</translation>
    </message>
    <message>
        <source>The action has no frame.</source>
        <translation>동작에 프레임이 없습니다.</translation>
    </message>
    <message>
        <source>The threshold of pose clusters must be a positive number.</source>
        <translation>포즈 군집의 임곗값은 양수여야 합니다.</translation>
    </message>
    <message>
        <source>The block &quot;%1&quot; has no motion.</source>
        <translation>블록 “%1”에 모션이 없습니다.</translation>
    </message>
    <message>
        <source>Frames %1:%2 cannot be taken from &quot;%3&quot;, which has %4.</source>
        <translation>프레임이 %4개인 “%3”에서 프레임 %1:%2을(를) 가져올 수 없습니다.</translation>
    </message>
    <message>
        <source>The block &quot;%1&quot; has no frame.</source>
        <translation>블록 “%1”에 프레임이 없습니다.</translation>
    </message>
    <message>
        <source>The sequence has no block.</source>
        <translation>시퀀스에 블록이 없습니다.</translation>
    </message>
    <message>
        <source>There is no path in the graph between these two actions; choose a curve, or clips played backward.</source>
        <translation>그래프에 이 두 동작을 잇는 경로가 없습니다. 곡선이나 거꾸로 재생하는 클립을 고르세요.</translation>
    </message>
    <message>
        <source>There are %1 candidate paths, counted from 0: no path %2.</source>
        <translation>후보 경로는 %1개이며 0부터 셉니다. 경로 %2은(는) 없습니다.</translation>
    </message>
    <message>
        <source>A transition needs motion on both sides.</source>
        <translation>전이에는 양쪽에 모션이 필요합니다.</translation>
    </message>
    <message>
        <source>%1 (%2–%3 s, fighter %4): %5</source>
        <translation>%1 (%2~%3 s, 선수 %4): %5</translation>
    </message>
    <message>
        <source>at least one whole frame</source>
        <translation>온전한 프레임 하나 이상</translation>
    </message>
    <message>
        <source>the number of a frame</source>
        <translation>프레임의 번호</translation>
    </message>
    <message>
        <source>a bone of the skeleton that has a dof, or the number of the frame after %1</source>
        <translation>dof가 있는 골격의 뼈, 또는 %1 다음 프레임의 번호</translation>
    </message>
    <message>
        <source>each bone once in frame %1</source>
        <translation>프레임 %1에서 한 번씩만 나오는 뼈</translation>
    </message>
    <message>
        <source>a number for bone %1 in frame %2</source>
        <translation>프레임 %2의 뼈 %1에 대한 숫자</translation>
    </message>
    <message>
        <source>only %1 numbers for bone %2 in frame %3</source>
        <translation>프레임 %3의 뼈 %2에 대한 숫자 %1개</translation>
    </message>
    <message>
        <source>a section of an ASF file, such as :units or :bonedata</source>
        <translation>:units나 :bonedata 같은 ASF 파일의 섹션</translation>
    </message>
    <message>
        <source>the section :root</source>
        <translation>:root 섹션</translation>
    </message>
    <message>
        <source>the section :hierarchy</source>
        <translation>:hierarchy 섹션</translation>
    </message>
    <message>
        <source>deg or rad</source>
        <translation>deg 또는 rad</translation>
    </message>
    <message>
        <source>order, axis, position or orientation</source>
        <translation>order, axis, position 또는 orientation</translation>
    </message>
    <message>
        <source>10000 bones at most</source>
        <translation>최대 10000개의 뼈</translation>
    </message>
    <message>
        <source>end, behind the last line of a bone</source>
        <translation>뼈의 마지막 줄 뒤의 end</translation>
    </message>
    <message>
        <source>the name of a bone of :bonedata, or end</source>
        <translation>:bonedata에 있는 뼈의 이름, 또는 end</translation>
    </message>
    <message>
        <source>an order of rotations, such as XYZ</source>
        <translation>XYZ 같은 회전 순서</translation>
    </message>
    <message>
        <source>each degree of freedom once</source>
        <translation>한 번씩만 나오는 자유도</translation>
    </message>
    <message>
        <source>OFFSET, CHANNELS, JOINT, End Site or } in joint %1</source>
        <translation>관절 %1의 OFFSET, CHANNELS, JOINT, End Site 또는 }</translation>
    </message>
    <message>
        <source>the number of channels, 0 to 6</source>
        <translation>채널의 수(0~6)</translation>
    </message>
    <message>
        <source>each channel once in a joint</source>
        <translation>관절마다 한 번씩만 나오는 채널</translation>
    </message>
    <message>
        <source>channel %1 of %2: Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation</source>
        <translation>채널 %1(모두 %2개): Xposition, Yposition, Zposition, Xrotation, Yrotation 또는 Zrotation</translation>
    </message>
    <message>
        <source>a finite number with a decimal point</source>
        <translation>소수점을 쓴 유한한 수</translation>
    </message>
    <message>
        <source>no action of the opponent at that time</source>
        <translation>그 시점에 상대의 동작 없음</translation>
    </message>
    <message>
        <source>the opponent&apos;s action is no attack</source>
        <translation>상대의 동작이 공격이 아님</translation>
    </message>
    <message>
        <source>stands left</source>
        <translation>왼발 디딤</translation>
    </message>
    <message>
        <source>stands right</source>
        <translation>오른발 디딤</translation>
    </message>
    <message>
        <source>in the air</source>
        <translation>공중</translation>
    </message>
    <message>
        <source>opponent&apos;s %1, closing only %2 m/s</source>
        <translation>상대의 %1, 접근 속도가 %2 m/s에 그침</translation>
    </message>
    <message>
        <source>opponent&apos;s %1, closing %2 m/s</source>
        <translation>상대의 %1, 접근 속도 %2 m/s</translation>
    </message>
    <message>
        <source>%1 at the beginning, %2 at the end</source>
        <translation>시작은 %1, 끝은 %2</translation>
    </message>
    <message>
        <source>There is no root %1; the recording has %2.</source>
        <translation>루트 %1이(가) 없습니다. 녹화에 있는 루트: %2.</translation>
    </message>
    <message>
        <source>The body stands on its head most of the time: is up right?</source>
        <translation>몸이 거의 내내 거꾸로 서 있습니다. 위쪽 축이 맞나요?</translation>
    </message>
    <message>
        <source>The legs would be %1 m long: is the unit (%2) right?</source>
        <translation>다리 길이가 %1 m가 됩니다. 단위(%2)가 맞나요?</translation>
    </message>
    <message>
        <source>Relative to the legs the target&apos;s arms are %1 % longer: hands do not reach the same places.</source>
        <translation>다리에 견주어 대상의 팔이 %1 % 더 깁니다. 손이 같은 자리에 닿지 않습니다.</translation>
    </message>
    <message>
        <source>Relative to the legs the target&apos;s arms are %1 % shorter: hands do not reach the same places.</source>
        <translation>다리에 견주어 대상의 팔이 %1 % 더 짧습니다. 손이 같은 자리에 닿지 않습니다.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>%1행</translation>
    </message>
    <message>
        <source>frames %1:%2 cannot be taken from a recording of %3 frames.</source>
        <translation>프레임 %3개인 녹화에서 프레임 %1:%2을(를) 가져올 수 없습니다.</translation>
    </message>
    <message>
        <source>found %1 data, expected BVH or ASF/AMC: import it into Blender and export it as Motion Capture (.bvh).</source>
        <translation>BVH 또는 ASF/AMC여야 하는데 %1 파일입니다. Blender에서 불러와 Motion Capture (.bvh)로 내보내세요.</translation>
    </message>
    <message>
        <source>the opponent&apos;s action is not labelled yet</source>
        <translation>상대의 동작에 아직 레이블이 없음</translation>
    </message>
</context>
<context>
    <name>KeysSheet</name>
    <message>
        <source>Kumite: keys and mouse</source>
        <translation>Kumite: 단축키와 마우스</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>pelvis</source>
        <translation>골반</translation>
    </message>
    <message>
        <source>spine</source>
        <translation>척추</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>가슴</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>목</translation>
    </message>
    <message>
        <source>head</source>
        <translation>머리</translation>
    </message>
    <message>
        <source>left clavicle</source>
        <translation>왼쪽 쇄골</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>왼쪽 어깨</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>왼쪽 팔꿈치</translation>
    </message>
    <message>
        <source>left wrist</source>
        <translation>왼쪽 손목</translation>
    </message>
    <message>
        <source>left hip</source>
        <translation>왼쪽 고관절</translation>
    </message>
    <message>
        <source>left knee</source>
        <translation>왼쪽 무릎</translation>
    </message>
    <message>
        <source>left ankle</source>
        <translation>왼쪽 발목</translation>
    </message>
    <message>
        <source>left toe</source>
        <translation>왼쪽 발가락</translation>
    </message>
    <message>
        <source>right clavicle</source>
        <translation>오른쪽 쇄골</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>오른쪽 어깨</translation>
    </message>
    <message>
        <source>right elbow</source>
        <translation>오른쪽 팔꿈치</translation>
    </message>
    <message>
        <source>right wrist</source>
        <translation>오른쪽 손목</translation>
    </message>
    <message>
        <source>right hip</source>
        <translation>오른쪽 고관절</translation>
    </message>
    <message>
        <source>right knee</source>
        <translation>오른쪽 무릎</translation>
    </message>
    <message>
        <source>right ankle</source>
        <translation>오른쪽 발목</translation>
    </message>
    <message>
        <source>right toe</source>
        <translation>오른쪽 발가락</translation>
    </message>
</context>
<context>
    <name>ShortLabel</name>
    <message>
        <source>fwd</source>
        <translation>앞</translation>
    </message>
    <message>
        <source>bwd</source>
        <translation>뒤</translation>
    </message>
    <message>
        <source>bwdfwd</source>
        <translation>뒤앞</translation>
    </message>
    <message>
        <source>fwdbwd</source>
        <translation>앞뒤</translation>
    </message>
    <message>
        <source>up</source>
        <translation>위</translation>
    </message>
    <message>
        <source>down</source>
        <translation>아래</translation>
    </message>
    <message>
        <source>downup</source>
        <translation>아래위</translation>
    </message>
    <message>
        <source>kick</source>
        <translation>킥</translation>
    </message>
    <message>
        <source>punch</source>
        <translation>펀치</translation>
    </message>
    <message>
        <source>L-L</source>
        <translation>왼-왼</translation>
    </message>
    <message>
        <source>L-R</source>
        <translation>왼-오</translation>
    </message>
    <message>
        <source>L-F</source>
        <translation>왼-공</translation>
    </message>
    <message>
        <source>R-L</source>
        <translation>오-왼</translation>
    </message>
    <message>
        <source>R-R</source>
        <translation>오-오</translation>
    </message>
    <message>
        <source>R-F</source>
        <translation>오-공</translation>
    </message>
    <message>
        <source>F-L</source>
        <translation>공-왼</translation>
    </message>
    <message>
        <source>F-R</source>
        <translation>공-오</translation>
    </message>
    <message>
        <source>F-F</source>
        <translation>공-공</translation>
    </message>
</context>
<context>
    <name>Vocabulary</name>
    <message>
        <source>Left punch</source>
        <translation>왼손 펀치</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>앞으로</translation>
    </message>
    <message>
        <source>back</source>
        <translation>뒤로</translation>
    </message>
    <message>
        <source>back and forward</source>
        <translation>뒤로 앞으로</translation>
    </message>
    <message>
        <source>forward and back</source>
        <translation>앞으로 뒤로</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Right punch</source>
        <translation>오른손 펀치</translation>
    </message>
    <message>
        <source>Left kick</source>
        <translation>왼발 킥</translation>
    </message>
    <message>
        <source>up</source>
        <translation>위로</translation>
    </message>
    <message>
        <source>down</source>
        <translation>아래로</translation>
    </message>
    <message>
        <source>down and up</source>
        <translation>아래로 위로</translation>
    </message>
    <message>
        <source>Right kick</source>
        <translation>오른발 킥</translation>
    </message>
    <message>
        <source>Jump</source>
        <translation>점프</translation>
    </message>
    <message>
        <source>React</source>
        <translation>반응</translation>
    </message>
    <message>
        <source>to a kick</source>
        <translation>킥에</translation>
    </message>
    <message>
        <source>to a punch</source>
        <translation>펀치에</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>left to left</source>
        <translation>왼발에서 왼발</translation>
    </message>
    <message>
        <source>left to right</source>
        <translation>왼발에서 오른발</translation>
    </message>
    <message>
        <source>left to flight</source>
        <translation>왼발에서 공중</translation>
    </message>
    <message>
        <source>right to left</source>
        <translation>오른발에서 왼발</translation>
    </message>
    <message>
        <source>right to right</source>
        <translation>오른발에서 오른발</translation>
    </message>
    <message>
        <source>right to flight</source>
        <translation>오른발에서 공중</translation>
    </message>
    <message>
        <source>flight to left</source>
        <translation>공중에서 왼발</translation>
    </message>
    <message>
        <source>flight to right</source>
        <translation>공중에서 오른발</translation>
    </message>
    <message>
        <source>flight to flight</source>
        <translation>공중에서 공중</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>없음</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Key: %1</source>
        <translation>단축키: %1</translation>
    </message>
</context>
<context>
    <name>kumite</name>
    <message>
        <source>Male means (de Leva 1996)</source>
        <translation>남성 평균 (de Leva 1996)</translation>
    </message>
    <message>
        <source>Female means (de Leva 1996)</source>
        <translation>여성 평균 (de Leva 1996)</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>오늘 %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>어제 %1</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>극소점</translation>
    </message>
    <message>
        <source>foot contact</source>
        <translation>발 접촉</translation>
    </message>
    <message>
        <source>boundary of the other</source>
        <translation>다른 선수의 경계</translation>
    </message>
    <message>
        <source>playhead</source>
        <translation>재생 헤드</translation>
    </message>
</context>
<context>
    <name>kumite::studio</name>
    <message>
        <source>example, sample, tutorial, try</source>
        <translation>예제, 샘플, 튜토리얼, 체험, 데모</translation>
    </message>
    <message>
        <source>import, load, bvh, amc, asf, mocap, motion capture, new project</source>
        <translation>가져오기, 불러오기, bvh, amc, asf, 모캡, 모션 캡처, 새 프로젝트</translation>
    </message>
    <message>
        <source>load, kumite file</source>
        <translation>불러오기, kumite 파일</translation>
    </message>
    <message>
        <source>store, write</source>
        <translation>저장, 쓰기, 보존</translation>
    </message>
    <message>
        <source>copy, rename project, duplicate</source>
        <translation>복사, 프로젝트 이름 바꾸기, 복제</translation>
    </message>
    <message>
        <source>backup, restore, earlier, revert, snapshot</source>
        <translation>백업, 복원, 이전, 되돌리기, 스냅샷</translation>
    </message>
    <message>
        <source>csv, json, table, spreadsheet, results, segmentation</source>
        <translation>csv, json, 표, 스프레드시트, 결과, 분할</translation>
    </message>
    <message>
        <source>bvh, skeleton, animation, blender, mocap</source>
        <translation>bvh, 골격, 스켈레톤, 애니메이션, blender, 모캡</translation>
    </message>
    <message>
        <source>missing, relink, locate, moved</source>
        <translation>없음, 다시 연결, 찾기, 이동됨</translation>
    </message>
    <message>
        <source>exit, close, leave</source>
        <translation>종료, 닫기, 나가기</translation>
    </message>
    <message>
        <source>back, revert, oops</source>
        <translation>뒤로, 되돌리기, 취소, 실수</translation>
    </message>
    <message>
        <source>again, repeat</source>
        <translation>다시, 반복, 재실행</translation>
    </message>
    <message>
        <source>settings, options, configuration, shortcuts, autosave</source>
        <translation>설정, 옵션, 환경 설정, 단축키, 자동 저장</translation>
    </message>
    <message>
        <source>import, new, load, clip, session</source>
        <translation>가져오기, 새로, 불러오기, 클립, 세션</translation>
    </message>
    <message>
        <source>name, title</source>
        <translation>이름, 제목</translation>
    </message>
    <message>
        <source>delete, close, clip</source>
        <translation>삭제, 닫기, 클립</translation>
    </message>
    <message>
        <source>previous clip, switch</source>
        <translation>이전 클립, 전환</translation>
    </message>
    <message>
        <source>next clip, switch</source>
        <translation>다음 클립, 전환</translation>
    </message>
    <message>
        <source>switch, opponent, toggle, player</source>
        <translation>전환, 상대, 바꾸기, 플레이어</translation>
    </message>
    <message>
        <source>joints, roles, skeleton, rate, offset, sync, floor, body model, mass</source>
        <translation>관절, 역할, 골격, 프레임 속도, 오프셋, 동기화, 바닥, 신체 모델, 질량</translation>
    </message>
    <message>
        <source>exchange, colours, player</source>
        <translation>교환, 색, 플레이어</translation>
    </message>
    <message>
        <source>warnings, problems, errors, log, report</source>
        <translation>경고, 문제, 오류, 로그, 보고서</translation>
    </message>
    <message>
        <source>delete, erase, clear, undelete, merge, cut</source>
        <translation>삭제, 지우기, 비우기, 삭제 취소, 병합, 자르기</translation>
    </message>
    <message>
        <source>split, cut, insert, new, razor, slice, mark, here</source>
        <translation>나누기, 자르기, 삽입, 새로, 분할, 표시, 여기</translation>
    </message>
    <message>
        <source>merge left, combine, previous</source>
        <translation>왼쪽과 병합, 합치기, 이전</translation>
    </message>
    <message>
        <source>merge right, combine, next</source>
        <translation>오른쪽과 병합, 합치기, 다음</translation>
    </message>
    <message>
        <source>nudge left, shift</source>
        <translation>왼쪽으로 조금, 옮기기</translation>
    </message>
    <message>
        <source>nudge right, shift</source>
        <translation>오른쪽으로 조금, 옮기기</translation>
    </message>
    <message>
        <source>repeat, zoom to action, segment</source>
        <translation>반복, 동작 확대, 구간</translation>
    </message>
    <message>
        <source>comment, annotate, remark, text, label</source>
        <translation>댓글, 주석, 메모, 글, 레이블</translation>
    </message>
    <message>
        <source>review, suspicious, error, uncertain, queue</source>
        <translation>검토, 의심, 오류, 불확실, 대기열</translation>
    </message>
    <message>
        <source>review, suspicious</source>
        <translation>검토, 의심</translation>
    </message>
    <message>
        <source>accept, approve, confirm, ok, yes, good</source>
        <translation>수락, 승인, 확인, 예, 좋음</translation>
    </message>
    <message>
        <source>reject, delete, dismiss, discard, no, false, wrong</source>
        <translation>거부, 삭제, 무시, 버리기, 아니요, 틀림</translation>
    </message>
    <message>
        <source>reset, reopen, undecided, withdraw</source>
        <translation>초기화, 다시 열기, 미정, 철회</translation>
    </message>
    <message>
        <source>difference, a/b, versus, parameters</source>
        <translation>차이, a/b, 대비, 매개변수</translation>
    </message>
    <message>
        <source>raw, unfiltered, noise</source>
        <translation>원본, 필터 없음, 노이즈</translation>
    </message>
    <message>
        <source>com, cog, gravity</source>
        <translation>com, cog, 무게중심, 중력</translation>
    </message>
    <message>
        <source>velocity, wrist, punch</source>
        <translation>속도, 손목, 펀치</translation>
    </message>
    <message>
        <source>velocity, ankle, kick</source>
        <translation>속도, 발목, 킥</translation>
    </message>
    <message>
        <source>seconds, frames, timecode</source>
        <translation>초, 프레임, 타임코드</translation>
    </message>
    <message>
        <source>start, stop, run</source>
        <translation>시작, 정지, 실행</translation>
    </message>
    <message>
        <source>pause, halt</source>
        <translation>일시 정지, 멈춤</translation>
    </message>
    <message>
        <source>rewind, shuttle</source>
        <translation>되감기, 셔틀</translation>
    </message>
    <message>
        <source>fast forward, shuttle</source>
        <translation>빨리 감기, 셔틀</translation>
    </message>
    <message>
        <source>previous frame, step</source>
        <translation>이전 프레임, 한 칸</translation>
    </message>
    <message>
        <source>next frame, step</source>
        <translation>다음 프레임, 한 칸</translation>
    </message>
    <message>
        <source>beginning, first frame, rewind</source>
        <translation>처음, 첫 프레임, 되감기</translation>
    </message>
    <message>
        <source>last frame</source>
        <translation>마지막 프레임, 끝</translation>
    </message>
    <message>
        <source>slow motion, speed, rate</source>
        <translation>슬로 모션, 느리게, 속도</translation>
    </message>
    <message>
        <source>speed up, rate</source>
        <translation>속도 높이기, 빠르게</translation>
    </message>
    <message>
        <source>repeat, cycle</source>
        <translation>반복, 되풀이</translation>
    </message>
    <message>
        <source>in point, mark in, start, range</source>
        <translation>시작점, 인 포인트, 시작, 범위</translation>
    </message>
    <message>
        <source>out point, mark out, end, range</source>
        <translation>끝점, 아웃 포인트, 끝, 범위</translation>
    </message>
    <message>
        <source>fit, frame all, zoom out, home, reset view</source>
        <translation>맞춤, 전체 보기, 축소, 홈, 보기 초기화</translation>
    </message>
    <message>
        <source>frame selected, zoom in, focus, centre</source>
        <translation>선택 항목 보기, 확대, 초점, 가운데</translation>
    </message>
    <message>
        <source>sidebar, show panels, focus mode</source>
        <translation>사이드바, 패널 표시, 집중 모드</translation>
    </message>
    <message>
        <source>maximise, maximize</source>
        <translation>최대화, 전체 화면</translation>
    </message>
    <message>
        <source>font size, zoom, bigger, accessibility, scale</source>
        <translation>글자 크기, 확대, 크게, 접근성, 배율</translation>
    </message>
    <message>
        <source>font size, zoom, scale</source>
        <translation>글자 크기, 확대, 배율</translation>
    </message>
    <message>
        <source>dark mode, light mode, colours, auto</source>
        <translation>다크 모드, 라이트 모드, 색, 자동</translation>
    </message>
    <message>
        <source>light mode, bright, white, day, colours</source>
        <translation>라이트 모드, 밝게, 흰색, 낮, 색</translation>
    </message>
    <message>
        <source>dark mode, black, night, colours</source>
        <translation>다크 모드, 어둡게, 검정, 밤, 색</translation>
    </message>
    <message>
        <source>camera, front view</source>
        <translation>카메라, 정면</translation>
    </message>
    <message>
        <source>camera, side view, left, right, profile</source>
        <translation>카메라, 측면, 왼쪽, 오른쪽, 옆모습</translation>
    </message>
    <message>
        <source>camera, top view, bird</source>
        <translation>카메라, 위에서, 조감</translation>
    </message>
    <message>
        <source>camera, behind, third person</source>
        <translation>카메라, 뒤에서, 3인칭</translation>
    </message>
    <message>
        <source>camera, track</source>
        <translation>카메라, 따라가기, 추적</translation>
    </message>
    <message>
        <source>footsteps, feet, ground</source>
        <translation>발자국, 발, 지면</translation>
    </message>
    <message>
        <source>trajectory, path, motion trail</source>
        <translation>궤적, 경로, 모션 자취</translation>
    </message>
    <message>
        <source>com, cog, center, gravity</source>
        <translation>com, cog, 무게중심, 중심, 중력</translation>
    </message>
    <message>
        <source>arrow, vector, ground reaction</source>
        <translation>화살표, 벡터, 지면 반력</translation>
    </message>
    <message>
        <source>onion skin</source>
        <translation>어니언 스킨, 잔상</translation>
    </message>
    <message>
        <source>onion skin, pose, stamp</source>
        <translation>어니언 스킨, 포즈, 찍기</translation>
    </message>
    <message>
        <source>delete ghosts, onion skin</source>
        <translation>잔상 삭제, 어니언 스킨</translation>
    </message>
    <message>
        <source>distance, ruler, speed, tape</source>
        <translation>거리, 자, 속도, 줄자</translation>
    </message>
    <message>
        <source>screenshot, clipboard, image</source>
        <translation>스크린샷, 클립보드, 이미지</translation>
    </message>
    <message>
        <source>screenshot, render, image, png, export picture, capture</source>
        <translation>스크린샷, 렌더링, 이미지, png, 그림 내보내기, 캡처</translation>
    </message>
    <message>
        <source>start, stop, preview</source>
        <translation>시작, 정지, 미리 보기</translation>
    </message>
    <message>
        <source>jump back, skip</source>
        <translation>뒤로 건너뛰기, 점프</translation>
    </message>
    <message>
        <source>jump forward, skip</source>
        <translation>앞으로 건너뛰기, 점프</translation>
    </message>
    <message>
        <source>preview, result, assembled, synthesised, before, after</source>
        <translation>미리 보기, 결과, 조립, 합성, 전, 후</translation>
    </message>
    <message>
        <source>punch, kick, strike, aim, reach, target tool</source>
        <translation>펀치, 킥, 타격, 겨누기, 닿기, 표적 도구</translation>
    </message>
    <message>
        <source>insert key, new pose, keyframe, set key</source>
        <translation>키 삽입, 새 포즈, 키프레임, 키 설정</translation>
    </message>
    <message>
        <source>delete key, erase</source>
        <translation>키 삭제, 지우기</translation>
    </message>
    <message>
        <source>previous keyframe, jump</source>
        <translation>이전 키프레임, 이동</translation>
    </message>
    <message>
        <source>next keyframe, jump</source>
        <translation>다음 키프레임, 이동</translation>
    </message>
    <message>
        <source>nudge left, time, shift</source>
        <translation>왼쪽으로 조금, 시간, 옮기기</translation>
    </message>
    <message>
        <source>nudge right, time, shift</source>
        <translation>오른쪽으로 조금, 시간, 옮기기</translation>
    </message>
    <message>
        <source>duplicate key, clone, paste</source>
        <translation>키 복제, 복사, 붙여넣기</translation>
    </message>
    <message>
        <source>flip, left, right, symmetry, reverse</source>
        <translation>뒤집기, 왼쪽, 오른쪽, 대칭, 반전</translation>
    </message>
    <message>
        <source>grab, capture, snapshot, recording</source>
        <translation>가져오기, 캡처, 스냅샷, 녹화</translation>
    </message>
    <message>
        <source>paste pose, browse, frame, library, import pose</source>
        <translation>포즈 붙여넣기, 찾아보기, 프레임, 라이브러리, 포즈 가져오기</translation>
    </message>
    <message>
        <source>rotate, gizmo, ring, fk, angle, elbow, knee</source>
        <translation>회전, 기즈모, 고리, fk, 각도, 팔꿈치, 무릎</translation>
    </message>
    <message>
        <source>rotate, gizmo, ring, fk, angle</source>
        <translation>회전, 기즈모, 고리, fk, 각도</translation>
    </message>
    <message>
        <source>ripple, shift, time, slide left</source>
        <translation>밀기, 시간, 왼쪽으로</translation>
    </message>
    <message>
        <source>ripple, shift, time, slide right</source>
        <translation>밀기, 시간, 오른쪽으로</translation>
    </message>
    <message>
        <source>retime, faster, speed up, compress, scale time</source>
        <translation>시간 조정, 빠르게, 가속, 압축, 시간 배율</translation>
    </message>
    <message>
        <source>retime, slower, slow down, stretch, scale time</source>
        <translation>시간 조정, 느리게, 감속, 늘이기, 시간 배율</translation>
    </message>
    <message>
        <source>before, after, compare, side by side, a/b, unadjusted</source>
        <translation>이전, 이후, 비교, 나란히, a/b, 조정 없음</translation>
    </message>
    <message>
        <source>onion skin, onion skinning, ghost</source>
        <translation>어니언 스킨, 잔상</translation>
    </message>
    <message>
        <source>partial edit, swap arm, splice, layer, fix, retake</source>
        <translation>부분 편집, 팔 교체, 이어 붙이기, 레이어, 고치기, 다시 찍기</translation>
    </message>
    <message>
        <source>tab, panel, joint, handle</source>
        <translation>탭, 패널, 관절, 핸들</translation>
    </message>
    <message>
        <source>tab, panel, find similar, retrieval, sources, parts</source>
        <translation>탭, 패널, 비슷한 것 찾기, 검색, 출처, 부위</translation>
    </message>
    <message>
        <source>lock, fix, nail, constraint, hold foot</source>
        <translation>잠금, 고정, 제약, 발 고정</translation>
    </message>
    <message>
        <source>effector, hand, foot, ik, select</source>
        <translation>이펙터, 손, 발, ik, 선택</translation>
    </message>
    <message>
        <source>raise, nudge, ik</source>
        <translation>올리기, 조금, ik</translation>
    </message>
    <message>
        <source>lower, nudge, ik</source>
        <translation>내리기, 조금, ik</translation>
    </message>
    <message>
        <source>nudge, ik, left</source>
        <translation>조금, ik, 왼쪽</translation>
    </message>
    <message>
        <source>nudge, ik, right</source>
        <translation>조금, ik, 오른쪽</translation>
    </message>
    <message>
        <source>nudge, ik, back</source>
        <translation>조금, ik, 뒤로</translation>
    </message>
    <message>
        <source>nudge, ik, forward</source>
        <translation>조금, ik, 앞으로</translation>
    </message>
    <message>
        <source>source, automatic, best match, reset</source>
        <translation>출처, 자동, 최적 일치, 초기화</translation>
    </message>
    <message>
        <source>delete all, reset, start over</source>
        <translation>모두 삭제, 초기화, 처음부터</translation>
    </message>
    <message>
        <source>import, library, load, bvh</source>
        <translation>가져오기, 라이브러리, 불러오기, bvh</translation>
    </message>
    <message>
        <source>import, library, directory, bvh</source>
        <translation>가져오기, 라이브러리, 디렉터리, 폴더, bvh</translation>
    </message>
    <message>
        <source>save, bake, new take</source>
        <translation>저장, 베이크, 새 테이크</translation>
    </message>
    <message>
        <source>save, bvh, gltf, glb, animation</source>
        <translation>저장, bvh, gltf, glb, 애니메이션</translation>
    </message>
    <message>
        <source>beginning, rewind</source>
        <translation>처음, 되감기</translation>
    </message>
    <message>
        <source>repeat, cycle, endless</source>
        <translation>반복, 되풀이, 무한</translation>
    </message>
    <message>
        <source>play live, game, controller, real time</source>
        <translation>라이브 재생, 게임, 컨트롤러, 실시간</translation>
    </message>
    <message>
        <source>stop live, end</source>
        <translation>라이브 정지, 끝</translation>
    </message>
    <message>
        <source>insert, append, clip, action</source>
        <translation>삽입, 덧붙이기, 클립, 동작</translation>
    </message>
    <message>
        <source>replace, exchange, other action</source>
        <translation>교체, 교환, 다른 동작</translation>
    </message>
    <message>
        <source>delete, erase, cut</source>
        <translation>삭제, 지우기, 잘라내기</translation>
    </message>
    <message>
        <source>select, jump</source>
        <translation>선택, 이동</translation>
    </message>
    <message>
        <source>move left, reorder</source>
        <translation>왼쪽으로 이동, 순서 바꾸기</translation>
    </message>
    <message>
        <source>move right, reorder</source>
        <translation>오른쪽으로 이동, 순서 바꾸기</translation>
    </message>
    <message>
        <source>repeat, again, loop</source>
        <translation>반복, 다시, 루프</translation>
    </message>
    <message>
        <source>repeat less</source>
        <translation>반복 줄이기</translation>
    </message>
    <message>
        <source>trim, in point, cut start</source>
        <translation>다듬기, 시작점, 앞부분 자르기</translation>
    </message>
    <message>
        <source>trim, out point, cut end</source>
        <translation>다듬기, 끝점, 뒷부분 자르기</translation>
    </message>
    <message>
        <source>untrim, reset</source>
        <translation>다듬기 취소, 초기화</translation>
    </message>
    <message>
        <source>random, reroll, blend, other path</source>
        <translation>무작위, 다시 뽑기, 혼합, 다른 경로</translation>
    </message>
    <message>
        <source>random, reroll, shuffle</source>
        <translation>무작위, 다시 뽑기, 섞기</translation>
    </message>
    <message>
        <source>fix, hold, keep</source>
        <translation>고정, 유지, 보관</translation>
    </message>
    <message>
        <source>delete all, new, reset</source>
        <translation>모두 삭제, 새로, 초기화</translation>
    </message>
    <message>
        <source>search, filter, actions</source>
        <translation>검색, 필터, 동작</translation>
    </message>
    <message>
        <source>library, list, show</source>
        <translation>라이브러리, 목록, 표시</translation>
    </message>
    <message>
        <source>clusters, poses, graph, space</source>
        <translation>군집, 포즈, 그래프, 공간</translation>
    </message>
    <message>
        <source>manual, documentation, guide</source>
        <translation>설명서, 문서, 안내</translation>
    </message>
    <message>
        <source>tutorial, introduction, start, guide</source>
        <translation>튜토리얼, 소개, 시작, 안내</translation>
    </message>
    <message>
        <source>formula, explain, statistics, papers, sources</source>
        <translation>수식, 설명, 통계, 논문, 출처</translation>
    </message>
    <message>
        <source>tutorial, introduction, walkthrough, wizard, guide</source>
        <translation>튜토리얼, 소개, 따라하기, 마법사, 안내</translation>
    </message>
    <message>
        <source>explain, context help</source>
        <translation>설명, 상황별 도움말</translation>
    </message>
    <message>
        <source>explain, accessibility</source>
        <translation>설명, 접근성</translation>
    </message>
    <message>
        <source>shortcuts, hotkeys, cheat sheet, help, manual, print</source>
        <translation>단축키, 핫키, 요약표, 도움말, 설명서, 인쇄</translation>
    </message>
    <message>
        <source>release notes, changelog, news, version</source>
        <translation>릴리스 노트, 변경 내역, 새 소식, 버전</translation>
    </message>
    <message>
        <source>version, licence, license</source>
        <translation>버전, 라이선스, 사용권</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ActionTiles</name>
    <message>
        <source>Similar actions</source>
        <translation>비슷한 동작</translation>
    </message>
    <message>
        <source>Those that look most like the current action, side by side.</source>
        <translation>현재 동작과 가장 비슷해 보이는 동작을 나란히.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ActionsModel</name>
    <message>
        <source>%1, %2 from %3
Return adds it, Shift+Return swaps it for the chosen block</source>
        <translation>%1, %2, %3부터
Return으로 추가, Shift+Return으로 선택한 블록과 교체</translation>
    </message>
    <message>
        <source>action</source>
        <translation>동작</translation>
    </message>
    <message>
        <source>where</source>
        <translation>위치</translation>
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
        <translation>대련 시간</translation>
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
        <translation>아바타: %1</translation>
    </message>
    <message>
        <source>The analysis is not finished yet.</source>
        <translation>분석이 아직 끝나지 않았습니다.</translation>
    </message>
    <message>
        <source>Keep the bout as a take</source>
        <translation>대련을 테이크로 보관</translation>
    </message>
    <message>
        <source>Recordings, NAME-1 and NAME-2 (*.bvh)</source>
        <translation>녹화, NAME-1 및 NAME-2 (*.bvh)</translation>
    </message>
    <message>
        <source>Keeping the bout</source>
        <translation>대련 보관 중</translation>
    </message>
    <message>
        <source>The project changed while the bout was written. Its files are there; open them as a take, or keep it again under another name.</source>
        <translation>대련을 쓰는 동안 프로젝트가 바뀌었습니다. 파일은 만들어졌으니 테이크로 열거나 다른 이름으로 다시 보관하세요.</translation>
    </message>
    <message>
        <source>Kept as take %1. Detection alone finds %2 % and %3 % of its boundaries.</source>
        <translation>테이크 %1(으)로 보관했습니다. 검출만으로 경계의 %2 % 및 %3 %를 찾습니다.</translation>
    </message>
    <message>
        <source>Writing the bout</source>
        <translation>대련 쓰는 중</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Export the bout</source>
        <translation>대련 내보내기</translation>
    </message>
    <message>
        <source>Motion of both, NAME-1 and NAME-2 (*.bvh);;glTF: skeletons and animation (*.glb);;Pictures, 30 a second (*.png);;Video, by ffmpeg (*.mp4);;Log: everything that makes it again (*.json)</source>
        <translation>두 선수의 모션, NAME-1 및 NAME-2 (*.bvh);;glTF: 골격과 애니메이션 (*.glb);;그림, 초당 30장 (*.png);;동영상, ffmpeg 사용 (*.mp4);;로그: 다시 만드는 데 필요한 모든 것 (*.json)</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>취소했습니다.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>저장함: %1</translation>
    </message>
    <message>
        <source>&amp;Bout</source>
        <translation>대련(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Fight or pause</source>
        <translation>대련 또는 일시 정지(&amp;F)</translation>
    </message>
    <message>
        <source>Begin a&amp;new</source>
        <translation>새로 시작(&amp;N)</translation>
    </message>
    <message>
        <source>Begin with the next &amp;seed</source>
        <translation>다음 시드로 시작(&amp;S)</translation>
    </message>
    <message>
        <source>Go on from here with other &amp;draws</source>
        <translation>여기서 다른 추첨으로 계속(&amp;D)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>한 프레임 뒤로</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>한 프레임 앞으로</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>1초 뒤로</translation>
    </message>
    <message>
        <source>One second on</source>
        <translation>1초 앞으로</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>처음으로</translation>
    </message>
    <message>
        <source>To the end of what was shown</source>
        <translation>지금까지 본 끝으로</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>더 느리게</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>더 빠르게</translation>
    </message>
    <message>
        <source>&amp;Automatic: the model decides</source>
        <translation>자동: 모델이 결정(&amp;A)</translation>
    </message>
    <message>
        <source>A&amp;vatar: keys lead one fighter</source>
        <translation>아바타: 키로 한 선수 조종(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Passive: one answers a captured attack</source>
        <translation>수비: 캡처된 공격에 대응(&amp;P)</translation>
    </message>
    <message>
        <source>Avatar: key %1</source>
        <translation>아바타: 키 %1</translation>
    </message>
    <message>
        <source>Avatar: forget &amp;what was asked for</source>
        <translation>아바타: 요청 잊기(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Measure the quality</source>
        <translation>품질 측정(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Keep as a take…</source>
        <translation>테이크로 보관(&amp;K)…</translation>
    </message>
    <message>
        <source>E&amp;xport the bout…</source>
        <translation>대련 내보내기(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutExport</name>
    <message>
        <source>%1: it cannot be written there.</source>
        <translation>%1: 그곳에는 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>There is no ffmpeg on this computer, which a video needs: install it (on Debian and Ubuntu: sudo apt install ffmpeg), or export pictures (.png).</source>
        <translation>이 컴퓨터에 동영상에 필요한 ffmpeg가 없습니다. 설치하거나(Debian과 Ubuntu: sudo apt install ffmpeg) 그림(.png)으로 내보내세요.</translation>
    </message>
    <message>
        <source>%1 cannot be started.</source>
        <translation>%1을(를) 시작할 수 없습니다.</translation>
    </message>
    <message>
        <source>ffmpeg could not write the video: %1</source>
        <translation>ffmpeg가 동영상을 쓰지 못했습니다: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutPage</name>
    <message>
        <source>Why there is no bout</source>
        <translation>대련이 없는 이유</translation>
    </message>
    <message>
        <source>Anew</source>
        <translation>새로</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>보관…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>A bout that goes on for ever, made from what was learnt of the labelled actions, appears here.</source>
        <translation>레이블을 붙인 동작에서 배운 것으로 만든, 끝없이 이어지는 대련이 여기에 나타납니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutPanel</name>
    <message>
        <source>foot skate</source>
        <translation>발 미끄러짐</translation>
    </message>
    <message>
        <source>Share of frames in which a foot near the floor slides faster than 0.5 m/s</source>
        <translation>바닥 근처의 발이 0.5 m/s보다 빠르게 미끄러지는 프레임의 비율</translation>
    </message>
    <message>
        <source>in the floor</source>
        <translation>바닥 침투</translation>
    </message>
    <message>
        <source>Share of frames with a foot more than 5 mm in the floor</source>
        <translation>발이 바닥에 5 mm 넘게 들어간 프레임의 비율</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>겹침</translation>
    </message>
    <message>
        <source>Share of frames with the bodies more than 3 cm in each other</source>
        <translation>두 몸이 서로 3 cm 넘게 겹치는 프레임의 비율</translation>
    </message>
    <message>
        <source>joins</source>
        <translation>이음매</translation>
    </message>
    <message>
        <source>Joint accelerations where actions are joined, their 99th percentile over that inside recorded actions</source>
        <translation>동작을 잇는 곳의 관절 가속도: 99번째 백분위수를 녹화된 동작 안의 값으로 나눈 것</translation>
    </message>
    <message>
        <source>facing</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>Mean angle between where a fighter faces and its opponent</source>
        <translation>선수가 향한 방향과 상대 사이의 평균 각도</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>Mean distance between both fighters</source>
        <translation>두 선수 사이의 평균 거리</translation>
    </message>
    <message>
        <source>hit timing</source>
        <translation>타격 시점</translation>
    </message>
    <message>
        <source>How far reactions are from their due moment, on average</source>
        <translation>반응이 제때에서 벗어난 정도의 평균</translation>
    </message>
    <message>
        <source>variety</source>
        <translation>다양성</translation>
    </message>
    <message>
        <source>Share of distinct runs of three labels; falls with length</source>
        <translation>서로 다른 세 레이블 연속의 비율. 길수록 낮아집니다</translation>
    </message>
    <message>
        <source>reacts first</source>
        <translation>반응 우선</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>측정</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>자동</translation>
    </message>
    <message>
        <source>Avatar</source>
        <translation>아바타</translation>
    </message>
    <message>
        <source>Passive</source>
        <translation>수비</translation>
    </message>
    <message>
        <source>The model decides for both</source>
        <translation>두 선수 모두 모델이 결정합니다</translation>
    </message>
    <message>
        <source>Keys and pointer lead one fighter, the model the other</source>
        <translation>키와 포인터가 한 선수를, 모델이 다른 선수를 움직입니다</translation>
    </message>
    <message>
        <source>One replays a captured attack that the model has not seen; the other answers and may not attack</source>
        <translation>한 선수는 모델이 보지 못한 캡처된 공격을 재생하고, 다른 선수는 대응만 하며 공격할 수 없습니다</translation>
    </message>
    <message>
        <source>Under attack the avatar may answer before it does as asked</source>
        <translation>공격받으면 아바타가 요청보다 먼저 대응할 수 있습니다</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>시드</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>시드</translation>
    </message>
    <message>
        <source>The same seed gives the same bout</source>
        <translation>시드가 같으면 대련도 같습니다</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>온도</translation>
    </message>
    <message>
        <source>0: always the likeliest; 1: as learnt; above: more even</source>
        <translation>0: 항상 가장 유력한 것, 1: 배운 대로, 그 이상: 더 고르게</translation>
    </message>
    <message>
        <source>State of the bout</source>
        <translation>대련 상태</translation>
    </message>
    <message>
        <source>Why this?</source>
        <translation>왜 이것을?</translation>
    </message>
    <message>
        <source>The choice</source>
        <translation>선택</translation>
    </message>
    <message>
        <source>What else it could have done</source>
        <translation>다른 가능성</translation>
    </message>
    <message>
        <source>A click takes another one and goes on from there</source>
        <translation>클릭하면 다른 것을 골라 거기서 계속합니다</translation>
    </message>
    <message>
        <source>It cannot be taken: %1.</source>
        <translation>선택할 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>품질</translation>
    </message>
    <message>
        <source>Measures all that was shown, beside the longest recording</source>
        <translation>지금까지 본 전체를 가장 긴 녹화와 나란히 측정합니다</translation>
    </message>
    <message>
        <source>Quality of the bout and of the recording</source>
        <translation>대련과 녹화의 품질</translation>
    </message>
    <message>
        <source>bout</source>
        <translation>대련</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>녹화</translation>
    </message>
    <message>
        <source>attacker</source>
        <translation>공격자</translation>
    </message>
    <message>
        <source>avatar</source>
        <translation>아바타</translation>
    </message>
    <message>
        <source>Who attacks</source>
        <translation>공격하는 선수</translation>
    </message>
    <message>
        <source>Who is led</source>
        <translation>조종되는 선수</translation>
    </message>
    <message>
        <source>The fighter that replays a captured attack</source>
        <translation>캡처된 공격을 재생하는 선수</translation>
    </message>
    <message>
        <source>The fighter that keys and clicks on the floor lead</source>
        <translation>키와 바닥 클릭으로 조종하는 선수</translation>
    </message>
    <message>
        <source>A bout is being prepared.</source>
        <translation>대련을 준비하고 있습니다.</translation>
    </message>
    <message>
        <source>Keys 1 to 9 ask the avatar for something, a click on the floor says where to be.</source>
        <translation>키 1~9로 아바타에게 요청하고, 바닥을 클릭해 갈 곳을 정합니다.</translation>
    </message>
    <message>
        <source>Asked for: %1</source>
        <translation>요청함: %1</translation>
    </message>
    <message>
        <source>Labels or boundaries changed: begin anew to use them.</source>
        <translation>레이블이나 경계가 바뀌었습니다. 새로 시작하면 반영됩니다.</translation>
    </message>
    <message>
        <source>Each choice, with all that could have been, appears here.</source>
        <translation>각 선택과 다른 모든 가능성이 여기에 나타납니다.</translation>
    </message>
    <message>
        <source>%1 at %2, after %3, while %4</source>
        <translation>%2에 %1, %3 다음, 상대 %4</translation>
    </message>
    <message>
        <source>: replayed</source>
        <translation>: 재생됨</translation>
    </message>
    <message>
        <source>: chosen by hand</source>
        <translation>: 수동으로 선택</translation>
    </message>
    <message>
        <source>: as asked for</source>
        <translation>: 요청대로</translation>
    </message>
    <message>
        <source> (no other stance was left)</source>
        <translation> (다른 디딤이 남지 않음)</translation>
    </message>
    <message>
        <source>Measure (%1 s)</source>
        <translation>측정 (%1 s)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutSession</name>
    <message>
        <source>anything</source>
        <translation>아무거나</translation>
    </message>
    <message>
        <source>Preparing a bout</source>
        <translation>대련 준비 중</translation>
    </message>
    <message>
        <source>Measuring the bout</source>
        <translation>대련 측정 중</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutStrip</name>
    <message>
        <source>Actions of the bout</source>
        <translation>대련의 동작</translation>
    </message>
    <message>
        <source>%1 · %2 to %3 · %4</source>
        <translation>%1 · %2~%3 · %4</translation>
    </message>
    <message>
        <source>   ·   as asked for</source>
        <translation>   ·   요청대로</translation>
    </message>
    <message>
        <source>   ·   chosen by hand</source>
        <translation>   ·   수동으로 선택</translation>
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
        <translation>레이블 %1</translation>
    </message>
    <message>
        <source>geom. %1</source>
        <translation>기하 %1</translation>
    </message>
    <message>
        <source>both %1</source>
        <translation>둘 다 %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CandidatesModel</name>
    <message>
        <source>no example</source>
        <translation>예 없음</translation>
    </message>
    <message>
        <source>not in this mode</source>
        <translation>이 모드에서 불가</translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation>요청 안 함</translation>
    </message>
    <message>
        <source>other stance</source>
        <translation>다른 디딤</translation>
    </message>
    <message>
        <source>banned</source>
        <translation>금지됨</translation>
    </message>
    <message>
        <source>%1: chance %2, label term %3, geometry term %4, product %5</source>
        <translation>%1: 확률 %2, 레이블 항 %3, 기하 항 %4, 곱 %5</translation>
    </message>
    <message>
        <source>
Sample: %1, %2</source>
        <translation>
표본: %1, %2</translation>
    </message>
    <message>
        <source>
Could not be drawn: %1</source>
        <translation>
뽑을 수 없음: %1</translation>
    </message>
    <message>
        <source>
This was chosen</source>
        <translation>
이것을 선택했습니다</translation>
    </message>
    <message>
        <source>
A click takes it instead</source>
        <translation>
클릭하면 대신 선택합니다</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ClusterMap</name>
    <message>
        <source>Map of poses</source>
        <translation>포즈 지도</translation>
    </message>
    <message>
        <source>A map of the poses appears here: like ones near each other, and the way that a transition takes.</source>
        <translation>포즈 지도가 여기에 나타납니다. 비슷한 포즈는 가까이 놓이고, 전이가 지나는 길이 보입니다.</translation>
    </message>
    <message>
        <source>%1 kinds of poses, like ones near each other · line: what leads where</source>
        <translation>포즈 %1종, 비슷한 것끼리 가까이 · 선: 이어지는 관계</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CommandPalette</name>
    <message>
        <source> · on</source>
        <translation> · 켜짐</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>하려는 일을 입력하세요</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>명령</translation>
    </message>
    <message>
        <source>A name, a menu or a word for it: ↑ ↓ choose, Return runs, Esc leaves</source>
        <translation>이름, 메뉴 또는 관련 단어: ↑ ↓ 선택, Return 실행, Esc 나가기</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>명령</translation>
    </message>
    <message>
        <source>%1 · “%2”</source>
        <translation>%1 · “%2”</translation>
    </message>
    <message>
        <source>No command that can be run now is called “%1”.</source>
        <translation>지금 실행할 수 있는 명령 중에 “%1”은(는) 없습니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CompareBox</name>
    <message>
        <source>Compare with settings B</source>
        <translation>설정 B와 비교</translation>
    </message>
    <message>
        <source> B</source>
        <translation> B</translation>
    </message>
    <message>
        <source>Use B</source>
        <translation>B 사용</translation>
    </message>
    <message>
        <source>Draw beside the project&apos;s boundaries (A) those that other settings give</source>
        <translation>프로젝트의 경계(A) 옆에 다른 설정으로 얻는 경계를 그립니다</translation>
    </message>
    <message>
        <source>Boundaries that differ</source>
        <translation>다른 경계</translation>
    </message>
    <message>
        <source>On the timeline: ○ only in A, dotted lines only in B</source>
        <translation>타임라인에서: ○ A에만 있음, 점선 B에만 있음</translation>
    </message>
    <message>
        <source>Cut the project by settings B</source>
        <translation>설정 B로 프로젝트 분할</translation>
    </message>
    <message>
        <source>Comparing settings</source>
        <translation>설정 비교 중</translation>
    </message>
    <message>
        <source>%1: %2 in both, %3 only A, %4 only B</source>
        <translation>%1: 공통 %2, A만 %3, B만 %4</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CompareLabelsBox</name>
    <message>
        <source>Take theirs</source>
        <translation>다른 쪽 값 쓰기</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>내 값 유지</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>측면</translation>
    </message>
    <message>
        <source>both</source>
        <translation>둘 다</translation>
    </message>
    <message>
        <source>same</source>
        <translation>같음</translation>
    </message>
    <message>
        <source>κ</source>
        <translation>κ</translation>
    </message>
    <message>
        <source>Agreement per aspect</source>
        <translation>측면별 일치도</translation>
    </message>
    <message>
        <source>Both: actions of which both people said something. κ (Cohen): how much more often they say the same than by chance; 1 always, 0 as often as by chance.</source>
        <translation>둘 다: 두 사람이 모두 레이블을 붙인 동작. κ (Cohen): 우연보다 얼마나 더 자주 일치하는지. 1은 항상, 0은 우연만큼.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>차이</translation>
    </message>
    <message>
        <source>Their value, as said by a hand; goes on to the next (Enter)</source>
        <translation>다른 쪽 값을 수동 레이블로 쓰고 다음으로 갑니다 (Enter)</translation>
    </message>
    <message>
        <source>What the project says stays; goes on to the next (Backspace)</source>
        <translation>프로젝트의 값을 그대로 두고 다음으로 갑니다 (Backspace)</translation>
    </message>
    <message>
        <source>Theirs for all that are not decided, as one step of the history</source>
        <translation>정하지 않은 모든 차이에 다른 쪽 값을 쓰고, 작업 내역 한 단계로 남깁니다</translation>
    </message>
    <message>
        <source>Their labels where you have none, as said by a hand, in one step</source>
        <translation>내 레이블이 없는 곳에 다른 쪽 레이블을 수동 레이블로, 한 단계로 추가합니다</translation>
    </message>
    <message>
        <source>The boundaries have changed. Open %1 once more to compare.</source>
        <translation>경계가 바뀌었습니다. 비교하려면 %1을(를) 다시 여세요.</translation>
    </message>
    <message>
        <source>Another person&apos;s labels are compared here with those of the project: Label &gt; Compare with labels of… opens their file.</source>
        <translation>다른 사람의 레이블을 프로젝트의 레이블과 여기서 비교합니다. 레이블 &gt; 다른 사람의 레이블과 비교…에서 파일을 여세요.</translation>
    </message>
    <message>
        <source>%1: 1 action labelled by both, %2 alike</source>
        <translation>%1: 둘 다 레이블을 붙인 동작 1개, 일치 %2</translation>
    </message>
    <message>
        <source>%1: %3 actions labelled by both, %2 alike</source>
        <translation>%1: 둘 다 레이블을 붙인 동작 %3개, 일치 %2</translation>
    </message>
    <message>
        <source>, κ %1</source>
        <translation>, κ %1</translation>
    </message>
    <message>
        <source>. No difference to decide.</source>
        <translation>. 정할 차이가 없습니다.</translation>
    </message>
    <message>
        <source>. 1 difference to decide.</source>
        <translation>. 정할 차이가 1개 있습니다.</translation>
    </message>
    <message>
        <source>. %1 differences to decide.</source>
        <translation>. 정할 차이가 %1개 있습니다.</translation>
    </message>
    <message>
        <source> Only you labelled %1 more.</source>
        <translation> 나만 레이블을 붙인 동작이 %1개 더 있습니다.</translation>
    </message>
    <message>
        <source>Theirs for all %1</source>
        <translation>%1개 모두 다른 쪽 값</translation>
    </message>
    <message>
        <source>Add the 1 that only they labelled</source>
        <translation>다른 쪽에만 있는 1개 추가</translation>
    </message>
    <message>
        <source>Add the %1 that only they labelled</source>
        <translation>다른 쪽에만 있는 %1개 추가</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ConfusionMatrix</name>
    <message>
        <source>no answer</source>
        <translation>답 없음</translation>
    </message>
    <message>
        <source>Confusion matrix</source>
        <translation>혼동 행렬</translation>
    </message>
    <message>
        <source>by rule</source>
        <translation>규칙</translation>
    </message>
    <message>
        <source>by machine</source>
        <translation>학습기</translation>
    </message>
    <message>
        <source>%1 by hand and %2: </source>
        <translation>수동과 %2 모두 %1: </translation>
    </message>
    <message>
        <source>%1 by hand, %2 %3: </source>
        <translation>수동 %1, %3 %2: </translation>
    </message>
    <message>
        <source>1 action</source>
        <translation>동작 1개</translation>
    </message>
    <message>
        <source>%1 actions</source>
        <translation>동작 %1개</translation>
    </message>
    <message>
        <source>, %1 of %2</source>
        <translation>, %2 중 %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DetectionBox</name>
    <message>
        <source>Warning about the cutoff</source>
        <translation>차단 주파수 경고</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DifferencesModel</name>
    <message>
        <source>%1, %2, %3: mine %4, theirs %5</source>
        <translation>%1, %2, %3: 내 값 %4, 다른 쪽 %5</translation>
    </message>
    <message>
        <source>time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>측면</translation>
    </message>
    <message>
        <source>mine</source>
        <translation>내 값</translation>
    </message>
    <message>
        <source>theirs</source>
        <translation>다른 쪽</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DistanceGridView</name>
    <message>
        <source>Distances of poses where motions are joined</source>
        <translation>모션을 잇는 곳의 포즈 거리</translation>
    </message>
    <message>
        <source>How far the poses are from each other: the last frames of what was there down, the first frames of what comes in to the right. The stronger the colour, the nearer they are; the ring is where both were joined.</source>
        <translation>포즈가 서로 얼마나 떨어져 있는지 나타냅니다. 아래로는 앞 모션의 마지막 프레임, 오른쪽으로는 들어오는 모션의 첫 프레임. 색이 진할수록 가깝고, 고리는 둘을 이은 곳입니다.</translation>
    </message>
    <message>
        <source>frames that come in →</source>
        <translation>들어오는 프레임 →</translation>
    </message>
    <message>
        <source>← frames there</source>
        <translation>← 앞 프레임</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Document</name>
    <message>
        <source>The force curves are still being computed; try again in a moment.</source>
        <translation>힘 곡선을 아직 계산하고 있습니다. 잠시 후 다시 시도하세요.</translation>
    </message>
    <message>
        <source>Computing force curves</source>
        <translation>힘 곡선 계산 중</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DocumentPanel</name>
    <message>
        <source>Add recordings to begin a take.</source>
        <translation>녹화를 추가해 테이크를 시작하세요.</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>테이크</translation>
    </message>
    <message>
        <source>Fighters</source>
        <translation>선수</translation>
    </message>
    <message>
        <source>History</source>
        <translation>작업 내역</translation>
    </message>
    <message>
        <source> (missing)</source>
        <translation> (없음)</translation>
    </message>
    <message>
        <source>%1: %2
%3 Hz, %4 frames
Double-click: start, place, floor, joints</source>
        <translation>%1: %2
%3 Hz, 프레임 %4개
두 번 클릭: 시작, 위치, 바닥, 관절</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FighterProperties</name>
    <message>
        <source>Fighter properties</source>
        <translation>선수 속성</translation>
    </message>
    <message>
        <source>Fighter</source>
        <translation>선수</translation>
    </message>
    <message>
        <source>Whose properties are shown: the active fighter&apos;s (Tab)</source>
        <translation>속성을 표시하는 선수: 활성 선수 (Tab)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>Start in seconds</source>
        <translation>시작 시각(초)</translation>
    </message>
    <message>
        <source>When its first frame stands on the clock of the take; puts the fighters in step.</source>
        <translation>첫 프레임이 놓이는 테이크 시각. 두 선수의 시간을 맞춥니다.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Starts at</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>Place in the bout</source>
        <translation>대련에서의 위치</translation>
    </message>
    <message>
        <source>x in metres</source>
        <translation>x(미터)</translation>
    </message>
    <message>
        <source>Shifts the fighter to the side.</source>
        <translation>선수를 옆으로 옮깁니다.</translation>
    </message>
    <message>
        <source>z in metres</source>
        <translation>z(미터)</translation>
    </message>
    <message>
        <source>Shifts the fighter forward or back.</source>
        <translation>선수를 앞이나 뒤로 옮깁니다.</translation>
    </message>
    <message>
        <source>Turn in degrees</source>
        <translation>회전(도)</translation>
    </message>
    <message>
        <source>Turns the fighter about the origin of its recording, before it is shifted.</source>
        <translation>옮기기 전에 녹화의 원점을 중심으로 선수를 돌립니다.</translation>
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
        <translation>회전</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>바닥</translation>
    </message>
    <message>
        <source>found from the feet</source>
        <translation>발에서 자동 검출</translation>
    </message>
    <message>
        <source>The height at which the feet rest; switch it off to set the floor by hand.</source>
        <translation>발이 놓이는 높이. 바닥을 직접 정하려면 끄세요.</translation>
    </message>
    <message>
        <source>Height of the floor in metres</source>
        <translation>바닥 높이(미터)</translation>
    </message>
    <message>
        <source>Where the floor is in the space of the recording.</source>
        <translation>녹화 공간에서 바닥의 위치.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>높이</translation>
    </message>
    <message>
        <source>Body model of the project</source>
        <translation>프로젝트의 신체 모델</translation>
    </message>
    <message>
        <source>Body model</source>
        <translation>신체 모델</translation>
    </message>
    <message>
        <source>How the mass is spread over the body: what the centre of mass and with it the contact force are made of.</source>
        <translation>질량이 몸에 분포하는 방식. 질량 중심과 접촉력을 이것으로 계산합니다.</translation>
    </message>
    <message>
        <source>Which joint is what</source>
        <translation>관절의 역할</translation>
    </message>
    <message>
        <source>Joint of the role %1</source>
        <translation>%1 역할의 관절</translation>
    </message>
    <message>
        <source>The joint of the recording that is the %1 of the body.</source>
        <translation>녹화에서 몸의 %1에 해당하는 관절.</translation>
    </message>
    <message>
        <source>Start, place, floor and joints of a fighter appear here as soon as there is a take.</source>
        <translation>테이크가 생기면 선수의 시작, 위치, 바닥, 관절이 여기에 나타납니다.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 Hz, frames %2 to %3 of %4, %5 joints</source>
        <translation>%1 Hz, 프레임 %2~%3 / %4, 관절 %5개</translation>
    </message>
    <message>
        <source>one unit is %1 m, %2 is up</source>
        <translation>1단위는 %1 m, 위쪽은 %2</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>The recording is missing: File, Find recording.</source>
        <translation>녹화가 없습니다. 파일 &gt; 녹화 찾기를 쓰세요.</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>파일에서…</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>1 role has no joint.</source>
        <translation>역할 1개에 관절이 없습니다.</translation>
    </message>
    <message>
        <source>%1 roles have no joint.</source>
        <translation>역할 %1개에 관절이 없습니다.</translation>
    </message>
    <message>
        <source>Open a body model</source>
        <translation>신체 모델 열기</translation>
    </message>
    <message>
        <source>Body models (*.json)</source>
        <translation>신체 모델 (*.json)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FileActions</name>
    <message>
        <source>A project opens alone: choose one .kumite file, or one or two recordings.</source>
        <translation>프로젝트는 하나만 열 수 있습니다. .kumite 파일 하나 또는 녹화 한두 개를 고르세요.</translation>
    </message>
    <message>
        <source>A take has one or two fighters: choose one or two recordings, not %1.</source>
        <translation>테이크의 선수는 한두 명입니다. 녹화를 %1개가 아니라 한두 개 고르세요.</translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation>다른 곳에서 열려 있음</translation>
    </message>
    <message>
        <source>%1 is open in another studio.</source>
        <translation>%1이(가) 다른 스튜디오에서 열려 있습니다.</translation>
    </message>
    <message>
        <source>A copy can be changed and saved under another name. Taking over, you save into this file, and so may the other.</source>
        <translation>사본은 고쳐서 다른 이름으로 저장할 수 있습니다. 넘겨받으면 이 파일에 저장하며, 다른 쪽도 여기에 저장할 수 있습니다.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>사본 열기</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>넘겨받기</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 여는 중</translation>
    </message>
    <message>
        <source>Found in %1</source>
        <translation>%1에서 발견</translation>
    </message>
    <message>
        <source>Making the demo bout</source>
        <translation>데모 대련 만드는 중</translation>
    </message>
    <message>
        <source>The demo bout: two made fighters. Save it to keep what you change.</source>
        <translation>데모 대련: 만들어진 두 선수. 바꾼 내용을 남기려면 저장하세요.</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1 복구 중</translation>
    </message>
    <message>
        <source>Found while recovering</source>
        <translation>복구하면서 발견</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 읽는 중</translation>
    </message>
    <message>
        <source>Found in the recordings</source>
        <translation>녹화에서 발견</translation>
    </message>
    <message>
        <source>Open one or two recordings</source>
        <translation>녹화 한두 개 열기</translation>
    </message>
    <message>
        <source>Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)</source>
        <translation>녹화 (*.bvh *.BVH *.amc *.AMC);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>프로젝트 열기</translation>
    </message>
    <message>
        <source>Kumite projects (*.kumite)</source>
        <translation>Kumite 프로젝트 (*.kumite)</translation>
    </message>
    <message>
        <source>Where is %1 of %2?</source>
        <translation>%2의 %1은(는) 어디에 있나요?</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>프로젝트 저장</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 저장 중</translation>
    </message>
    <message>
        <source>Found while saving</source>
        <translation>저장하면서 발견</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1을(를) 저장했습니다.</translation>
    </message>
    <message>
        <source>Save all the same</source>
        <translation>그래도 저장</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>다른 이름으로 저장…</translation>
    </message>
    <message>
        <source>Changed on the disk</source>
        <translation>디스크에서 변경됨</translation>
    </message>
    <message>
        <source>%1 was changed outside this window since you opened it.</source>
        <translation>%1을(를) 연 뒤에 이 창 밖에서 바뀌었습니다.</translation>
    </message>
    <message>
        <source>It was written %1. If you save over it, what it holds now is kept as a version.</source>
        <translation>%1에 기록되었습니다. 덮어써도 지금 내용은 버전으로 남습니다.</translation>
    </message>
    <message>
        <source>Save over it</source>
        <translation>덮어쓰기</translation>
    </message>
    <message>
        <source>Export the actions of this take</source>
        <translation>이 테이크의 동작 내보내기</translation>
    </message>
    <message>
        <source>Table of actions (*.csv);;Segmentation (*.json)</source>
        <translation>동작 표 (*.csv);;분할 (*.json)</translation>
    </message>
    <message>
        <source>Export the motion of this take</source>
        <translation>이 테이크의 모션 내보내기</translation>
    </message>
    <message>
        <source>Motion, one file per fighter (*.bvh)</source>
        <translation>모션, 선수마다 파일 하나 (*.bvh)</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 내보내는 중</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1을(를) 내보냈습니다.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> 및 </translation>
    </message>
    <message>
        <source>Reading the version of %1</source>
        <translation>%1 버전 읽는 중</translation>
    </message>
    <message>
        <source>Found in the version</source>
        <translation>버전에서 발견</translation>
    </message>
    <message>
        <source>Restored the version of %1; Ctrl+Z takes it back.</source>
        <translation>%1 버전을 복원했습니다. Ctrl+Z로 되돌립니다.</translation>
    </message>
    <message>
        <source>That version is what is open.</source>
        <translation>이미 열려 있는 버전입니다.</translation>
    </message>
    <message>
        <source>The version of %1 is open as a copy.</source>
        <translation>%1 버전을 사본으로 열었습니다.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>저장하지 않은 변경</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>%1의 변경 내용을 저장할까요?</translation>
    </message>
    <message>
        <source>What is not saved is lost.</source>
        <translation>저장하지 않은 내용은 사라집니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FindBox</name>
    <message>
        <source>Actions found</source>
        <translation>찾은 동작</translation>
    </message>
    <message>
        <source>right kick up, machine, below 0.6</source>
        <translation>예: right kick up, machine, below 0.6</translation>
    </message>
    <message>
        <source>Find actions</source>
        <translation>동작 찾기</translation>
    </message>
    <message>
        <source>Aspects and qualifiers (kick, right punch fwd, jump none), who said it (by hand, machine, rule), how surely (uncertain, below 0.6), which fighter or take, when (after 1:20, longer than 1 s), unlabelled. All must hold; &quot;or&quot; joins two, &quot;not&quot; turns one round. Source and confidence are those of the aspects that are named.</source>
        <translation>측면과 수식어(kick, right punch fwd, jump none), 출처(by hand, machine, rule), 확신도(uncertain, below 0.6), 선수나 테이크, 시간(after 1:20, longer than 1 s), unlabelled. 모두 맞아야 합니다. &quot;or&quot;는 둘을 잇고 &quot;not&quot;은 하나를 뒤집습니다. 출처와 확신도는 적어 넣은 측면의 것입니다.</translation>
    </message>
    <message>
        <source>What was understood</source>
        <translation>해석 결과</translation>
    </message>
    <message>
        <source>Choose all that were found in this take: the next label goes to all of them, as one step</source>
        <translation>이 테이크에서 찾은 것을 모두 선택합니다. 다음 레이블이 한 단계로 모두에 붙습니다</translation>
    </message>
    <message>
        <source>1 action</source>
        <translation>동작 1개</translation>
    </message>
    <message>
        <source>%1 actions</source>
        <translation>동작 %1개</translation>
    </message>
    <message>
        <source>Choose all %1</source>
        <translation>%1개 모두 선택</translation>
    </message>
    <message>
        <source>The actions of the bout appear here once a recording is cut.</source>
        <translation>녹화를 분할하면 대련의 동작이 여기에 나타납니다.</translation>
    </message>
    <message>
        <source>No action is like that.</source>
        <translation>그런 동작이 없습니다.</translation>
    </message>
    <message>
        <source>Choose all</source>
        <translation>모두 선택</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FindingsPage</name>
    <message>
        <source>Findings in the recordings</source>
        <translation>녹화의 발견 사항</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>이 페이지 닫기 (Esc)</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>경고</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>참고</translation>
    </message>
    <message>
        <source>What is odd or worth knowing about the recordings of a project is listed here. There is nothing.</source>
        <translation>프로젝트의 녹화에서 이상하거나 알아 둘 만한 것이 여기에 나열됩니다. 지금은 없습니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FoundModel</name>
    <message>
        <source>%1, %2: %3, %4</source>
        <translation>%1, %2: %3, %4</translation>
    </message>
    <message>
        <source>, p %1</source>
        <translation>, p %1</translation>
    </message>
    <message>
        <source>Who says it; of several aspects the least sure</source>
        <translation>출처. 측면이 여럿이면 확신이 가장 낮은 것</translation>
    </message>
    <message>
        <source>Confidence; of several aspects the least</source>
        <translation>확신도. 측면이 여럿이면 가장 낮은 값</translation>
    </message>
    <message>
        <source>time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>label</source>
        <translation>레이블</translation>
    </message>
    <message>
        <source>by</source>
        <translation>출처</translation>
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
        <translation>행렬</translation>
    </message>
    <message>
        <source>Transitions as a matrix (V)</source>
        <translation>전이를 행렬로 보기 (V)</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>그래프</translation>
    </message>
    <message>
        <source>Transitions as circles and edges (V)</source>
        <translation>전이를 원과 간선으로 보기 (V)</translation>
    </message>
    <message>
        <source>What %1 does next (Tab)</source>
        <translation>%1의 다음 동작 (Tab)</translation>
    </message>
    <message>
        <source>compared with nothing</source>
        <translation>비교 안 함</translation>
    </message>
    <message>
        <source>with the other fighter</source>
        <translation>다른 선수와 비교</translation>
    </message>
    <message>
        <source>with labels by hand alone</source>
        <translation>수동 레이블만과 비교</translation>
    </message>
    <message>
        <source>with EQU7</source>
        <translation>EQU7과 비교</translation>
    </message>
    <message>
        <source>with EQU6</source>
        <translation>EQU6과 비교</translation>
    </message>
    <message>
        <source>with EQU5</source>
        <translation>EQU5와 비교</translation>
    </message>
    <message>
        <source>What it is compared with</source>
        <translation>비교 대상</translation>
    </message>
    <message>
        <source>Compares with another, side by side or as a difference</source>
        <translation>다른 것과 나란히 또는 차이로 비교합니다</translation>
    </message>
    <message>
        <source>What each fighter tends to do next</source>
        <translation>각 선수가 다음에 주로 하는 동작</translation>
    </message>
    <message>
        <source>Why nothing is shown</source>
        <translation>아무것도 표시되지 않는 이유</translation>
    </message>
    <message>
        <source>Transitions are being learnt from the labels.</source>
        <translation>레이블에서 전이를 학습하고 있습니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphCommands</name>
    <message>
        <source>Export transitions</source>
        <translation>전이 내보내기</translation>
    </message>
    <message>
        <source>Edges as a table (*.csv);;Graph and model (*.json);;Graph (*.graphml);;Picture (*.png);;Picture of lines (*.svg)</source>
        <translation>간선 표 (*.csv);;그래프와 모델 (*.json);;그래프 (*.graphml);;그림 (*.png);;벡터 그림 (*.svg)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>저장함: %1</translation>
    </message>
    <message>
        <source>&amp;Graph</source>
        <translation>그래프(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Matrix or graph</source>
        <translation>행렬 또는 그래프(&amp;M)</translation>
    </message>
    <message>
        <source>Graph in &amp;space</source>
        <translation>공간 그래프(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Play what is behind it, the next each time</source>
        <translation>근거 장면을 차례로 재생(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next surprise</source>
        <translation>다음 의외 지점(&amp;N)</translation>
    </message>
    <message>
        <source>Pre&amp;vious surprise</source>
        <translation>이전 의외 지점(&amp;V)</translation>
    </message>
    <message>
        <source>Surprise of bo&amp;th terms</source>
        <translation>두 항의 의외도(&amp;T)</translation>
    </message>
    <message>
        <source>S&amp;urprise of the label term</source>
        <translation>레이블 항의 의외도(&amp;D)</translation>
    </message>
    <message>
        <source>Su&amp;rprise of the geometry term</source>
        <translation>기하 항의 의외도(&amp;F)</translation>
    </message>
    <message>
        <source>Rows by &amp;own label</source>
        <translation>자기 레이블별 행(&amp;O)</translation>
    </message>
    <message>
        <source>Ro&amp;ws by opponent&apos;s label</source>
        <translation>상대 레이블별 행(&amp;H)</translation>
    </message>
    <message>
        <source>Rows by &amp;both labels</source>
        <translation>두 레이블별 행(&amp;B)</translation>
    </message>
    <message>
        <source>Sort by &amp;count</source>
        <translation>횟수순 정렬(&amp;C)</translation>
    </message>
    <message>
        <source>Sort by n&amp;ame</source>
        <translation>이름순 정렬(&amp;A)</translation>
    </message>
    <message>
        <source>Sort by &amp;likeness</source>
        <translation>유사도순 정렬(&amp;L)</translation>
    </message>
    <message>
        <source>Lar&amp;ger cells</source>
        <translation>셀 크게(&amp;G)</translation>
    </message>
    <message>
        <source>Smaller cells</source>
        <translation>셀 작게</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>전체 보기(&amp;E)</translation>
    </message>
    <message>
        <source>E&amp;xport transitions…</source>
        <translation>전이 내보내기(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphExport</name>
    <message>
        <source>Transitions</source>
        <translation>전이</translation>
    </message>
    <message>
        <source>%1: the name must end in .csv, .json, .graphml, .png or .svg.</source>
        <translation>%1: 이름은 .csv, .json, .graphml, .png 또는 .svg로 끝나야 합니다.</translation>
    </message>
    <message>
        <source>%1: it cannot be written there.</source>
        <translation>%1: 그곳에는 쓸 수 없습니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphPanel</name>
    <message>
        <source>What a fighter does next, given what both are doing, and the moments of the recording behind each probability appear here.</source>
        <translation>두 선수가 지금 하는 동작에 따라 다음에 무엇을 하는지, 그리고 각 확률의 근거가 된 녹화 장면이 여기에 나타납니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphSession</name>
    <message>
        <source>%1: more often</source>
        <translation>%1: 더 자주</translation>
    </message>
    <message>
        <source>others</source>
        <translation>기타</translation>
    </message>
    <message>
        <source>label</source>
        <translation>레이블</translation>
    </message>
    <message>
        <source>geometry</source>
        <translation>기하</translation>
    </message>
    <message>
        <source>both</source>
        <translation>둘 다</translation>
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
        <translation>의외도 %1 (모션을 본 뒤 %2): 레이블 %3 (%4), 기하 %5</translation>
    </message>
    <message>
        <source>Learning transitions</source>
        <translation>전이 학습 중</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>아무거나</translation>
    </message>
    <message>
        <source>all labels</source>
        <translation>모든 레이블</translation>
    </message>
    <message>
        <source>labels by hand</source>
        <translation>수동 레이블</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphView</name>
    <message>
        <source>Graph of transitions</source>
        <translation>전이 그래프</translation>
    </message>
    <message>
        <source>A node is a label, an edge leads to what follows. A click shows the moments behind it.</source>
        <translation>노드는 레이블, 간선은 뒤따르는 것으로 이어집니다. 클릭하면 근거가 된 장면이 보입니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Help</name>
    <message>
        <source>&amp;Help on this workspace</source>
        <translation>이 작업 공간의 도움말(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>첫걸음(&amp;F)</translation>
    </message>
    <message>
        <source>What the &amp;numbers mean</source>
        <translation>숫자의 의미(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;What is this? Click on it</source>
        <translation>이것은 무엇인가요? 클릭해 보세요(&amp;W)</translation>
    </message>
    <message>
        <source>What has the f&amp;ocus?</source>
        <translation>포커스가 있는 것은 무엇인가요?(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>단축키와 마우스(&amp;K)</translation>
    </message>
    <message>
        <source>What is n&amp;ew</source>
        <translation>새로운 기능(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;About Kumite</source>
        <translation>Kumite 정보(&amp;A)</translation>
    </message>
    <message>
        <source>About Kumite</source>
        <translation>Kumite 정보</translation>
    </message>
    <message>
        <source>Kumite %1

A studio for annotating two-player martial-arts motion capture.</source>
        <translation>Kumite %1

2인 무술 모션 캡처에 주석을 다는 스튜디오.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HelpWindow</name>
    <message>
        <source>The page before</source>
        <translation>이전 페이지</translation>
    </message>
    <message>
        <source>On again</source>
        <translation>다시 앞으로</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>도움말</translation>
    </message>
    <message>
        <source>Close the help (Esc)</source>
        <translation>도움말 닫기 (Esc)</translation>
    </message>
    <message>
        <source>Search all pages</source>
        <translation>모든 페이지 검색</translation>
    </message>
    <message>
        <source>Shows the pages that hold all of these words. Return: the next place; Shift+Return: the one before. (Ctrl+F)</source>
        <translation>이 낱말이 모두 있는 페이지를 표시합니다. Return: 다음 위치, Shift+Return: 이전 위치. (Ctrl+F)</translation>
    </message>
    <message>
        <source>How often the words were found</source>
        <translation>낱말을 찾은 횟수</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>목차</translation>
    </message>
    <message>
        <source>The pages of the help</source>
        <translation>도움말 페이지</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>페이지</translation>
    </message>
    <message>
        <source>Tab leads from link to link, Return follows one.</source>
        <translation>Tab으로 링크 사이를 옮기고 Return으로 링크를 따라갑니다.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Found %1 times on this page</source>
        <translation>이 페이지에서 %1번 찾음</translation>
    </message>
    <message>
        <source>Show this page</source>
        <translation>이 페이지 보기</translation>
    </message>
    <message>
        <source>No page holds these words.</source>
        <translation>이 낱말이 있는 페이지가 없습니다.</translation>
    </message>
    <message>
        <source>%1 of %2 on this page</source>
        <translation>이 페이지에서 %1 / %2</translation>
    </message>
    <message>
        <source>%1 — Help</source>
        <translation>%1 — 도움말</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HistoryModel</name>
    <message>
        <source>%1
The project as it is now.</source>
        <translation>%1
현재의 프로젝트입니다.</translation>
    </message>
    <message>
        <source>%1
Click to go back to this state.</source>
        <translation>%1
클릭하면 이 상태로 돌아갑니다.</translation>
    </message>
    <message>
        <source>%1
Undone. Click to redo up to here.</source>
        <translation>%1
실행 취소됨. 클릭하면 여기까지 다시 실행합니다.</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, 실행 취소됨</translation>
    </message>
    <message>
        <source>%1, now</source>
        <translation>%1, 현재</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HitBox</name>
    <message>
        <source>Hit a target</source>
        <translation>표적 맞히기</translation>
    </message>
    <message>
        <source>Drag the target in the 3D view: the strike follows it. Dots: where whole examples hit; the box: what is reached.</source>
        <translation>3D 보기에서 표적을 끌면 타격이 따라갑니다. 점: 예제 전체가 맞히는 곳, 상자: 닿는 범위.</translation>
    </message>
    <message>
        <source>Strike</source>
        <translation>타격</translation>
    </message>
    <message>
        <source>Which strike; its examples are the actions with that label</source>
        <translation>어느 타격인지. 그 레이블이 붙은 동작이 예가 됩니다</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>한 지점</translation>
    </message>
    <message>
        <source>Aim at</source>
        <translation>겨냥</translation>
    </message>
    <message>
        <source>A place in space, or the opponent as the recording&apos;s playhead shows it; a click on its marks in the 3D view aims there</source>
        <translation>공간의 한 지점, 또는 재생 위치에 보이는 상대. 3D 보기의 표시를 클릭하면 그곳을 겨냥합니다</translation>
    </message>
    <message>
        <source>Distance of the opponent, metres</source>
        <translation>상대까지의 거리, 미터</translation>
    </message>
    <message>
        <source>How far ahead the opponent stands, from pelvis to pelvis</source>
        <translation>상대가 앞으로 얼마나 떨어져 서 있는지, 골반에서 골반까지</translation>
    </message>
    <message>
        <source>Away, m</source>
        <translation>거리, m</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>왼쪽으로</translation>
    </message>
    <message>
        <source>up</source>
        <translation>위로</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>앞으로</translation>
    </message>
    <message>
        <source>Target, metres %1</source>
        <translation>표적(미터), %1</translation>
    </message>
    <message>
        <source>Target, m</source>
        <translation>표적, m</translation>
    </message>
    <message>
        <source>How well it is hit</source>
        <translation>명중 정도</translation>
    </message>
    <message>
        <source>The strikes are being aligned.</source>
        <translation>타격을 정렬하고 있습니다.</translation>
    </message>
    <message>
        <source>A blend of whole examples reaches it.</source>
        <translation>예 전체를 혼합해 닿습니다.</translation>
    </message>
    <message>
        <source>No blend of whole examples reaches it: parts of the body are blended and turned.</source>
        <translation>예 전체를 혼합해서는 닿지 않아 몸의 부분을 혼합하고 돌립니다.</translation>
    </message>
    <message>
        <source>It is outside of the box that is reached.</source>
        <translation>닿을 수 있는 상자 밖에 있습니다.</translation>
    </message>
    <message>
        <source>Hit, %1 cm off. %2 %3 examples.</source>
        <translation>명중, 오차 %1 cm. %2 예 %3개.</translation>
    </message>
    <message>
        <source>Missed by %1 cm: the nearest that can be reached. %2 %3 examples.</source>
        <translation>%1 cm 빗나감: 닿을 수 있는 가장 가까운 곳입니다. %2 예 %3개.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HitSession</name>
    <message>
        <source>Aim at the opponent</source>
        <translation>상대를 겨냥</translation>
    </message>
    <message>
        <source>Aim at a place</source>
        <translation>한 지점을 겨냥</translation>
    </message>
    <message>
        <source>Opponent %1 m away</source>
        <translation>상대를 %1 m 앞에</translation>
    </message>
    <message>
        <source>Strike with %1</source>
        <translation>타격: %1</translation>
    </message>
    <message>
        <source>Aligning the strikes</source>
        <translation>타격 정렬 중</translation>
    </message>
    <message>
        <source>Move the target</source>
        <translation>표적 이동</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ImportDialog</name>
    <message>
        <source>Open recordings</source>
        <translation>녹화 열기</translation>
    </message>
    <message>
        <source>Not read. Choose the file again to read it.</source>
        <translation>읽지 않았습니다. 읽으려면 파일을 다시 고르세요.</translation>
    </message>
    <message>
        <source>Choose a recording</source>
        <translation>녹화 고르기</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>읽는 중…</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>읽는 중</translation>
    </message>
    <message>
        <source>Start, place and floor of %1 must be numbers, such as 0.25.</source>
        <translation>%1의 시작, 위치, 바닥은 0.25 같은 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>Choose a recording for fighter 1.</source>
        <translation>선수 1의 녹화를 고르세요.</translation>
    </message>
    <message>
        <source>The rate must be a positive number of frames per second, such as 60.</source>
        <translation>프레임 속도는 60처럼 초당 프레임 수를 나타내는 양수여야 합니다.</translation>
    </message>
    <message>
        <source>Frames read begin:end, such as 120:900; either may be left out.</source>
        <translation>프레임은 120:900처럼 시작:끝으로 적습니다. 한쪽은 비울 수 있습니다.</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>찾는 중</translation>
    </message>
    <message>
        <source>Roles, %1 missing</source>
        <translation>역할, %1개 없음</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>역할</translation>
    </message>
    <message>
        <source>&lt;b&gt;Check:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;확인:&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>%1 (found)</source>
        <translation>%1 (찾음)</translation>
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
        <translation>찾은 대로</translation>
    </message>
    <message>
        <source>%1:%2 of %3</source>
        <translation>%1:%2 / %3</translation>
    </message>
    <message>
        <source>Hz; header: %1</source>
        <translation>Hz, 헤더: %1</translation>
    </message>
    <message>
        <source> and </source>
        <translation> 및 </translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>begin:end</source>
        <translation>시작:끝</translation>
    </message>
    <message>
        <source>Fighter %1</source>
        <translation>선수 %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>녹화</translation>
    </message>
    <message>
        <source>Path of the recording; the button beside it, or a drop, chooses one</source>
        <translation>녹화의 경로. 옆의 버튼을 누르거나 파일을 끌어다 놓아 고릅니다</translation>
    </message>
    <message>
        <source>a .bvh or .amc file</source>
        <translation>.bvh 또는 .amc 파일</translation>
    </message>
    <message>
        <source>none: a single fighter</source>
        <translation>없음: 선수 한 명</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>골격</translation>
    </message>
    <message>
        <source>Which skeleton of a file that holds several</source>
        <translation>골격이 여럿인 파일에서 어느 골격인지</translation>
    </message>
    <message>
        <source>ASF skeleton</source>
        <translation>ASF 골격</translation>
    </message>
    <message>
        <source>the one beside it</source>
        <translation>옆에 있는 파일</translation>
    </message>
    <message>
        <source>The .asf file that belongs to the .amc</source>
        <translation>.amc에 딸린 .asf 파일</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>길이 단위</translation>
    </message>
    <message>
        <source>What one unit of the file is</source>
        <translation>파일의 1단위가 나타내는 길이</translation>
    </message>
    <message>
        <source>found</source>
        <translation>찾음</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>위쪽 축</translation>
    </message>
    <message>
        <source>The file&apos;s axis that points up</source>
        <translation>파일에서 위를 가리키는 축</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>Seconds on the take&apos;s clock at which its first frame stands</source>
        <translation>첫 프레임이 놓이는 테이크 시각(초)</translation>
    </message>
    <message>
        <source>Place x</source>
        <translation>위치 x</translation>
    </message>
    <message>
        <source>Metres along x from where the file stands</source>
        <translation>파일의 위치에서 x 방향 거리(미터)</translation>
    </message>
    <message>
        <source>Place z</source>
        <translation>위치 z</translation>
    </message>
    <message>
        <source>Metres along z from where the file stands</source>
        <translation>파일의 위치에서 z 방향 거리(미터)</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>Degrees about the vertical, about the file&apos;s origin</source>
        <translation>파일의 원점을 지나는 수직축 둘레의 각도</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>바닥</translation>
    </message>
    <message>
        <source>Height of the floor in the file, metres</source>
        <translation>파일에서 바닥의 높이(미터)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>고르기…</translation>
    </message>
    <message>
        <source>Choose the recording of %1</source>
        <translation>%1의 녹화 고르기</translation>
    </message>
    <message>
        <source>BVH, or AMC with its ASF; others go through Blender</source>
        <translation>BVH 또는 ASF가 딸린 AMC. 그 밖은 Blender를 거칩니다</translation>
    </message>
    <message>
        <source>Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)</source>
        <translation>녹화 (*.bvh *.BVH *.amc *.AMC);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>S&amp;wap</source>
        <translation>맞바꾸기(&amp;W)</translation>
    </message>
    <message>
        <source>Swap fighters</source>
        <translation>선수 맞바꾸기</translation>
    </message>
    <message>
        <source>Fighter 1 becomes fighter 2, with all that is said of them (Alt+W)</source>
        <translation>선수 1이 모든 설정과 함께 선수 2가 됩니다 (Alt+W)</translation>
    </message>
    <message>
        <source>Take name</source>
        <translation>테이크 이름</translation>
    </message>
    <message>
        <source>How the take is called in the project</source>
        <translation>프로젝트에서 쓰는 테이크 이름</translation>
    </message>
    <message>
        <source>Rate in Hz</source>
        <translation>프레임 속도(Hz)</translation>
    </message>
    <message>
        <source>as the header</source>
        <translation>헤더대로</translation>
    </message>
    <message>
        <source>True frame rate, where the header is wrong: the preview shows it</source>
        <translation>헤더가 틀렸을 때의 실제 프레임 속도. 미리 보기에서 확인할 수 있습니다</translation>
    </message>
    <message>
        <source>Frames, begin:end</source>
        <translation>프레임, 시작:끝</translation>
    </message>
    <message>
        <source>Frames of the files; the end is the first frame left out. Empty: all, without a leading T-pose.</source>
        <translation>파일의 프레임. 끝 프레임은 포함하지 않습니다. 비우면 앞의 T 포즈를 뺀 전체.</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>테이크</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>속도</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>ASF file</source>
        <translation>ASF 파일</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>Starts at, s</source>
        <translation>시작, s</translation>
    </message>
    <message>
        <source>Place x, m</source>
        <translation>위치 x, m</translation>
    </message>
    <message>
        <source>Place z, m</source>
        <translation>위치 z, m</translation>
    </message>
    <message>
        <source>Turned, °</source>
        <translation>회전, °</translation>
    </message>
    <message>
        <source>Floor, m</source>
        <translation>바닥, m</translation>
    </message>
    <message>
        <source>Add as a take to %1</source>
        <translation>%1에 테이크로 추가</translation>
    </message>
    <message>
        <source>Otherwise it becomes a project of its own</source>
        <translation>끄면 별도의 프로젝트가 됩니다</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>재생(&amp;P)</translation>
    </message>
    <message>
        <source>Play or pause (Space in the preview, Alt+P)</source>
        <translation>재생 또는 일시 정지 (미리 보기에서 Space, Alt+P)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>일시 정지(&amp;P)</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>미리 보기</translation>
    </message>
    <message>
        <source>What was found in the recordings</source>
        <translation>녹화에서 발견한 것</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Open nothing (Esc)</source>
        <translation>아무것도 열지 않음 (Esc)</translation>
    </message>
    <message>
        <source>Open bout</source>
        <translation>대련 열기</translation>
    </message>
    <message>
        <source>Make a take of these recordings (Enter)</source>
        <translation>이 녹화로 테이크 만들기 (Enter)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ImportPreview</name>
    <message>
        <source>Preview of both fighters</source>
        <translation>두 선수 미리 보기</translation>
    </message>
    <message>
        <source>From above, from the side, and their distance over time</source>
        <translation>위에서, 옆에서, 그리고 시간에 따른 거리</translation>
    </message>
    <message>
        <source>Space plays, ← → steps, a drag on the distance scrubs</source>
        <translation>Space 재생, ← → 한 프레임씩, 거리 곡선을 끌어 탐색</translation>
    </message>
    <message>
        <source>from above, grid %1 m</source>
        <translation>위에서, 격자 %1 m</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>옆에서</translation>
    </message>
    <message>
        <source>%1   distance %2 m</source>
        <translation>%1   거리 %2 m</translation>
    </message>
    <message>
        <source>distance of the pelvises, m</source>
        <translation>골반 사이 거리, m</translation>
    </message>
    <message>
        <source>Both fighters move here once their recordings are read. Choose them above, or drop them here.</source>
        <translation>녹화를 읽으면 두 선수가 여기서 움직입니다. 위에서 고르거나 여기에 끌어다 놓으세요.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JobBar</name>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>진행률</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JobRunner</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>메모리가 부족합니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JointBox</name>
    <message>
        <source>Joint</source>
        <translation>관절</translation>
    </message>
    <message>
        <source>Joint to turn</source>
        <translation>돌릴 관절</translation>
    </message>
    <message>
        <source>Which joint has rings in the 3D view; J chooses the next one</source>
        <translation>3D 보기에서 고리가 달리는 관절. J가 다음 것을 고릅니다</translation>
    </message>
    <message>
        <source>Turn about %1, degrees</source>
        <translation>%1축 회전, 도</translation>
    </message>
    <message>
        <source>About the parent&apos;s %1, degrees; turned about y first, then x, then z</source>
        <translation>부모의 %1축을 중심으로, 도. 먼저 y, 다음 x, 다음 z로 돌립니다</translation>
    </message>
    <message>
        <source>x y z, °</source>
        <translation>x y z, °</translation>
    </message>
    <message>
        <source>How much of the joint&apos;s limits that takes</source>
        <translation>관절 한계를 얼마나 쓰는지</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Bent by %1° of %2°, twisted by %3° of %4° from rest.</source>
        <translation>굽힘 %1°(한계 %2°), 비틀림 %3°(한계 %4°).</translation>
    </message>
    <message>
        <source>This joint has no limits.</source>
        <translation>이 관절에는 한계가 없습니다.</translation>
    </message>
    <message>
        <source>A chosen joint has rings in the 3D view: drag one to turn it.</source>
        <translation>고른 관절에는 3D 보기에서 고리가 달립니다. 끌어서 돌리세요.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyBar</name>
    <message>
        <source>Time of the keys</source>
        <translation>키의 시간</translation>
    </message>
    <message>
        <source>the strike</source>
        <translation>타격</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>프레임 %1</translation>
    </message>
    <message>
        <source> · the motion</source>
        <translation> · 모션</translation>
    </message>
    <message>
        <source> · the keys</source>
        <translation> · 키</translation>
    </message>
    <message>
        <source> · beside it without adjustment</source>
        <translation> · 옆에 조정 없는 것</translation>
    </message>
    <message>
        <source> · out of reach by %1 cm</source>
        <translation> · %1 cm 모자라 닿지 않음</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyCommands</name>
    <message>
        <source>Ke&amp;yframe</source>
        <translation>키프레임(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>재생 또는 일시 정지(&amp;P)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>한 프레임 뒤로</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>한 프레임 앞으로</translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation>열 프레임 뒤로</translation>
    </message>
    <message>
        <source>Ten frames on</source>
        <translation>열 프레임 앞으로</translation>
    </message>
    <message>
        <source>To the first key</source>
        <translation>첫 키로</translation>
    </message>
    <message>
        <source>To the last key</source>
        <translation>마지막 키로</translation>
    </message>
    <message>
        <source>Show the &amp;motion instead of the keys</source>
        <translation>키 대신 모션 보기(&amp;M)</translation>
    </message>
    <message>
        <source>Beside it the motion without a&amp;djustment</source>
        <translation>조정 없는 움직임을 옆에(&amp;D)</translation>
    </message>
    <message>
        <source>Keys before and after as &amp;ghosts</source>
        <translation>앞뒤 키를 잔상으로(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Hit a target</source>
        <translation>표적 맞히기(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Add a key here</source>
        <translation>여기에 키 추가(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove the key</source>
        <translation>키 제거(&amp;R)</translation>
    </message>
    <message>
        <source>Key before</source>
        <translation>이전 키</translation>
    </message>
    <message>
        <source>Key after</source>
        <translation>다음 키</translation>
    </message>
    <message>
        <source>Move the key earlier</source>
        <translation>키를 앞당기기</translation>
    </message>
    <message>
        <source>Move the key later</source>
        <translation>키를 늦추기</translation>
    </message>
    <message>
        <source>Move the key and later ones earlier</source>
        <translation>이 키와 뒤의 키를 더 일찍</translation>
    </message>
    <message>
        <source>Move the key and later ones later</source>
        <translation>이 키와 뒤의 키를 더 늦게</translation>
    </message>
    <message>
        <source>Later keys closer together</source>
        <translation>뒤의 키를 더 촘촘히</translation>
    </message>
    <message>
        <source>Later keys farther apart</source>
        <translation>뒤의 키를 더 멀리</translation>
    </message>
    <message>
        <source>&amp;Copy the key to the playhead, or behind the last</source>
        <translation>키를 재생 헤드나 마지막 키 뒤에 복사(&amp;C)</translation>
    </message>
    <message>
        <source>M&amp;irror the pose</source>
        <translation>포즈 좌우 뒤집기(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Take the pose that the recording shows</source>
        <translation>녹화에 보이는 포즈 쓰기(&amp;T)</translation>
    </message>
    <message>
        <source>Copy the pose from an&amp;y take or clip…</source>
        <translation>테이크나 클립에서 포즈 복사(&amp;Y)…</translation>
    </message>
    <message>
        <source>The handle &amp;stays where it is, or not</source>
        <translation>핸들 제자리 고정 또는 해제(&amp;S)</translation>
    </message>
    <message>
        <source>Next handle</source>
        <translation>다음 핸들</translation>
    </message>
    <message>
        <source>Next &amp;joint to turn</source>
        <translation>다음으로 돌릴 관절(&amp;J)</translation>
    </message>
    <message>
        <source>Joint before</source>
        <translation>이전 관절</translation>
    </message>
    <message>
        <source>Handle up</source>
        <translation>핸들 위로</translation>
    </message>
    <message>
        <source>Handle down</source>
        <translation>핸들 아래로</translation>
    </message>
    <message>
        <source>Handle toward −x</source>
        <translation>핸들 −x 쪽으로</translation>
    </message>
    <message>
        <source>Handle toward +x</source>
        <translation>핸들 +x 쪽으로</translation>
    </message>
    <message>
        <source>Handle toward −z</source>
        <translation>핸들 −z 쪽으로</translation>
    </message>
    <message>
        <source>Handle toward +z</source>
        <translation>핸들 +z 쪽으로</translation>
    </message>
    <message>
        <source>The body from anywhere again</source>
        <translation>몸을 다시 아무 데서나</translation>
    </message>
    <message>
        <source>Take the body from anywhere</source>
        <translation>몸을 아무 데서나 가져오기</translation>
    </message>
    <message>
        <source>Remove all keys</source>
        <translation>모든 키 제거</translation>
    </message>
    <message>
        <source>Add clips of &amp;files…</source>
        <translation>파일의 클립 추가(&amp;F)…</translation>
    </message>
    <message>
        <source>Add cl&amp;ips of a folder…</source>
        <translation>폴더의 클립 추가(&amp;H)…</translation>
    </message>
    <message>
        <source>R&amp;eplace a part of a take…</source>
        <translation>테이크의 일부 교체(&amp;B)…</translation>
    </message>
    <message>
        <source>&amp;Keep as a take…</source>
        <translation>테이크로 보관(&amp;K)…</translation>
    </message>
    <message>
        <source>E&amp;xport the motion…</source>
        <translation>모션 내보내기(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyEditor</name>
    <message>
        <source>Remove keys</source>
        <translation>단축키 제거</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>초기화</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>모든 단축키 초기화</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>명령 검색</translation>
    </message>
    <message>
        <source>Shows the commands whose name, menu or key holds these letters.</source>
        <translation>이름, 메뉴 또는 단축키에 이 글자가 있는 명령을 표시합니다.</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>명령과 단축키</translation>
    </message>
    <message>
        <source>Choose a command, then press its key in the field below</source>
        <translation>명령을 고른 다음 아래 칸에서 단축키를 누르세요</translation>
    </message>
    <message>
        <source>command</source>
        <translation>명령</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>메뉴</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>단축키</translation>
    </message>
    <message>
        <source>The chosen command gets the key in the field.</source>
        <translation>고른 명령에 칸의 단축키를 줍니다.</translation>
    </message>
    <message>
        <source>The chosen command is run from menus and the palette only.</source>
        <translation>고른 명령은 메뉴와 팔레트에서만 실행됩니다.</translation>
    </message>
    <message>
        <source>The chosen command gets back the keys that the studio brings.</source>
        <translation>고른 명령의 단축키를 스튜디오 기본값으로 되돌립니다.</translation>
    </message>
    <message>
        <source>All commands get back the keys that the studio brings.</source>
        <translation>모든 명령의 단축키를 스튜디오 기본값으로 되돌립니다.</translation>
    </message>
    <message>
        <source>Your own; the studio brings: %1</source>
        <translation>사용자 지정. 스튜디오 기본값: %1</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>지정</translation>
    </message>
    <message>
        <source>Choose a command to give it another key.</source>
        <translation>단축키를 바꿀 명령을 고르세요.</translation>
    </message>
    <message>
        <source>Press the new key for “%1” in the field.</source>
        <translation>칸에서 “%1”의 새 단축키를 누르세요.</translation>
    </message>
    <message>
        <source>%1 is its key already.</source>
        <translation>%1은(는) 이미 이 명령의 단축키입니다.</translation>
    </message>
    <message>
        <source>%1 is free.</source>
        <translation>%1은(는) 비어 있습니다.</translation>
    </message>
    <message>
        <source>Take it over</source>
        <translation>가져오기</translation>
    </message>
    <message>
        <source>%1 is the key of %2. Taking it over leaves that command without it.</source>
        <translation>%1은(는) %2의 단축키입니다. 가져오면 그 명령에는 단축키가 없어집니다.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> 및 </translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyField</name>
    <message>
        <source>Press a key</source>
        <translation>키를 누르세요</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>새 단축키</translation>
    </message>
    <message>
        <source>Press the key here, alone or with Ctrl, Shift, Alt; then Tab goes on, and Shift+Tab always goes back</source>
        <translation>여기서 키를 단독으로 또는 Ctrl, Shift, Alt와 함께 누르세요. 그런 다음 Tab으로 나아가고 Shift+Tab으로 언제나 돌아갑니다</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyPanel</name>
    <message>
        <source>What appears here</source>
        <translation>여기에 나타나는 것</translation>
    </message>
    <message>
        <source>Key pose</source>
        <translation>키 포즈</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>모션</translation>
    </message>
    <message>
        <source>Hit a target</source>
        <translation>표적 맞히기</translation>
    </message>
    <message>
        <source>A strike of the takes and clips that follows a target, instead of keys</source>
        <translation>키 대신, 표적을 따라가는 테이크와 클립의 타격</translation>
    </message>
    <message>
        <source>Back to the keys</source>
        <translation>키로 돌아가기</translation>
    </message>
    <message>
        <source>Sho&amp;w the key pose</source>
        <translation>키 포즈 표시(&amp;E)</translation>
    </message>
    <message>
        <source>Show the motio&amp;n</source>
        <translation>움직임 표시(&amp;L)</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>클립…</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>보관…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>A few key poses become a motion that is put together from the takes and clips: it appears here.</source>
        <translation>키 포즈 몇 개가 테이크와 클립을 엮은 모션이 되어 여기에 나타납니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeySession</name>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2~%3</translation>
    </message>
    <message>
        <source>Preparing the clips</source>
        <translation>클립 준비 중</translation>
    </message>
    <message>
        <source>Making the motion</source>
        <translation>모션 만드는 중</translation>
    </message>
    <message>
        <source>Add a key at frame %1</source>
        <translation>프레임 %1에 키 추가</translation>
    </message>
    <message>
        <source>Take the pose of the recording</source>
        <translation>녹화의 포즈 쓰기</translation>
    </message>
    <message>
        <source>Remove the key at frame %1</source>
        <translation>프레임 %1의 키 제거</translation>
    </message>
    <message>
        <source>A key stands at frame %1 already.</source>
        <translation>프레임 %1에는 이미 키가 있습니다.</translation>
    </message>
    <message>
        <source>Move the key to frame %1</source>
        <translation>키를 프레임 %1(으)로 이동</translation>
    </message>
    <message>
        <source>Move the key and later ones to frame %1</source>
        <translation>이 키와 뒤의 키를 프레임 %1(으)로 이동</translation>
    </message>
    <message>
        <source>Later keys %1 times as far</source>
        <translation>뒤의 키를 %1배 거리로</translation>
    </message>
    <message>
        <source>Copy the key to frame %1</source>
        <translation>키를 프레임 %1에 복사</translation>
    </message>
    <message>
        <source>Mirror the key</source>
        <translation>키 좌우 뒤집기</translation>
    </message>
    <message>
        <source>Change the way to the next key</source>
        <translation>다음 키로 가는 방식 바꾸기</translation>
    </message>
    <message>
        <source>Remove all keys</source>
        <translation>모든 키 제거</translation>
    </message>
    <message>
        <source>Drag the %1</source>
        <translation>끌기: %1</translation>
    </message>
    <message>
        <source>Turn the %1</source>
        <translation>%1 돌리기</translation>
    </message>
    <message>
        <source>Move the %1 a little</source>
        <translation>조금 이동: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyStrip</name>
    <message>
        <source>Key poses over time</source>
        <translation>시간에 따른 키 포즈</translation>
    </message>
    <message>
        <source>The strike over time</source>
        <translation>시간에 따른 타격</translation>
    </message>
    <message>
        <source>The strikes are being aligned.</source>
        <translation>타격을 정렬하고 있습니다.</translation>
    </message>
    <message>
        <source>No strike to bring to a target.</source>
        <translation>표적으로 보낼 타격이 없습니다.</translation>
    </message>
    <message>
        <source>hit, %1</source>
        <translation>명중, %1</translation>
    </message>
    <message>
        <source>No key poses yet. Return makes the first one, of the pose that the take shows now.</source>
        <translation>아직 키 포즈가 없습니다. Return을 누르면 테이크에 지금 보이는 포즈로 첫 키를 만듭니다.</translation>
    </message>
    <message>
        <source>key at frame %1 · drag to move it</source>
        <translation>프레임 %1의 키 · 끌어서 옮기기</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeysPage</name>
    <message>
        <source>Mouse on the timeline</source>
        <translation>타임라인에서의 마우스</translation>
    </message>
    <message>
        <source>click, double-click</source>
        <translation>클릭, 두 번 클릭</translation>
    </message>
    <message>
        <source>select a boundary; remove or restore it</source>
        <translation>경계 선택, 제거 또는 복원</translation>
    </message>
    <message>
        <source>× over a boundary</source>
        <translation>경계 위의 ×</translation>
    </message>
    <message>
        <source>remove it at once</source>
        <translation>바로 제거</translation>
    </message>
    <message>
        <source>drag a boundary</source>
        <translation>경계 끌기</translation>
    </message>
    <message>
        <source>move it; Ctrl or Alt: without snapping; Esc: leave it</source>
        <translation>이동. Ctrl 또는 Alt: 스냅 없이, Esc: 그만두기</translation>
    </message>
    <message>
        <source>drag elsewhere</source>
        <translation>다른 곳 끌기</translation>
    </message>
    <message>
        <source>scrub</source>
        <translation>탐색</translation>
    </message>
    <message>
        <source>drag a loop end on the ruler</source>
        <translation>눈금자에서 루프 끝 끌기</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>click, double-click an action</source>
        <translation>동작 클릭, 두 번 클릭</translation>
    </message>
    <message>
        <source>select it; show and loop it</source>
        <translation>선택, 화면에 맞추고 루프</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>오른쪽 클릭</translation>
    </message>
    <message>
        <source>what can be done there</source>
        <translation>그곳에서 할 수 있는 일</translation>
    </message>
    <message>
        <source>wheel, Shift+wheel, middle drag</source>
        <translation>휠, Shift+휠, 가운데 버튼 끌기</translation>
    </message>
    <message>
        <source>scroll</source>
        <translation>스크롤</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+휠</translation>
    </message>
    <message>
        <source>zoom about the pointer</source>
        <translation>포인터를 중심으로 확대/축소</translation>
    </message>
    <message>
        <source>Mouse in the 3D view</source>
        <translation>3D 보기에서의 마우스</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>끌기</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>middle or Shift+drag</source>
        <translation>가운데 버튼 또는 Shift+끌기</translation>
    </message>
    <message>
        <source>move</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>휠</translation>
    </message>
    <message>
        <source>click a fighter</source>
        <translation>선수 클릭</translation>
    </message>
    <message>
        <source>make it the active one</source>
        <translation>활성 선수로 만들기</translation>
    </message>
    <message>
        <source>measuring: click joints</source>
        <translation>측정 중: 관절 클릭</translation>
    </message>
    <message>
        <source>distance; over a joint: its speed</source>
        <translation>거리, 관절 위에서는 속도</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>단축키와 마우스</translation>
    </message>
    <message>
        <source>Search keys and commands</source>
        <translation>단축키와 명령 검색</translation>
    </message>
    <message>
        <source>Shows the lines that hold these letters</source>
        <translation>이 글자가 있는 줄을 표시합니다</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>인쇄…</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>PDF로 저장…</translation>
    </message>
    <message>
        <source>Change keys…</source>
        <translation>단축키 바꾸기…</translation>
    </message>
    <message>
        <source>The keys of all workspaces, on paper. (Ctrl+P)</source>
        <translation>모든 작업 공간의 단축키를 종이에. (Ctrl+P)</translation>
    </message>
    <message>
        <source>The keys of all workspaces, as a file.</source>
        <translation>모든 작업 공간의 단축키를 파일로.</translation>
    </message>
    <message>
        <source>Gives commands other keys, in the preferences.</source>
        <translation>환경 설정에서 명령의 단축키를 바꿉니다.</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>이 페이지 닫기 (Esc)</translation>
    </message>
    <message>
        <source>No key and no command holds these letters.</source>
        <translation>이 글자가 있는 단축키나 명령이 없습니다.</translation>
    </message>
    <message>
        <source>Nobody is here to choose a printer.</source>
        <translation>프린터를 고를 사람이 없습니다.</translation>
    </message>
    <message>
        <source>Print the sheet of keys</source>
        <translation>단축키 표 인쇄</translation>
    </message>
    <message>
        <source>%1 does not take the sheet.</source>
        <translation>%1이(가) 표를 받지 않습니다.</translation>
    </message>
    <message>
        <source>Save the sheet of keys</source>
        <translation>단축키 표 저장</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written there.</source>
        <translation>%1은(는) 그곳에 쓸 수 없습니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelExchange</name>
    <message>
        <source>Labels (*.csv *.json *.eaf);;All files (*)</source>
        <translation>레이블 (*.csv *.json *.eaf);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>레이블 가져오기</translation>
    </message>
    <message>
        <source>Compare with another person&apos;s labels</source>
        <translation>다른 사람의 레이블과 비교</translation>
    </message>
    <message>
        <source>Use another vocabulary</source>
        <translation>다른 어휘 사용</translation>
    </message>
    <message>
        <source>Vocabularies (*.json)</source>
        <translation>어휘 (*.json)</translation>
    </message>
    <message>
        <source>Write labels</source>
        <translation>레이블 쓰기</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json);;ELAN, the shown take (*.eaf)</source>
        <translation>표 (*.csv);;JSON (*.json);;ELAN, 표시된 테이크 (*.eaf)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 읽는 중</translation>
    </message>
    <message>
        <source>%1: %2 of %3 labels found their action.</source>
        <translation>%1: 레이블 %3개 중 %2개가 동작을 찾았습니다.</translation>
    </message>
    <message>
        <source>Labels written to %1.</source>
        <translation>레이블을 %1에 썼습니다.</translation>
    </message>
    <message>
        <source>The vocabulary that the studio brings</source>
        <translation>스튜디오 기본 어휘</translation>
    </message>
    <message>
        <source>It has no word for these labels, which would be dropped (undo brings them back):</source>
        <translation>다음 레이블에 맞는 낱말이 없어 버려집니다(실행 취소로 되돌릴 수 있음):</translation>
    </message>
    <message>
        <source>The vocabulary is %1 now.</source>
        <translation>이제 어휘는 %1입니다.</translation>
    </message>
    <message>
        <source>%1: %2, %3 aspects.</source>
        <translation>%1: %2, 측면 %3개.</translation>
    </message>
    <message>
        <source>Use vocabulary</source>
        <translation>어휘 사용</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelLanes</name>
    <message>
        <source>%1 · action %2</source>
        <translation>%1 · 동작 %2</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>메모: %1</translation>
    </message>
    <message>
        <source>the machine would say %1</source>
        <translation>학습기의 의견은 %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelLearning</name>
    <message>
        <source>Comparing actions</source>
        <translation>동작 비교 중</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>학습 중</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>보정 중</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelPalette</name>
    <message>
        <source>Classes and their keys</source>
        <translation>클래스와 단축키</translation>
    </message>
    <message>
        <source>For two strikes in one action: this, then a class of another lane</source>
        <translation>한 동작에 타격이 둘일 때: 이것을 누른 다음 다른 레인의 클래스</translation>
    </message>
    <message>
        <source>
Right click: paint with it over actions of the timeline</source>
        <translation>
오른쪽 클릭: 타임라인의 동작 위에 칠하기</translation>
    </message>
    <message>
        <source>first, then two classes: both</source>
        <translation>먼저, 그다음 두 클래스: 둘 다</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelPanel</name>
    <message>
        <source>Go on after an answer</source>
        <translation>답한 뒤 다음으로</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>단축키</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>대기열</translation>
    </message>
    <message>
        <source>Current action</source>
        <translation>현재 동작</translation>
    </message>
    <message>
        <source>Accept what is proposed</source>
        <translation>제안을 수락합니다</translation>
    </message>
    <message>
        <source>Take the second best instead; of what a hand said, nothing any more</source>
        <translation>대신 차선을 씁니다. 수동 레이블이면 없앱니다</translation>
    </message>
    <message>
        <source>Why rules say so</source>
        <translation>규칙의 이유</translation>
    </message>
    <message>
        <source>Most useful first</source>
        <translation>유용한 순</translation>
    </message>
    <message>
        <source>Least sure first</source>
        <translation>확신이 낮은 순</translation>
    </message>
    <message>
        <source>In order of time</source>
        <translation>시간순</translation>
    </message>
    <message>
        <source>Order of the queue</source>
        <translation>대기열 순서</translation>
    </message>
    <message>
        <source>Most useful: where the machine is torn, spread over different-looking actions</source>
        <translation>유용한 순: 학습기가 갈피를 못 잡는 것을, 서로 달라 보이는 동작에 고루</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>질문</translation>
    </message>
    <message>
        <source>Sure from %1 on: %2</source>
        <translation>확신 기준 %1 이상: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>동작 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>No action</source>
        <translation>동작 없음</translation>
    </message>
    <message>
        <source>Actions appear here once a recording is open and cut.</source>
        <translation>녹화를 열어 분할하면 동작이 여기에 나타납니다.</translation>
    </message>
    <message>
        <source>%1 leads to the first question; or click an action.</source>
        <translation>%1(으)로 첫 질문에 가거나 동작을 클릭하세요.</translation>
    </message>
    <message>
        <source>%1 actions chosen</source>
        <translation>동작 %1개 선택됨</translation>
    </message>
    <message>
        <source>%1 · action %2 · %3</source>
        <translation>%1 · 동작 %2 · %3</translation>
    </message>
    <message>
        <source>%1 · by hand</source>
        <translation>%1 · 수동</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>되돌리기</translation>
    </message>
    <message>
        <source>the only class so far</source>
        <translation>지금까지 유일한 클래스</translation>
    </message>
    <message>
        <source>Nothing is proposed yet</source>
        <translation>아직 제안이 없습니다</translation>
    </message>
    <message>
        <source>Something else: a class key</source>
        <translation>다른 것이면 클래스 키를 누르세요</translation>
    </message>
    <message>
        <source>Say what it is by a class key</source>
        <translation>클래스 키로 무엇인지 답하세요</translation>
    </message>
    <message>
        <source>%1  %2  %3</source>
        <translation>%1  %2  %3</translation>
    </message>
    <message>
        <source>Queue %1</source>
        <translation>대기열 %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelReview</name>
    <message>
        <source>There is no action to label.</source>
        <translation>레이블을 붙일 동작이 없습니다.</translation>
    </message>
    <message>
        <source>No question is left. Accept what rules and machine say of the rest.</source>
        <translation>남은 질문이 없습니다. 나머지는 규칙과 학습기의 제안을 수락하세요.</translation>
    </message>
    <message>
        <source>No question was shown before.</source>
        <translation>이전에 표시된 질문이 없습니다.</translation>
    </message>
    <message>
        <source>Said: %1. This is the next question.</source>
        <translation>답함: %1. 다음 질문입니다.</translation>
    </message>
    <message>
        <source>That is what a hand has said already.</source>
        <translation>이미 수동으로 붙인 레이블입니다.</translation>
    </message>
    <message>
        <source>The machine proposes nothing yet: say what it is by a class key.</source>
        <translation>학습기의 제안이 아직 없습니다. 클래스 키로 무엇인지 답하세요.</translation>
    </message>
    <message>
        <source>There is no second best: say what it is by a class key.</source>
        <translation>차선이 없습니다. 클래스 키로 무엇인지 답하세요.</translation>
    </message>
    <message>
        <source>%1 has no class %2.</source>
        <translation>%1에는 클래스 %2이(가) 없습니다.</translation>
    </message>
    <message>
        <source>The next class key adds to the label.</source>
        <translation>다음 클래스 키는 레이블에 더해집니다.</translation>
    </message>
    <message>
        <source>Accepted as soon as the machine knows how sure it is.</source>
        <translation>학습기의 확신도가 계산되는 대로 수락합니다.</translation>
    </message>
    <message>
        <source>Every action is labelled, all of them by hand.</source>
        <translation>모든 동작에 레이블이 있습니다. 모두 수동입니다.</translation>
    </message>
    <message>
        <source>Every action is labelled; of these the machine was least sure. Return says that it is right.</source>
        <translation>모든 동작에 레이블이 있습니다. 학습기가 가장 확신하지 못한 것들입니다. 맞으면 Enter를 누르세요.</translation>
    </message>
    <message>
        <source>Said: %1. Now the class beside it.</source>
        <translation>답: %1. 이제 함께 붙일 클래스를 고르세요.</translation>
    </message>
    <message numerus="yes">
        <source>Accepted: %n action(s). Ctrl+Z takes all of it back.</source>
        <translation>
            <numerusform>수락: 동작 %n개. Ctrl+Z로 한 번에 되돌립니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Accepted what rules say.</source>
        <translation>규칙의 제안을 수락했습니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelViews</name>
    <message>
        <source>Palette and questions</source>
        <translation>팔레트와 질문</translation>
    </message>
    <message>
        <source>Find actions by what is said of them</source>
        <translation>레이블로 동작 찾기</translation>
    </message>
    <message>
        <source>Actions that look like the current one, side by side</source>
        <translation>현재 동작과 비슷해 보이는 동작을 나란히</translation>
    </message>
    <message>
        <source>How well the machine knows the bout: confusion matrix and learning curve</source>
        <translation>학습기가 대련을 얼마나 아는지: 혼동 행렬과 학습 곡선</translation>
    </message>
    <message>
        <source>Thresholds of the rules for move and react</source>
        <translation>이동과 반응 규칙의 임곗값</translation>
    </message>
    <message>
        <source>Another person&apos;s labels beside these</source>
        <translation>다른 사람의 레이블을 나란히</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>레이블</translation>
    </message>
    <message>
        <source>Find actions</source>
        <translation>동작 찾기</translation>
    </message>
    <message>
        <source>Similar actions</source>
        <translation>비슷한 동작</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>품질</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>규칙</translation>
    </message>
    <message>
        <source>Two people</source>
        <translation>두 사람</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelWords</name>
    <message>
        <source>%1 open</source>
        <translation>%1 미정</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>%1 없음</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>open</source>
        <translation>미정</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>수동</translation>
    </message>
    <message>
        <source>rule</source>
        <translation>규칙</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>학습기</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>수동</translation>
    </message>
    <message>
        <source>accepted from a rule</source>
        <translation>규칙에서 수락</translation>
    </message>
    <message>
        <source>accepted from the machine, %1</source>
        <translation>학습기에서 수락, %1</translation>
    </message>
    <message>
        <source>proposed by a rule</source>
        <translation>규칙의 제안</translation>
    </message>
    <message>
        <source>proposed by a rule, %1</source>
        <translation>규칙의 제안, %1</translation>
    </message>
    <message>
        <source>proposed: the only one seen so far</source>
        <translation>제안: 지금까지 본 유일한 것</translation>
    </message>
    <message>
        <source>proposed by the machine, %1</source>
        <translation>학습기의 제안, %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LaneSource</name>
    <message>
        <source>labels</source>
        <translation>레이블</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LearningPlot</name>
    <message>
        <source>Learning curve</source>
        <translation>학습 곡선</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>예상 %1</translation>
    </message>
    <message>
        <source>as asked %1</source>
        <translation>질문 순 %1</translation>
    </message>
    <message>
        <source>random %1</source>
        <translation>무작위 %1</translation>
    </message>
    <message>
        <source>%1 labels: %2</source>
        <translation>레이블 %1개: %2</translation>
    </message>
    <message>
        <source>labels by hand</source>
        <translation>수동 레이블</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>예상</translation>
    </message>
    <message>
        <source>as asked</source>
        <translation>질문 순</translation>
    </message>
    <message>
        <source>random</source>
        <translation>무작위</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MadeMotion</name>
    <message>
        <source>Keep the motion as a take</source>
        <translation>모션을 테이크로 보관</translation>
    </message>
    <message>
        <source>Recordings (*.bvh)</source>
        <translation>녹화 (*.bvh)</translation>
    </message>
    <message>
        <source>Keeping the motion</source>
        <translation>모션 보관 중</translation>
    </message>
    <message>
        <source>Kept as take %1.</source>
        <translation>테이크 %1(으)로 보관했습니다.</translation>
    </message>
    <message>
        <source>Export the motion</source>
        <translation>모션 내보내기</translation>
    </message>
    <message>
        <source>Motion (*.bvh);;glTF: skeleton and animation (*.glb)</source>
        <translation>모션 (*.bvh);;glTF: 골격과 애니메이션 (*.glb)</translation>
    </message>
    <message>
        <source>Writing the motion</source>
        <translation>모션 쓰는 중</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>저장함: %1</translation>
    </message>
    <message>
        <source>Add clips</source>
        <translation>클립 추가</translation>
    </message>
    <message>
        <source>Motion and projects (*.bvh *.amc *.kumite)</source>
        <translation>모션과 프로젝트 (*.bvh *.amc *.kumite)</translation>
    </message>
    <message>
        <source>Add all clips of a folder</source>
        <translation>폴더의 모든 클립 추가</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MainWindow</name>
    <message>
        <source>&amp;Segment</source>
        <translation>분할(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Remove or restore boundary</source>
        <translation>경계 제거 또는 복원(&amp;R)</translation>
    </message>
    <message>
        <source>Split here: &amp;add a boundary</source>
        <translation>여기서 나누기: 경계 추가(&amp;A)</translation>
    </message>
    <message>
        <source>Join with the action &amp;before</source>
        <translation>앞 동작과 합치기(&amp;B)</translation>
    </message>
    <message>
        <source>Join with the action af&amp;ter</source>
        <translation>뒤 동작과 합치기(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Previous boundary</source>
        <translation>이전 경계(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next boundary</source>
        <translation>다음 경계(&amp;N)</translation>
    </message>
    <message>
        <source>Move boundary one frame &amp;earlier</source>
        <translation>경계를 한 프레임 앞당기기(&amp;E)</translation>
    </message>
    <message>
        <source>Move boundary one frame &amp;later</source>
        <translation>경계를 한 프레임 늦추기(&amp;L)</translation>
    </message>
    <message>
        <source>Select the action before</source>
        <translation>앞 동작 선택</translation>
    </message>
    <message>
        <source>Select the action after</source>
        <translation>뒤 동작 선택</translation>
    </message>
    <message>
        <source>Sho&amp;w and loop the action</source>
        <translation>동작을 화면에 맞추고 루프(&amp;W)</translation>
    </message>
    <message>
        <source>N&amp;ote on the action…</source>
        <translation>동작 메모(&amp;O)…</translation>
    </message>
    <message>
        <source>Ne&amp;xt suspect</source>
        <translation>다음 의심점(&amp;X)</translation>
    </message>
    <message>
        <source>Pre&amp;vious suspect</source>
        <translation>이전 의심점(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Keep: it is a boundary</source>
        <translation>유지: 경계 맞음(&amp;K)</translation>
    </message>
    <message>
        <source>Re&amp;move: it is spurious</source>
        <translation>제거: 가짜 극소점(&amp;M)</translation>
    </message>
    <message>
        <source>De&amp;cide anew</source>
        <translation>다시 정하기(&amp;C)</translation>
    </message>
    <message>
        <source>Compare with settings B</source>
        <translation>설정 B와 비교</translation>
    </message>
    <message>
        <source>T&amp;imeline</source>
        <translation>타임라인(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Height of the centre of mass</source>
        <translation>질량 중심 높이(&amp;H)</translation>
    </message>
    <message>
        <source>Force without &amp;smoothing</source>
        <translation>평활화하지 않은 힘(&amp;S)</translation>
    </message>
    <message>
        <source>Speeds of the h&amp;ands</source>
        <translation>손 속도(&amp;A)</translation>
    </message>
    <message>
        <source>Speeds of the &amp;feet</source>
        <translation>발 속도(&amp;F)</translation>
    </message>
    <message>
        <source>Ruler in &amp;time and frames</source>
        <translation>눈금자: 시간과 프레임(&amp;T)</translation>
    </message>
    <message>
        <source>Ruler in time</source>
        <translation>눈금자: 시간</translation>
    </message>
    <message>
        <source>Ruler in frames</source>
        <translation>눈금자: 프레임</translation>
    </message>
    <message>
        <source>Next &amp;unit of the ruler</source>
        <translation>눈금자의 다음 단위(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>레이블(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Next question</source>
        <translation>다음 질문(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Previous question</source>
        <translation>이전 질문(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Accept what is proposed</source>
        <translation>제안 수락(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Reject: the second best instead</source>
        <translation>거부: 대신 차선으로(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Take back what is said of the action</source>
        <translation>동작의 레이블 되돌리기(&amp;T)</translation>
    </message>
    <message>
        <source>Accept the &amp;sure rest</source>
        <translation>확신하는 나머지 수락(&amp;S)</translation>
    </message>
    <message>
        <source>Less sure is sure eno&amp;ugh</source>
        <translation>확신 기준 낮추기(&amp;U)</translation>
    </message>
    <message>
        <source>On&amp;ly surer is sure enough</source>
        <translation>확신 기준 높이기(&amp;L)</translation>
    </message>
    <message>
        <source>Answers &amp;go on to the next question</source>
        <translation>답하면 다음 질문으로(&amp;G)</translation>
    </message>
    <message>
        <source>Lane abo&amp;ve</source>
        <translation>위 레인(&amp;V)</translation>
    </message>
    <message>
        <source>Lane belo&amp;w</source>
        <translation>아래 레인(&amp;W)</translation>
    </message>
    <message>
        <source>Nothing of the lane&apos;s aspect</source>
        <translation>레인의 측면 없음</translation>
    </message>
    <message>
        <source>Class %1 of the lane</source>
        <translation>레인의 클래스 %1</translation>
    </message>
    <message>
        <source>Next class &amp;besides: a composite</source>
        <translation>다음 클래스 더하기: 복합(&amp;B)</translation>
    </message>
    <message>
        <source>Choose the action before as well</source>
        <translation>앞 동작도 선택</translation>
    </message>
    <message>
        <source>Choose the action after as well</source>
        <translation>뒤 동작도 선택</translation>
    </message>
    <message>
        <source>Quick label %1</source>
        <translation>빠른 레이블 %1</translation>
    </message>
    <message>
        <source>Label: %1</source>
        <translation>레이블: %1</translation>
    </message>
    <message>
        <source>Show pal&amp;ette and questions</source>
        <translation>팔레트와 질문 보기(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Find actions</source>
        <translation>동작 찾기(&amp;F)</translation>
    </message>
    <message>
        <source>Show si&amp;milar actions</source>
        <translation>비슷한 동작 보기(&amp;J)</translation>
    </message>
    <message>
        <source>Show &amp;quality</source>
        <translation>품질 보기(&amp;Q)</translation>
    </message>
    <message>
        <source>Show &amp;rules</source>
        <translation>규칙 보기(&amp;M)</translation>
    </message>
    <message>
        <source>Show &amp;two people&apos;s labels</source>
        <translation>두 사람의 레이블 보기(&amp;X)</translation>
    </message>
    <message>
        <source>Ne&amp;xt action found</source>
        <translation>찾은 다음 동작(&amp;Y)</translation>
    </message>
    <message>
        <source>Pre&amp;vious action found</source>
        <translation>찾은 이전 동작(&amp;Z)</translation>
    </message>
    <message>
        <source>Choose &amp;all that were found</source>
        <translation>찾은 것 모두 선택(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Give similar actions the same label</source>
        <translation>비슷한 동작에 같은 레이블 붙이기(&amp;G)</translation>
    </message>
    <message>
        <source>Take t&amp;heirs</source>
        <translation>다른 쪽 값 쓰기(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>내 값 유지(&amp;K)</translation>
    </message>
    <message>
        <source>Take theirs for all that are &amp;open</source>
        <translation>미정인 것 모두 다른 쪽 값 쓰기(&amp;O)</translation>
    </message>
    <message>
        <source>Add what onl&amp;y they labelled</source>
        <translation>다른 쪽에만 있는 레이블 추가(&amp;A)</translation>
    </message>
    <message>
        <source>Next &amp;difference</source>
        <translation>다음 차이(&amp;D)</translation>
    </message>
    <message>
        <source>Take &amp;over labels…</source>
        <translation>레이블 가져오기(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Write labels…</source>
        <translation>레이블 쓰기(&amp;W)…</translation>
    </message>
    <message>
        <source>&amp;Compare with labels of…</source>
        <translation>다른 사람의 레이블과 비교(&amp;C)…</translation>
    </message>
    <message>
        <source>Use another voca&amp;bulary…</source>
        <translation>다른 어휘 사용(&amp;B)…</translation>
    </message>
    <message>
        <source>Use the built-&amp;in vocabulary</source>
        <translation>내장 어휘 사용(&amp;I)</translation>
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
        <translation>파일(&amp;F)</translation>
    </message>
    <message>
        <source>Open the &amp;demo bout</source>
        <translation>데모 대련 열기(&amp;D)</translation>
    </message>
    <message>
        <source>Open &amp;recordings…</source>
        <translation>녹화 열기(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>프로젝트 열기(&amp;O)…</translation>
    </message>
    <message>
        <source>Opened &amp;lately</source>
        <translation>최근에 연 항목(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>저장(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>다른 이름으로 저장(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Versions…</source>
        <translation>버전(&amp;V)…</translation>
    </message>
    <message>
        <source>&amp;Export actions…</source>
        <translation>동작 내보내기(&amp;E)…</translation>
    </message>
    <message>
        <source>Export &amp;motion…</source>
        <translation>모션 내보내기(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Find recording…</source>
        <translation>녹화 찾기(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>끝내기(&amp;Q)</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>아직 없음</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>편집(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>실행 취소(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>다시 실행(&amp;R)</translation>
    </message>
    <message>
        <source>Run a &amp;command by name…</source>
        <translation>이름으로 명령 실행(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>환경 설정(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>재생(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>재생 또는 일시 정지(&amp;P)</translation>
    </message>
    <message>
        <source>Play &amp;backward, faster</source>
        <translation>뒤로 재생, 더 빠르게(&amp;B)</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>정지(&amp;T)</translation>
    </message>
    <message>
        <source>Play &amp;forward, faster</source>
        <translation>앞으로 재생, 더 빠르게(&amp;F)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>한 프레임 뒤로</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>한 프레임 앞으로</translation>
    </message>
    <message>
        <source>Leap</source>
        <translation>건너뛰기</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>처음으로</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>끝으로</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>더 느리게</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>더 빠르게</translation>
    </message>
    <message>
        <source>Loop begins here</source>
        <translation>루프 시작점</translation>
    </message>
    <message>
        <source>Loop ends here</source>
        <translation>루프 끝점</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>루프(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>보기(&amp;V)</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>모두 보기(&amp;A)</translation>
    </message>
    <message>
        <source>Show the &amp;fighter and what is selected</source>
        <translation>선수와 선택 항목 보기(&amp;F)</translation>
    </message>
    <message>
        <source>Hide &amp;panels</source>
        <translation>패널 숨기기(&amp;P)</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>전체 화면(&amp;U)</translation>
    </message>
    <message>
        <source>Theme as the system</source>
        <translation>시스템 테마</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>밝은 테마</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>어두운 테마</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>글자 크게</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>글자 작게</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>도움말(&amp;H)</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>분할</translation>
    </message>
    <message>
        <source>Correct the boundaries that cut the bout into actions.</source>
        <translation>대련을 동작으로 나누는 경계를 바로잡습니다.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>레이블</translation>
    </message>
    <message>
        <source>Say what a few actions are; the machine says it of the rest.</source>
        <translation>동작 몇 개가 무엇인지 알려 주면 나머지는 학습기가 답합니다.</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>그래프</translation>
    </message>
    <message>
        <source>What each fighter tends to do next, and the moments behind it.</source>
        <translation>각 선수가 다음에 주로 하는 동작과 그 근거 장면.</translation>
    </message>
    <message>
        <source>Label actions</source>
        <translation>동작에 레이블 붙이기</translation>
    </message>
    <message>
        <source>Go to the Label workspace</source>
        <translation>레이블 작업 공간으로 가기</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>레이블 가져오기</translation>
    </message>
    <message>
        <source>From a table of labels; of a made bout at once its truth</source>
        <translation>레이블 표에서. 만들어진 대련이면 바로 정답에서</translation>
    </message>
    <message>
        <source>Bout</source>
        <translation>대련</translation>
    </message>
    <message>
        <source>Let both fight on from what was learnt, or fight yourself.</source>
        <translation>배운 것으로 둘이 계속 싸우게 하거나 직접 싸우세요.</translation>
    </message>
    <message>
        <source>Clips of sequences</source>
        <translation>시퀀스의 클립</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>시퀀스</translation>
    </message>
    <message>
        <source>Play actions in any order, led over to each other.</source>
        <translation>동작을 원하는 순서로 매끄럽게 이어 재생합니다.</translation>
    </message>
    <message>
        <source>Add clips…</source>
        <translation>클립 추가…</translation>
    </message>
    <message>
        <source>Of motion files or other projects</source>
        <translation>모션 파일이나 다른 프로젝트에서</translation>
    </message>
    <message>
        <source>Keyframe</source>
        <translation>키프레임</translation>
    </message>
    <message>
        <source>A few key poses become a motion made of the recorded ones.</source>
        <translation>키 포즈 몇 개가 녹화된 모션으로 만든 모션이 됩니다.</translation>
    </message>
    <message>
        <source>%1 frames back</source>
        <translation>%1프레임 뒤로</translation>
    </message>
    <message>
        <source>%1 frames on</source>
        <translation>%1프레임 앞으로</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>관절</translation>
    </message>
    <message>
        <source>measure from or to it</source>
        <translation>여기서 또는 여기까지 측정</translation>
    </message>
    <message>
        <source>other fighter</source>
        <translation>다른 선수</translation>
    </message>
    <message>
        <source>leave measuring</source>
        <translation>측정 끝내기</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>일시 정지</translation>
    </message>
    <message>
        <source>play</source>
        <translation>재생</translation>
    </message>
    <message>
        <source>next suspect</source>
        <translation>다음 의심점</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>유지</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>action</source>
        <translation>동작</translation>
    </message>
    <message>
        <source>note</source>
        <translation>메모</translation>
    </message>
    <message>
        <source>next question</source>
        <translation>다음 질문</translation>
    </message>
    <message>
        <source>accept</source>
        <translation>수락</translation>
    </message>
    <message>
        <source>second best</source>
        <translation>차선</translation>
    </message>
    <message>
        <source>lane</source>
        <translation>레인</translation>
    </message>
    <message>
        <source>… its classes</source>
        <translation>… 그 클래스</translation>
    </message>
    <message>
        <source>fight</source>
        <translation>대련</translation>
    </message>
    <message>
        <source>… lead the avatar</source>
        <translation>… 아바타 조종</translation>
    </message>
    <message>
        <source>go on otherwise</source>
        <translation>다르게 계속</translation>
    </message>
    <message>
        <source>… play a block at once</source>
        <translation>… 블록 바로 재생</translation>
    </message>
    <message>
        <source>back to the sequence</source>
        <translation>시퀀스로 돌아가기</translation>
    </message>
    <message>
        <source>find an action</source>
        <translation>동작 찾기</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>block</source>
        <translation>블록</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>draw its transition anew</source>
        <translation>전이 다시 뽑기</translation>
    </message>
    <message>
        <source>map of poses</source>
        <translation>포즈 지도</translation>
    </message>
    <message>
        <source>live</source>
        <translation>라이브</translation>
    </message>
    <message>
        <source>add a key here</source>
        <translation>여기에 키 추가</translation>
    </message>
    <message>
        <source>key</source>
        <translation>키</translation>
    </message>
    <message>
        <source>take the recording&apos;s pose</source>
        <translation>녹화의 포즈 쓰기</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>핸들</translation>
    </message>
    <message>
        <source>pin it</source>
        <translation>고정</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>좌우 뒤집기</translation>
    </message>
    <message>
        <source>back to the keys</source>
        <translation>키로 돌아가기</translation>
    </message>
    <message>
        <source>hit a target</source>
        <translation>표적 맞히기</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>단축키</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>모션</translation>
    </message>
    <message>
        <source>keep as a take</source>
        <translation>테이크로 보관</translation>
    </message>
    <message>
        <source>next surprise</source>
        <translation>다음 의외 지점</translation>
    </message>
    <message>
        <source>play what is behind</source>
        <translation>근거 장면 재생</translation>
    </message>
    <message>
        <source>matrix or graph</source>
        <translation>행렬 또는 그래프</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>경계</translation>
    </message>
    <message>
        <source>add</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>any command</source>
        <translation>모든 명령</translation>
    </message>
    <message>
        <source>help</source>
        <translation>도움말</translation>
    </message>
    <message>
        <source>1 finding</source>
        <translation>발견 사항 1개</translation>
    </message>
    <message>
        <source>%1 findings</source>
        <translation>발견 사항 %1개</translation>
    </message>
    <message>
        <source>What was found in the recordings</source>
        <translation>녹화에서 발견한 것</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>테이크(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Add recordings as a take…</source>
        <translation>녹화를 테이크로 추가(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Rename take</source>
        <translation>테이크 이름 바꾸기(&amp;R)</translation>
    </message>
    <message>
        <source>Re&amp;move take</source>
        <translation>테이크 제거(&amp;M)</translation>
    </message>
    <message>
        <source>Move take &amp;up</source>
        <translation>테이크를 위로(&amp;U)</translation>
    </message>
    <message>
        <source>Move take &amp;down</source>
        <translation>테이크를 아래로(&amp;D)</translation>
    </message>
    <message>
        <source>Show the take &amp;before</source>
        <translation>이전 테이크 보기(&amp;B)</translation>
    </message>
    <message>
        <source>Show the take a&amp;fter</source>
        <translation>다음 테이크 보기(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Other fighter active</source>
        <translation>다른 선수를 활성으로(&amp;O)</translation>
    </message>
    <message>
        <source>Fighter &amp;properties…</source>
        <translation>선수 속성(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Swap fighters</source>
        <translation>선수 맞바꾸기(&amp;S)</translation>
    </message>
    <message>
        <source>F&amp;indings on the recordings</source>
        <translation>녹화의 발견 사항(&amp;I)</translation>
    </message>
    <message>
        <source>Removed take %1. %2 brings it back.</source>
        <translation>테이크 %1을(를) 제거했습니다. %2(으)로 되돌립니다.</translation>
    </message>
    <message>
        <source>leave the field or button</source>
        <translation>입력란이나 버튼에서 나가기</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MatrixPage</name>
    <message>
        <source>log</source>
        <translation>로그</translation>
    </message>
    <message>
        <source>by own label</source>
        <translation>자기 레이블별</translation>
    </message>
    <message>
        <source>by opponent&apos;s label</source>
        <translation>상대 레이블별</translation>
    </message>
    <message>
        <source>by both labels</source>
        <translation>두 레이블별</translation>
    </message>
    <message>
        <source>What the rows know</source>
        <translation>행의 조건</translation>
    </message>
    <message>
        <source>What the rows know: what the fighter does, what the opponent does, or both. What is left out is summed over.</source>
        <translation>행의 조건: 선수의 동작, 상대의 동작 또는 둘 다. 뺀 것은 합산합니다.</translation>
    </message>
    <message>
        <source>by count</source>
        <translation>횟수순</translation>
    </message>
    <message>
        <source>by name</source>
        <translation>이름순</translation>
    </message>
    <message>
        <source>by likeness</source>
        <translation>유사도순</translation>
    </message>
    <message>
        <source>Order of rows and columns</source>
        <translation>행과 열의 순서</translation>
    </message>
    <message>
        <source>By likeness rows that lead to the same labels become neighbours; a line parts the groups.</source>
        <translation>유사도순에서는 같은 레이블로 이어지는 행이 이웃하며, 선이 무리를 나눕니다.</translation>
    </message>
    <message>
        <source>P, EQU7</source>
        <translation>P, EQU7</translation>
    </message>
    <message>
        <source>P, EQU6</source>
        <translation>P, EQU6</translation>
    </message>
    <message>
        <source>P, EQU5</source>
        <translation>P, EQU5</translation>
    </message>
    <message>
        <source>as counted</source>
        <translation>센 그대로</translation>
    </message>
    <message>
        <source>How probabilities are estimated</source>
        <translation>확률 추정 방법</translation>
    </message>
    <message>
        <source>EQU7: P(next | own) · P(next | opponent). EQU6: over pairs of label elements. EQU5: counts of whole triples. All three with a prior, so that nothing is impossible; as counted: without.</source>
        <translation>EQU7: P(다음 | 자기) · P(다음 | 상대). EQU6: 레이블 요소의 쌍에 대해. EQU5: 세 레이블 조합의 횟수. 셋 모두 사전 확률을 두어 불가능한 것이 없습니다. 센 그대로: 사전 확률 없음.</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>나란히</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>차이</translation>
    </message>
    <message>
        <source>How two are compared</source>
        <translation>둘을 비교하는 방법</translation>
    </message>
    <message>
        <source>Colours over the logarithm: rare transitions become visible</source>
        <translation>로그 척도의 색: 드문 전이가 보입니다</translation>
    </message>
    <message>
        <source>Matrix of transitions to compare with</source>
        <translation>비교할 전이 행렬</translation>
    </message>
    <message>
        <source>P(next | own)</source>
        <translation>P(다음 | 자기)</translation>
    </message>
    <message>
        <source>P(next | opponent)</source>
        <translation>P(다음 | 상대)</translation>
    </message>
    <message>
        <source>P(next | own, opponent)</source>
        <translation>P(다음 | 자기, 상대)</translation>
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
        <translation>차이 %1</translation>
    </message>
    <message>
        <source>P %1</source>
        <translation>P %1</translation>
    </message>
    <message>
        <source>%1 → %2   ·   %3   ·   seen %4 of %5 times</source>
        <translation>%1 → %2   ·   %3   ·   %5번 중 %4번 관찰</translation>
    </message>
    <message>
        <source>%1   ·   %2 transitions begin so</source>
        <translation>%1   ·   여기서 시작하는 전이 %2개</translation>
    </message>
    <message>
        <source>%1   ·   %2 transitions lead here</source>
        <translation>%1   ·   여기로 이어지는 전이 %2개</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MatrixView</name>
    <message>
        <source>Matrix of transitions</source>
        <translation>전이 행렬</translation>
    </message>
    <message>
        <source>A row is what goes on, a column what follows. Arrows lead from cell to cell; the moments behind the chosen one are listed beside it.</source>
        <translation>행은 진행 중인 것, 열은 뒤따르는 것입니다. 화살표 키로 셀 사이를 옮기며, 선택한 셀의 근거 장면이 옆에 나열됩니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MessageStrip</name>
    <message>
        <source>Details</source>
        <translation>자세히</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>알림</translation>
    </message>
    <message numerus="yes">
        <source> And %n more.</source>
        <translation>
            <numerusform> 그 밖에 %n개.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::MotionBox</name>
    <message>
        <source>joints adjusted</source>
        <translation>조정한 관절</translation>
    </message>
    <message>
        <source>What the motion is made of</source>
        <translation>모션의 구성</translation>
    </message>
    <message>
        <source>whole body</source>
        <translation>전신</translation>
    </message>
    <message>
        <source>What is looked for</source>
        <translation>찾는 것</translation>
    </message>
    <message>
        <source>In what the places are like the keys: the whole body or one part</source>
        <translation>무엇이 키와 비슷한지: 전신 또는 한 부위</translation>
    </message>
    <message>
        <source>Similar in</source>
        <translation>비슷한 부위</translation>
    </message>
    <message>
        <source>The keys and places like them</source>
        <translation>키와 그와 비슷한 곳</translation>
    </message>
    <message>
        <source>First the keys, then what is most like them; a click takes it</source>
        <translation>먼저 키, 다음은 가장 비슷한 것. 클릭하면 가져옵니다</translation>
    </message>
    <message>
        <source>Places that are like the keys</source>
        <translation>키와 비슷한 곳</translation>
    </message>
    <message>
        <source>The places that are most like the keys, the best first; a click, or Return, takes the body or the part from there</source>
        <translation>키와 가장 비슷한 곳, 좋은 것부터. 클릭이나 Enter로 그곳의 몸이나 부위를 가져옵니다</translation>
    </message>
    <message>
        <source>what fits better</source>
        <translation>더 잘 맞는 것</translation>
    </message>
    <message>
        <source>with the body</source>
        <translation>몸과 함께</translation>
    </message>
    <message>
        <source>its own best</source>
        <translation>자체 최적</translation>
    </message>
    <message>
        <source>as chosen above</source>
        <translation>위에서 고른 대로</translation>
    </message>
    <message>
        <source>Where the %1 comes from</source>
        <translation>%1의 출처</translation>
    </message>
    <message>
        <source>Take a part from elsewhere</source>
        <translation>부분을 다른 곳에서 가져오기</translation>
    </message>
    <message>
        <source>Where parts are joined the joints&apos; mean and spread become those of the keys (paper C, 4.2.2)</source>
        <translation>부분을 잇는 곳에서 관절의 평균과 분산을 키에 맞춥니다 (논문 C, 4.2.2)</translation>
    </message>
    <message>
        <source>How far the motion is drawn to the keys</source>
        <translation>모션을 키로 끌어당기는 정도</translation>
    </message>
    <message>
        <source>Left: as it was found; right: through the keys&apos; poses</source>
        <translation>왼쪽: 찾은 그대로, 오른쪽: 키의 포즈를 지나도록</translation>
    </message>
    <message>
        <source>Meet keys</source>
        <translation>키에 맞춤</translation>
    </message>
    <message>
        <source>Join parts otherwise</source>
        <translation>부분을 다르게 잇기</translation>
    </message>
    <message>
        <source>Draw the motion to the keys</source>
        <translation>모션을 키로 끌어당기기</translation>
    </message>
    <message>
        <source>Two keys or more become a motion, put together from the takes and clips.</source>
        <translation>키가 두 개 이상이면 테이크와 클립을 엮은 모션이 됩니다.</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>모션을 만들고 있습니다.</translation>
    </message>
    <message>
        <source>Body: %1, %2 of %3 features differ, %4 cm from the keys.</source>
        <translation>몸: %1, 특징 %3개 중 %2개 다름, 키에서 %4 cm.</translation>
    </message>
    <message>
        <source>%1 features differ, %2 cm from the keys</source>
        <translation>특징 %1개 다름, 키에서 %2 cm</translation>
    </message>
    <message>
        <source>%1, %2 features differ</source>
        <translation>%1, 특징 %2개 다름</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>키</translation>
    </message>
    <message>
        <source>Take the %1 from elsewhere</source>
        <translation>%1 다른 곳에서 가져오기</translation>
    </message>
    <message>
        <source>Take the body from elsewhere</source>
        <translation>몸을 다른 곳에서 가져오기</translation>
    </message>
</context>
<context>
    <name>kumite::studio::NodePage</name>
    <message>
        <source>cross edges</source>
        <translation>교차 간선</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>차이</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Fighter 1&apos;s graph before fighter 2&apos;s, cross edges between; drag turns</source>
        <translation>선수 1의 그래프가 앞, 선수 2의 그래프가 뒤, 그 사이에 교차 간선. 끌어서 회전</translation>
    </message>
    <message>
        <source>Also what a fighter does next given what the opponent is doing; those of what is selected show always</source>
        <translation>상대의 동작에 따라 선수가 다음에 하는 것도 표시합니다. 선택한 것의 교차 간선은 항상 보입니다</translation>
    </message>
    <message>
        <source>Of each side only what it does more often than the other, as wide as the difference</source>
        <translation>각 쪽에서 다른 쪽보다 더 자주 하는 것만, 차이만큼 굵게</translation>
    </message>
    <message>
        <source>Least probability of an edge</source>
        <translation>간선의 최소 확률</translation>
    </message>
    <message>
        <source>Edges that are less probable are not drawn.</source>
        <translation>확률이 이보다 낮은 간선은 그리지 않습니다.</translation>
    </message>
    <message>
        <source>Most edges from a node</source>
        <translation>노드당 최대 간선 수</translation>
    </message>
    <message>
        <source>So many edges of each node are drawn, the likeliest ones.</source>
        <translation>노드마다 가장 유력한 간선을 이만큼 그립니다.</translation>
    </message>
    <message>
        <source>ΔP ≥ 0.000</source>
        <translation>ΔP ≥ 0.000</translation>
    </message>
    <message>
        <source>12 a node</source>
        <translation>노드당 12개</translation>
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
        <translation>노드당 %1개</translation>
    </message>
    <message>
        <source>%1: %2   ·   %3 actions</source>
        <translation>%1: %2   ·   동작 %3개</translation>
    </message>
    <message>
        <source>%1: %2 → %3   ·   %4 %5   ·   seen %6 times</source>
        <translation>%1: %2 → %3   ·   %4 %5   ·   %6번 관찰</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%2에 대해 %1</translation>
    </message>
    <message>
        <source>more often by</source>
        <translation>더 잦은 정도</translation>
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
        <translation>동작 메모</translation>
    </message>
    <message>
        <source>Return keeps the note, Esc leaves it as it was; no text removes it.</source>
        <translation>Return으로 메모를 남기고 Esc로 그대로 둡니다. 글을 지우면 메모가 제거됩니다.</translation>
    </message>
    <message>
        <source>Note on this action</source>
        <translation>이 동작의 메모</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PartDialog</name>
    <message>
        <source>joints adjusted</source>
        <translation>조정한 관절</translation>
    </message>
    <message>
        <source>Replace a part of a take</source>
        <translation>테이크의 일부 교체</translation>
    </message>
    <message>
        <source>In</source>
        <translation>대상</translation>
    </message>
    <message>
        <source>take that is changed</source>
        <translation>바뀌는 테이크</translation>
    </message>
    <message>
        <source>Part that is replaced</source>
        <translation>교체되는 부위</translation>
    </message>
    <message>
        <source>Where the part hangs on the rest its joint keeps the take&apos;s mean and spread</source>
        <translation>부위가 이어지는 관절은 테이크의 평균과 산포를 유지합니다</translation>
    </message>
    <message>
        <source>The</source>
        <translation>부위</translation>
    </message>
    <message>
        <source>By that of</source>
        <translation>제공</translation>
    </message>
    <message>
        <source>take or clip that lends the part</source>
        <translation>부위를 빌려주는 테이크나 클립</translation>
    </message>
    <message>
        <source>The take, what lends the part, and the result</source>
        <translation>테이크, 부위 제공, 결과</translation>
    </message>
    <message>
        <source>What becomes of it</source>
        <translation>어떻게 되는지</translation>
    </message>
    <message>
        <source>Keep as a take…</source>
        <translation>테이크로 보관…</translation>
    </message>
    <message>
        <source>The %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>First frame of the %1</source>
        <translation>%1의 첫 프레임</translation>
    </message>
    <message>
        <source>Last frame of the %1</source>
        <translation>%1의 마지막 프레임</translation>
    </message>
    <message>
        <source>%1, at %2 Hz</source>
        <translation>%1, %2 Hz</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>그대로</translation>
    </message>
    <message>
        <source>what lends the %1</source>
        <translation>%1 제공</translation>
    </message>
    <message>
        <source>the result</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>%1 of the take&apos;s %2 are changed, in the %3 only; all else stays.</source>
        <translation>테이크의 %2 중 %1이(가) 바뀝니다, %3만. 나머지는 그대로입니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PartWords</name>
    <message>
        <source>left arm</source>
        <translation>왼팔</translation>
    </message>
    <message>
        <source>right arm</source>
        <translation>오른팔</translation>
    </message>
    <message>
        <source>left leg</source>
        <translation>왼다리</translation>
    </message>
    <message>
        <source>right leg</source>
        <translation>오른다리</translation>
    </message>
    <message>
        <source>trunk, head</source>
        <translation>몸통, 머리</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PoseBox</name>
    <message>
        <source>left hand</source>
        <translation>왼손</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>오른손</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>왼발</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>오른발</translation>
    </message>
    <message>
        <source>hips</source>
        <translation>엉덩이</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>가슴</translation>
    </message>
    <message>
        <source>head</source>
        <translation>머리</translation>
    </message>
    <message>
        <source>even</source>
        <translation>균일하게</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>부드럽게</translation>
    </message>
    <message>
        <source>from rest</source>
        <translation>정지에서</translation>
    </message>
    <message>
        <source>to rest</source>
        <translation>정지로</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>유지</translation>
    </message>
    <message>
        <source>stays where it is</source>
        <translation>제자리 고정</translation>
    </message>
    <message>
        <source>and later keys</source>
        <translation>뒤의 키도</translation>
    </message>
    <message>
        <source>The chosen key</source>
        <translation>선택한 키</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>핸들</translation>
    </message>
    <message>
        <source>What is drawn: drag it in the 3D view, or give its place below</source>
        <translation>끌 대상: 3D 보기에서 끌거나 아래에 위치를 입력하세요</translation>
    </message>
    <message>
        <source>While another handle is drawn this one stays; Ctrl and a click on it does the same</source>
        <translation>다른 핸들을 끄는 동안 이 핸들은 그대로 있습니다. 핸들을 Ctrl+클릭해도 됩니다</translation>
    </message>
    <message>
        <source>Place, %1 in metres</source>
        <translation>위치, %1(미터)</translation>
    </message>
    <message>
        <source>%1, metres; y is up</source>
        <translation>%1, 미터. y가 위쪽</translation>
    </message>
    <message>
        <source>x y z, m</source>
        <translation>x y z, m</translation>
    </message>
    <message>
        <source>Way to the next key</source>
        <translation>다음 키로 가는 방식</translation>
    </message>
    <message>
        <source>How the way to the next key goes</source>
        <translation>다음 키까지 어떻게 가는지</translation>
    </message>
    <message>
        <source>Way on</source>
        <translation>가는 방식</translation>
    </message>
    <message>
        <source>Frame of the key</source>
        <translation>키의 프레임</translation>
    </message>
    <message>
        <source>Moves the key to that frame</source>
        <translation>키를 그 프레임으로 옮깁니다</translation>
    </message>
    <message>
        <source>Later keys go as many frames along</source>
        <translation>뒤의 키도 같은 프레임 수만큼 움직입니다</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>Time from this key on, times</source>
        <translation>이 키부터의 시간 배율</translation>
    </message>
    <message>
        <source>All later keys that many times as far from this one: 2 is half as fast</source>
        <translation>뒤의 모든 키를 그 배수만큼 멀리. 2는 절반 속도</translation>
    </message>
    <message>
        <source>Time on</source>
        <translation>이후 시간</translation>
    </message>
    <message>
        <source>Frame %1. Drag hands, feet, hips, chest or head in the 3D view.</source>
        <translation>프레임 %1. 3D 보기에서 손, 발, 엉덩이, 가슴, 머리를 끄세요.</translation>
    </message>
    <message>
        <source>Return makes a key.</source>
        <translation>Return으로 키를 만듭니다.</translation>
    </message>
    <message>
        <source>Choose a key to change its pose.</source>
        <translation>포즈를 바꿀 키를 고르세요.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PoseDialog</name>
    <message>
        <source>Copy a pose</source>
        <translation>포즈 복사</translation>
    </message>
    <message>
        <source>Take or clip</source>
        <translation>테이크나 클립</translation>
    </message>
    <message>
        <source>Whose pose is copied: a fighter of a take, or a clip</source>
        <translation>누구의 포즈를 복사할지: 테이크의 선수 또는 클립</translation>
    </message>
    <message>
        <source>The pose</source>
        <translation>포즈</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>시점</translation>
    </message>
    <message>
        <source>Which moment; arrow keys go on by one frame</source>
        <translation>어느 시점인지. 화살표 키는 한 프레임씩 갑니다</translation>
    </message>
    <message>
        <source>Frame of the take or clip</source>
        <translation>테이크나 클립의 프레임</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>Copy the pose</source>
        <translation>포즈 복사</translation>
    </message>
    <message>
        <source>frame %1 at %2 Hz</source>
        <translation>프레임 %1, %2 Hz</translation>
    </message>
    <message>
        <source>Copy the pose of %1</source>
        <translation>%1의 포즈 복사</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>환경 설정</translation>
    </message>
    <message>
        <source>General</source>
        <translation>일반</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>단축키</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>기본값 복원</translation>
    </message>
    <message>
        <source>All values of the General page as the studio brings them.</source>
        <translation>일반 페이지의 모든 값을 스튜디오 기본값으로 되돌립니다.</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>이 페이지 닫기 (Esc)</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>모양</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>시스템 설정</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>밝게</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>어둡게</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>테마</translation>
    </message>
    <message>
        <source>Colours of the whole window.</source>
        <translation>창 전체의 색.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>Of all texts, numbers and dates in the window; files do not know it. The window is made anew at once, with what is open in it.</source>
        <translation>창의 모든 글, 숫자, 날짜의 언어. 파일에는 영향이 없습니다. 열린 것을 그대로 두고 창을 바로 다시 만듭니다.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Text size, percent</source>
        <translation>글자 크기, 퍼센트</translation>
    </message>
    <message>
        <source>How large all text is; pages that it makes too large can be scrolled.</source>
        <translation>모든 글자의 크기. 너무 커진 페이지는 스크롤할 수 있습니다.</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>글자 크기</translation>
    </message>
    <message>
        <source>Reduce motion</source>
        <translation>움직임 줄이기</translation>
    </message>
    <message>
        <source>Nothing begins to move by itself: questions and similar actions stand still until you play them.</source>
        <translation>아무것도 저절로 움직이지 않습니다. 질문과 비슷한 동작은 재생할 때까지 멈춰 있습니다.</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>재생</translation>
    </message>
    <message>
        <source>Playback speed of a bout that is opened, percent</source>
        <translation>대련을 열 때의 재생 속도(퍼센트)</translation>
    </message>
    <message>
        <source>How fast a bout plays when it is opened. While it is open, - and + change it.</source>
        <translation>대련을 열 때의 재생 속도입니다. 열려 있는 동안에는 -와 +로 바꿉니다.</translation>
    </message>
    <message>
        <source>Speed at opening</source>
        <translation>열 때 속도</translation>
    </message>
    <message>
        <source>Play in a loop</source>
        <translation>루프로 재생</translation>
    </message>
    <message>
        <source>Whether a bout loops when it is opened.</source>
        <translation>대련을 열 때 루프로 재생할지 정합니다.</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> 프레임</translation>
    </message>
    <message>
        <source>Frames of a leap</source>
        <translation>건너뛸 프레임 수</translation>
    </message>
    <message>
        <source>How far Shift+← and Shift+→ go.</source>
        <translation>Shift+←와 Shift+→로 이동하는 거리.</translation>
    </message>
    <message>
        <source>Shift+← → goes</source>
        <translation>Shift+← → 이동</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>마우스</translation>
    </message>
    <message>
        <source>Mouse sensitivity in the 3D view, percent</source>
        <translation>3D 보기의 마우스 감도(퍼센트)</translation>
    </message>
    <message>
        <source>How fast a drag turns and the wheel zooms in the 3D view.</source>
        <translation>3D 보기에서 끌어 돌리고 휠로 확대하는 속도.</translation>
    </message>
    <message>
        <source>Sensitivity in 3D</source>
        <translation>3D 감도</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>안전</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Autosave interval in seconds</source>
        <translation>자동 저장 간격(초)</translation>
    </message>
    <message>
        <source>After how long at most changes are kept for a recovery. The project file itself is written only when you save.</source>
        <translation>변경 내용을 복구용으로 보관하는 최대 간격. 프로젝트 파일 자체는 저장할 때만 씁니다.</translation>
    </message>
    <message>
        <source>Autosave every</source>
        <translation>자동 저장 간격</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ProgressBox</name>
    <message>
        <source>Progress of labelling</source>
        <translation>레이블 진행률</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>다음에 할 일</translation>
    </message>
    <message>
        <source>Keep what machine and rules propose where they are at least so sure; one step of the history (Ctrl+Return)</source>
        <translation>확신이 이 값 이상인 학습기와 규칙의 제안을 수락합니다. 작업 내역 한 단계입니다 (Ctrl+Return)</translation>
    </message>
    <message>
        <source>Labelled by hand, accepted, open</source>
        <translation>수동 레이블, 수락, 미정</translation>
    </message>
    <message>
        <source>How sure the machine must be of what is accepted: 0.90 is nine of ten right. Ctrl+Down and Ctrl+Up move it.</source>
        <translation>수락하려면 학습기가 얼마나 확신해야 하는지: 0.90은 열 중 아홉이 맞음. Ctrl+Down과 Ctrl+Up으로 바꿉니다.</translation>
    </message>
    <message>
        <source>Least probability of what is accepted</source>
        <translation>수락할 최소 확률</translation>
    </message>
    <message>
        <source>Proposals that are at least so probable are accepted.</source>
        <translation>확률이 이 값 이상인 제안을 수락합니다.</translation>
    </message>
    <message>
        <source>%1 actions: %2 labelled by hand (dark), %3 accepted (light), %4 open</source>
        <translation>동작 %1개: 수동 레이블 %2(진하게), 수락 %3(연하게), 미정 %4</translation>
    </message>
    <message>
        <source>%1 labelled</source>
        <translation>레이블 %1</translation>
    </message>
    <message>
        <source>, expected accuracy %1</source>
        <translation>, 예상 정확도 %1</translation>
    </message>
    <message>
        <source>Accept rules</source>
        <translation>규칙 수락</translation>
    </message>
    <message>
        <source>Accept %1 sure</source>
        <translation>확실한 %1개 수락</translation>
    </message>
    <message>
        <source>Accept the sure</source>
        <translation>확실한 것 수락</translation>
    </message>
    <message>
        <source>Every action is labelled. File &gt; Save keeps it; Label &gt; Write labels… makes a table.</source>
        <translation>모든 동작에 레이블이 있습니다. 파일 &gt; 저장으로 남기고, 레이블 &gt; 레이블 쓰기…로 표를 만듭니다.</translation>
    </message>
    <message>
        <source>No recording is cut into actions yet.</source>
        <translation>동작으로 분할한 녹화가 아직 없습니다.</translation>
    </message>
    <message>
        <source>Label a few actions by hand; the machine proposes the others. N leads to the one that says most.</source>
        <translation>동작 몇 개에 수동으로 레이블을 붙이면 학습기가 나머지를 제안합니다. N을 누르면 가장 도움이 되는 것으로 갑니다.</translation>
    </message>
    <message>
        <source>Go on: N leads to the next one that says most.</source>
        <translation>계속하세요. N을 누르면 다음으로 도움이 되는 것으로 갑니다.</translation>
    </message>
    <message>
        <source>What rules say is left to be accepted.</source>
        <translation>이제 규칙의 제안만 수락하면 됩니다.</translation>
    </message>
    <message>
        <source>Nothing of %1 was labelled so far: if there is any, show the machine one.</source>
        <translation>아직 %1 레이블이 없습니다. 있다면 학습기에 하나 보여 주세요.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Accept %1 guesses</source>
        <translation>추측 %1개 수락</translation>
    </message>
    <message>
        <source>Every action has a label, but of ten that the machine gave only about %1 are right. N leads through those of which it was least sure; or undo the acceptance and answer more questions.</source>
        <translation>모든 동작에 레이블이 있지만 학습기가 붙인 열 개 중 약 %1개만 맞습니다. N으로 가장 불확실한 것부터 살피거나, 수락을 취소하고 질문에 더 답하세요.</translation>
    </message>
    <message numerus="yes">
        <source>%n minima are still suspect. Half actions are hard to label: correct them in Segment first, or go on with N.</source>
        <translation>
            <numerusform>의심스러운 극소점이 %n개 남아 있습니다. 반쪽 동작은 레이블을 붙이기 어렵습니다. 먼저 분할에서 고치거나 N으로 계속하세요.</numerusform>
        </translation>
    </message>
    <message>
        <source>How many of the machine&apos;s answers should be right where no hand has spoken</source>
        <translation>손으로 답하지 않은 곳에서 학습기의 답이 맞을 것으로 보이는 비율</translation>
    </message>
    <message>
        <source>More labels by hand will hardly help: accept the sure rest (%1), lower the bar for the others (%2), then look through the least sure (%3).</source>
        <translation>손으로 더 붙여도 거의 나아지지 않습니다. 확실한 나머지를 수락하고(%1), 나머지는 기준을 낮춘 뒤(%2), 가장 불확실한 것을 살펴보세요(%3).</translation>
    </message>
    <message>
        <source>Go on: the next ones tell the machine most.</source>
        <translation>계속하세요. 다음 질문이 학습기에 가장 도움이 됩니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::QualityBox</name>
    <message>
        <source>Actions of the cell</source>
        <translation>셀의 동작</translation>
    </message>
    <message>
        <source>Aspect of the confusion matrix</source>
        <translation>혼동 행렬의 측면</translation>
    </message>
    <message>
        <source>Whose classes the matrix and the list are about.</source>
        <translation>행렬과 목록에서 다루는 클래스의 측면.</translation>
    </message>
    <message>
        <source>What the cell says</source>
        <translation>셀의 의미</translation>
    </message>
    <message>
        <source>Share of actions whose learnt aspects are all right. Expected: cross-validation over the hand labels as the session went. As asked and random: the hand labels are dealt into folds; one is held out, and from the others the machine learns more and more labels, in the order in which the queue asks for them and in random orders. Both are judged on the same held-out labels. What was asked for is harder than the rest, so the bout as a whole fares better.</source>
        <translation>학습한 측면이 모두 맞은 동작의 비율. 예상: 진행한 순서대로 수동 레이블을 교차 검증한 값. 질문 순과 무작위: 수동 레이블을 겹으로 나누어 하나를 빼 두고, 나머지로 학습기가 점점 더 많은 레이블을 대기열이 묻는 순서와 무작위 순서로 배웁니다. 둘 다 빼 둔 같은 레이블로 평가합니다. 질문으로 나온 것은 나머지보다 어려우므로 대련 전체로는 결과가 더 좋습니다.</translation>
    </message>
    <message>
        <source>Judging</source>
        <translation>평가 중</translation>
    </message>
    <message>
        <source>Comparing orders</source>
        <translation>순서 비교 중</translation>
    </message>
    <message>
        <source>How often machine and rules say the same as your hand appears here, once some actions are labelled by hand.</source>
        <translation>동작 몇 개에 수동으로 레이블을 붙이면, 학습기와 규칙이 얼마나 자주 같은 답을 내는지 여기에 나타납니다.</translation>
    </message>
    <message>
        <source>No hand has said anything of this aspect.</source>
        <translation>이 측면에는 수동 레이블이 없습니다.</translation>
    </message>
    <message>
        <source>Rows by hand, columns %1. %2 of %3 right, F1 %4.</source>
        <translation>행은 수동, 열은 %1. %3개 중 %2개 맞음, F1 %4.</translation>
    </message>
    <message>
        <source>by rule</source>
        <translation>규칙</translation>
    </message>
    <message>
        <source>by machine, unseen</source>
        <translation>학습기(처음 보는 것)</translation>
    </message>
    <message>
        <source>A click on a cell, or Enter, opens its actions.</source>
        <translation>셀을 클릭하거나 Enter를 누르면 그 동작이 열립니다.</translation>
    </message>
    <message>
        <source>No action is in this cell.</source>
        <translation>이 셀에는 동작이 없습니다.</translation>
    </message>
    <message>
        <source>%1 labels as asked do what %2 in random order do.</source>
        <translation>질문 순 레이블 %1개가 무작위 순 %2개와 맞먹습니다.</translation>
    </message>
    <message>
        <source>With %1 hand labels the order of the questions is compared with a random one.</source>
        <translation>수동 레이블이 %1개가 되면 질문 순서를 무작위와 비교합니다.</translation>
    </message>
    <message>
        <source>More labels will hardly help.</source>
        <translation>레이블을 더 붙여도 별로 나아지지 않습니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Questions</name>
    <message>
        <source>%1: nobody is here to choose a file.</source>
        <translation>%1: 파일을 고를 사람이 없습니다.</translation>
    </message>
    <message>
        <source>%1 Nobody is here to answer: %2.</source>
        <translation>%1 답할 사람이 없습니다: %2.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RecentButton</name>
    <message>
        <source>Open %1, %2</source>
        <translation>%1 열기, %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Recovery</name>
    <message>
        <source>Saving a copy</source>
        <translation>사본 저장 중</translation>
    </message>
    <message>
        <source>Recovery copies cannot be written. %1</source>
        <translation>복구용 사본을 쓸 수 없습니다. %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RecoveryDialog</name>
    <message>
        <source>Recover</source>
        <translation>복구</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>버리기</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>복구</translation>
    </message>
    <message>
        <source>Kumite ended unexpectedly. The edits that were not saved are kept here; recovered, they stand in the project as unsaved changes.</source>
        <translation>Kumite가 예기치 않게 종료되었습니다. 저장하지 않은 편집이 여기에 보관되어 있으며, 복구하면 저장하지 않은 변경으로 프로젝트에 남습니다.</translation>
    </message>
    <message>
        <source>Projects that can be recovered</source>
        <translation>복구할 수 있는 프로젝트</translation>
    </message>
    <message>
        <source>What was not saved; a double-click recovers it</source>
        <translation>저장하지 않은 내용. 두 번 클릭하면 복구합니다</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>프로젝트</translation>
    </message>
    <message>
        <source>Last edit</source>
        <translation>마지막 편집</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>저장 안 됨</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>폴더</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>저장한 적 없음</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>나중에</translation>
    </message>
    <message>
        <source>Delete the chosen edits for good (Del)</source>
        <translation>선택한 편집을 완전히 삭제 (Del)</translation>
    </message>
    <message>
        <source>Open the chosen project with its unsaved edits (Enter)</source>
        <translation>선택한 프로젝트를 저장하지 않은 편집과 함께 열기 (Enter)</translation>
    </message>
    <message>
        <source>Keep them and ask again at the next start (Esc)</source>
        <translation>그대로 두고 다음 시작 때 다시 묻기 (Esc)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Review</name>
    <message numerus="yes">
        <source>What you decided clears %n more.</source>
        <translation>
            <numerusform>이 결정으로 %n개가 더 해결됩니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n suspect(s) left.</source>
        <translation>
            <numerusform>의심점 %n개 남음.</numerusform>
        </translation>
    </message>
    <message>
        <source>Every minimum of this take is decided.</source>
        <translation>이 테이크의 모든 극소점을 결정했습니다.</translation>
    </message>
    <message>
        <source>No suspect is left. N leads through the other minima.</source>
        <translation>남은 의심점이 없습니다. N으로 다른 극소점을 살펴봅니다.</translation>
    </message>
    <message>
        <source>No boundary is selected. N leads to the most suspicious minimum.</source>
        <translation>선택한 경계가 없습니다. N을 누르면 가장 의심스러운 극소점으로 갑니다.</translation>
    </message>
    <message>
        <source>No minimum is left to decide.</source>
        <translation>결정할 극소점이 없습니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RoleTable</name>
    <message>
        <source>read off the skeleton&apos;s shape</source>
        <translation>골격의 모양에서 읽음</translation>
    </message>
    <message>
        <source>no human body found</source>
        <translation>인체를 찾지 못함</translation>
    </message>
    <message>
        <source>by %1 names</source>
        <translation>%1 이름으로</translation>
    </message>
    <message>
        <source>Joints of the roles</source>
        <translation>역할의 관절</translation>
    </message>
    <message>
        <source>Which joint of the recording is which part of the body</source>
        <translation>녹화의 어느 관절이 몸의 어느 부분인지</translation>
    </message>
    <message>
        <source>fighter 1</source>
        <translation>선수 1</translation>
    </message>
    <message>
        <source>fighter 2</source>
        <translation>선수 2</translation>
    </message>
    <message>
        <source>Fighter %1: %2 of %3 roles, %4.</source>
        <translation>선수 %1: 역할 %3개 중 %2개, %4.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>set by hand</source>
        <translation>수동으로 지정</translation>
    </message>
    <message>
        <source>found</source>
        <translation>찾음</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>못 찾음</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RulesBox</name>
    <message>
        <source>Lands below</source>
        <translation>착지 높이</translation>
    </message>
    <message>
        <source>Height below which a foot lands</source>
        <translation>이보다 낮으면 발이 착지하는 높이</translation>
    </message>
    <message>
        <source>A foot stands once its toes are lower than this above their rest height …</source>
        <translation>발가락이 놓인 높이에서 이보다 낮고 …</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>slower than</source>
        <translation>보다 느림</translation>
    </message>
    <message>
        <source>Speed below which a foot lands</source>
        <translation>이보다 느리면 발이 착지하는 속도</translation>
    </message>
    <message>
        <source>… and slower than this.</source>
        <translation>… 이보다 느리면 발이 디딘 것입니다.</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Lifts above</source>
        <translation>들림 높이</translation>
    </message>
    <message>
        <source>Height above which a foot lifts</source>
        <translation>이보다 높으면 발이 들리는 높이</translation>
    </message>
    <message>
        <source>It no longer stands once its toes are higher than this …</source>
        <translation>발가락이 이보다 높거나 …</translation>
    </message>
    <message>
        <source>faster than</source>
        <translation>보다 빠름</translation>
    </message>
    <message>
        <source>Speed above which a foot lifts</source>
        <translation>이보다 빠르면 발이 들리는 속도</translation>
    </message>
    <message>
        <source>… or faster than this.</source>
        <translation>… 이보다 빠르면 더는 디딘 것이 아닙니다.</translation>
    </message>
    <message>
        <source>Stands for</source>
        <translation>디딤 시간</translation>
    </message>
    <message>
        <source>Shortest stance</source>
        <translation>최소 디딤</translation>
    </message>
    <message>
        <source>A stance that is shorter does not count.</source>
        <translation>이보다 짧은 디딤은 세지 않습니다.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Closes at</source>
        <translation>접근 속도</translation>
    </message>
    <message>
        <source>Speed at which an attack must close</source>
        <translation>공격이 접근해야 하는 속도</translation>
    </message>
    <message>
        <source>An attack counts for the react rule if its fist or foot closes on the trunk or head faster than this at some moment.</source>
        <translation>주먹이나 발이 어느 순간 이보다 빠르게 몸통이나 머리에 접근하면 반응 규칙에서 공격으로 봅니다.</translation>
    </message>
    <message>
        <source>Usual thresholds</source>
        <translation>기본 임곗값</translation>
    </message>
    <message>
        <source>Back to the thresholds that the studio brings</source>
        <translation>스튜디오 기본 임곗값으로 되돌리기</translation>
    </message>
    <message>
        <source>What the thresholds change</source>
        <translation>임곗값에 따른 변화</translation>
    </message>
    <message>
        <source>Why the rules say so</source>
        <translation>규칙이 그렇게 답한 이유</translation>
    </message>
    <message>
        <source>%1: no action</source>
        <translation>%1: 동작 없음</translation>
    </message>
    <message>
        <source>%1: %2 of %3 actions</source>
        <translation>%1: 동작 %3개 중 %2개</translation>
    </message>
    <message>
        <source>How many actions get another label stands here while a threshold is changed.</source>
        <translation>임곗값을 바꾸는 동안 레이블이 달라지는 동작의 수가 여기에 나타납니다.</translation>
    </message>
    <message>
        <source>Changed: %1.</source>
        <translation>변경: %1.</translation>
    </message>
    <message>
        <source>React: %1</source>
        <translation>반응: %1</translation>
    </message>
    <message>
        <source>Move: %1</source>
        <translation>이동: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SegmentPanel</name>
    <message>
        <source>Keep</source>
        <translation>유지</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>Suspect minima</source>
        <translation>의심 극소점</translation>
    </message>
    <message>
        <source>Minima of the force curves that cut actions appear here, the most suspicious first. Lower the prominence below to see more.</source>
        <translation>동작을 나누는 힘 곡선의 극소점이 가장 의심스러운 것부터 여기에 나타납니다. 더 보려면 아래의 돌출도를 낮추세요.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>검토</translation>
    </message>
    <message>
        <source>Detection</source>
        <translation>검출</translation>
    </message>
    <message>
        <source>Why the minimum is suspected</source>
        <translation>극소점을 의심하는 이유</translation>
    </message>
    <message>
        <source>It is a boundary: no suspect any more; goes on to the next</source>
        <translation>경계가 맞습니다. 의심을 풀고 다음으로 갑니다</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>복원</translation>
    </message>
    <message>
        <source>A boundary that a hand has set.</source>
        <translation>수동으로 정한 경계입니다.</translation>
    </message>
    <message>
        <source>No suspect is left. %1 leads through the others.</source>
        <translation>남은 의심점이 없습니다. %1(으)로 다른 것을 살펴봅니다.</translation>
    </message>
    <message>
        <source>Bring the boundary back</source>
        <translation>경계 되살리기</translation>
    </message>
    <message>
        <source>It is spurious; goes on to the next</source>
        <translation>가짜입니다. 다음으로 갑니다</translation>
    </message>
    <message>
        <source>%1 leads to the most suspicious minimum. Remove it where the body hardly dips: a kick down and up again is one action. Keep it where one ends and another begins.</source>
        <translation>%1 키로 가장 의심스러운 극소점으로 갑니다. 몸이 거의 내려가지 않는 곳은 제거하세요. 내렸다가 다시 올리는 킥은 한 동작입니다. 한 동작이 끝나고 다른 동작이 시작되는 곳은 유지하세요.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceBar</name>
    <message>
        <source>Time of the sequence</source>
        <translation>시퀀스 시간</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>/ %1</translation>
    </message>
    <message>
        <source>the chosen action, %1 s; Esc: back to the sequence</source>
        <translation>선택한 동작, %1 s. Esc: 시퀀스로 돌아가기</translation>
    </message>
    <message>
        <source>live: 1 … 9 play blocks at once</source>
        <translation>라이브: 1 … 9로 블록 바로 재생</translation>
    </message>
    <message>
        <source> · last %1, cost %2</source>
        <translation> · 마지막: %1, 비용 %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceCommands</name>
    <message>
        <source>Se&amp;quence</source>
        <translation>시퀀스(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>재생 또는 일시 정지(&amp;P)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>한 프레임 뒤로</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>한 프레임 앞으로</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>처음으로</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>끝으로</translation>
    </message>
    <message>
        <source>Play it &amp;over and over</source>
        <translation>계속 되풀이해 재생(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Live: keys play blocks at once</source>
        <translation>라이브: 키로 블록 바로 재생(&amp;L)</translation>
    </message>
    <message>
        <source>Live: block %1</source>
        <translation>라이브: 블록 %1</translation>
    </message>
    <message>
        <source>Back to the sequence</source>
        <translation>시퀀스로 돌아가기</translation>
    </message>
    <message>
        <source>The playhead is not inside the chosen block.</source>
        <translation>재생 헤드가 선택한 블록 안에 있지 않습니다.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>%1 다듬기</translation>
    </message>
    <message>
        <source>&amp;Add the chosen action</source>
        <translation>선택한 동작 추가(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;wap the block for the chosen action</source>
        <translation>블록을 선택한 동작으로 교체(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Remove the block</source>
        <translation>블록 제거(&amp;R)</translation>
    </message>
    <message>
        <source>Block before</source>
        <translation>이전 블록</translation>
    </message>
    <message>
        <source>Block after</source>
        <translation>다음 블록</translation>
    </message>
    <message>
        <source>Move the block &amp;earlier</source>
        <translation>블록을 앞당기기(&amp;E)</translation>
    </message>
    <message>
        <source>Move the &amp;block later</source>
        <translation>블록을 늦추기(&amp;B)</translation>
    </message>
    <message>
        <source>Once &amp;more</source>
        <translation>한 번 더(&amp;M)</translation>
    </message>
    <message>
        <source>Repeat the block</source>
        <translation>블록 반복</translation>
    </message>
    <message>
        <source>Once less</source>
        <translation>한 번 덜</translation>
    </message>
    <message>
        <source>Repeat the block less</source>
        <translation>블록 반복 줄이기</translation>
    </message>
    <message>
        <source>Block begins at the playhead</source>
        <translation>블록을 재생 헤드에서 시작</translation>
    </message>
    <message>
        <source>Block ends at the playhead</source>
        <translation>블록을 재생 헤드에서 끝</translation>
    </message>
    <message>
        <source>The whole action again</source>
        <translation>다시 동작 전체</translation>
    </message>
    <message>
        <source>Trim nothing</source>
        <translation>다듬지 않기</translation>
    </message>
    <message>
        <source>&amp;Draw the transition anew</source>
        <translation>전이 다시 뽑기(&amp;D)</translation>
    </message>
    <message>
        <source>Draw all that are not locked anew</source>
        <translation>잠기지 않은 것 모두 다시 뽑기</translation>
    </message>
    <message>
        <source>Loc&amp;k the transition, or let it go</source>
        <translation>전이 잠그기 또는 풀기(&amp;K)</translation>
    </message>
    <message>
        <source>Unlock the transition</source>
        <translation>전이 잠금 풀기</translation>
    </message>
    <message>
        <source>Lock the transition</source>
        <translation>전이 잠그기</translation>
    </message>
    <message>
        <source>Clear the sequence</source>
        <translation>시퀀스 비우기</translation>
    </message>
    <message>
        <source>&amp;Find an action</source>
        <translation>동작 찾기(&amp;F)</translation>
    </message>
    <message>
        <source>Show all of it</source>
        <translation>전체 보기</translation>
    </message>
    <message>
        <source>Map of po&amp;ses</source>
        <translation>포즈 지도(&amp;G)</translation>
    </message>
    <message>
        <source>Add &amp;clips of files…</source>
        <translation>파일의 클립 추가(&amp;C)…</translation>
    </message>
    <message>
        <source>Add cl&amp;ips of a folder…</source>
        <translation>폴더의 클립 추가(&amp;H)…</translation>
    </message>
    <message>
        <source>Keep as a &amp;take…</source>
        <translation>테이크로 보관(&amp;T)…</translation>
    </message>
    <message>
        <source>E&amp;xport the sequence…</source>
        <translation>시퀀스 내보내기(&amp;X)…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequencePanel</name>
    <message>
        <source>What appears here</source>
        <translation>여기에 나타나는 것</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>동작</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>검색</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>동작 검색</translation>
    </message>
    <message>
        <source>Shows the actions in which every word appears: right kick</source>
        <translation>모든 낱말이 들어 있는 동작을 표시합니다: 오른발 킥</translation>
    </message>
    <message>
        <source>Actions to choose from</source>
        <translation>고를 수 있는 동작</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>클립…</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>보관…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>Actions of the takes, and clips of other files, in any order, led over to each other: they appear here.</source>
        <translation>테이크의 동작과 다른 파일의 클립을 원하는 순서로 매끄럽게 이은 것이 여기에 나타납니다.</translation>
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
        <translation>클립 준비 중</translation>
    </message>
    <message>
        <source>Making the motion</source>
        <translation>모션 만드는 중</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 추가</translation>
    </message>
    <message>
        <source>Swap for %1</source>
        <translation>%1(으)로 교체</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 제거</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 이동</translation>
    </message>
    <message>
        <source>Clear the sequence</source>
        <translation>시퀀스 비우기</translation>
    </message>
    <message>
        <source>Draw the transition anew</source>
        <translation>전이 다시 뽑기</translation>
    </message>
    <message>
        <source>Draw all anew</source>
        <translation>모두 다시 뽑기</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceStrip</name>
    <message>
        <source>Blocks of the sequence</source>
        <translation>시퀀스의 블록</translation>
    </message>
    <message>
        <source>  (%1 of %2)</source>
        <translation>  (%1 / %2)</translation>
    </message>
    <message>
        <source>Actions in the order in which they shall be played. Choose one at the right and press Return to add it.</source>
        <translation>재생할 순서대로 놓인 동작. 오른쪽에서 하나를 골라 Return을 누르면 추가됩니다.</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>모션을 만들고 있습니다.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>%1 다듬기</translation>
    </message>
    <message>
        <source>Drag to trim</source>
        <translation>끌어서 다듬기</translation>
    </message>
    <message>
        <source>transition to %1 · %2 to %3</source>
        <translation>%1(으)로 전이 · %2~%3</translation>
    </message>
    <message>
        <source>%1 · %2 to %3</source>
        <translation>%1 · %2~%3</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Session</name>
    <message>
        <source>The edit that waited was dropped: another take is shown.</source>
        <translation>대기하던 편집을 버렸습니다. 다른 테이크가 표시되었습니다.</translation>
    </message>
    <message>
        <source>The edit waits until the force curves are computed.</source>
        <translation>힘 곡선을 계산할 때까지 편집이 대기합니다.</translation>
    </message>
    <message>
        <source>No boundary of %1 lies within 0.1 s of the playhead.</source>
        <translation>재생 헤드에서 0.1 s 안에 %1의 경계가 없습니다.</translation>
    </message>
    <message>
        <source>This is the first action: nothing comes before it.</source>
        <translation>첫 동작입니다. 앞에 아무것도 없습니다.</translation>
    </message>
    <message>
        <source>This is the last action: nothing comes after it.</source>
        <translation>마지막 동작입니다. 뒤에 아무것도 없습니다.</translation>
    </message>
    <message>
        <source>A removed boundary does not move. Del restores it.</source>
        <translation>제거한 경계는 옮길 수 없습니다. Del로 복원하세요.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SettingsFields</name>
    <message>
        <source>Cutoff of the low-pass in Hz</source>
        <translation>저역 통과 필터의 차단 주파수(Hz)</translation>
    </message>
    <message>
        <source>Low-pass over the centre of mass: lower gives smoother curves and fewer minima.</source>
        <translation>질량 중심에 거는 저역 통과 필터. 낮을수록 곡선이 매끄럽고 극소점이 적습니다.</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>Least prominence in body weights</source>
        <translation>최소 돌출도(체중 단위)</translation>
    </message>
    <message>
        <source>A minimum must be at least this deep to be a boundary.</source>
        <translation>극소점이 경계가 되려면 적어도 이만큼 깊어야 합니다.</translation>
    </message>
    <message>
        <source> BW</source>
        <translation> BW</translation>
    </message>
    <message>
        <source>Cutoff</source>
        <translation>차단</translation>
    </message>
    <message>
        <source>Promin.</source>
        <translation>돌출도</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>곡선</translation>
    </message>
    <message>
        <source>length of the force</source>
        <translation>힘의 크기</translation>
    </message>
    <message>
        <source>vertical part</source>
        <translation>수직 성분</translation>
    </message>
    <message>
        <source>Curve that is cut at its minima</source>
        <translation>극소점에서 나눌 곡선</translation>
    </message>
    <message>
        <source>Which curve is cut at its minima: the length of the contact force or its vertical part.</source>
        <translation>극소점에서 나눌 곡선: 접촉력의 크기 또는 수직 성분.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SimilarBox</name>
    <message>
        <source>this one, %1</source>
        <translation>이 동작, %1</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>수락</translation>
    </message>
    <message>
        <source>%1, %2%3</source>
        <translation>%1, %2%3</translation>
    </message>
    <message>
        <source> ⇄</source>
        <translation> ⇄</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>둘 다</translation>
    </message>
    <message>
        <source>Nearest by the numbers from which the machine learns; ⇄: its mirror image is near, and it is seen from the other side. All begin and end together.</source>
        <translation>학습기가 배우는 수치로 가장 가까운 것. ⇄: 좌우를 뒤집은 것이 가까워 반대쪽에서 보여 줍니다. 모두 함께 시작하고 끝납니다.</translation>
    </message>
    <message>
        <source>The chosen ones get the label of the first one, said by a hand, as one step of the history. A click or Space chooses, a double click or Enter goes there.</source>
        <translation>선택한 것에 첫 번째의 레이블을 수동 레이블로, 작업 내역 한 단계로 붙입니다. 클릭이나 Space로 선택하고, 두 번 클릭이나 Enter로 그곳으로 갑니다.</translation>
    </message>
    <message>
        <source>Show both fighters: the opponent, too</source>
        <translation>두 선수 보기: 상대도 함께</translation>
    </message>
    <message>
        <source>Comparing actions</source>
        <translation>동작 비교 중</translation>
    </message>
    <message>
        <source>The actions most like the current one.</source>
        <translation>현재 동작과 가장 비슷한 동작.</translation>
    </message>
    <message>
        <source>The actions most like the current one appear here, once there is an action at the playhead.</source>
        <translation>재생 헤드에 동작이 있으면 그와 가장 비슷한 동작이 여기에 나타납니다.</translation>
    </message>
    <message>
        <source>Same label for all</source>
        <translation>모두 같은 레이블</translation>
    </message>
    <message>
        <source>Same label for %1</source>
        <translation>%1개에 같은 레이블</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageCommands</name>
    <message>
        <source>Save a picture of the 3D view</source>
        <translation>3D 보기의 그림 저장</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>그림 (*.png)</translation>
    </message>
    <message>
        <source>Picture of the 3D view</source>
        <translation>3D 보기의 그림</translation>
    </message>
    <message>
        <source>%1: the picture cannot be written there.</source>
        <translation>%1: 그림을 그곳에 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>3&amp;D view</source>
        <translation>3D 보기(&amp;D)</translation>
    </message>
    <message>
        <source>From the f&amp;ront</source>
        <translation>앞에서(&amp;R)</translation>
    </message>
    <message>
        <source>From the &amp;side</source>
        <translation>옆에서(&amp;S)</translation>
    </message>
    <message>
        <source>From a&amp;bove</source>
        <translation>위에서(&amp;B)</translation>
    </message>
    <message>
        <source>Over the shoulder of fighter 1</source>
        <translation>선수 1의 어깨 너머</translation>
    </message>
    <message>
        <source>Over the shoulder of fighter 2</source>
        <translation>선수 2의 어깨 너머</translation>
    </message>
    <message>
        <source>&amp;Follow the fighters</source>
        <translation>선수 따라가기(&amp;F)</translation>
    </message>
    <message>
        <source>Foot &amp;contacts</source>
        <translation>발 접촉(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Trails of hands and feet</source>
        <translation>손과 발의 자취(&amp;T)</translation>
    </message>
    <message>
        <source>Centre of &amp;mass</source>
        <translation>질량 중심(&amp;M)</translation>
    </message>
    <message>
        <source>Contact f&amp;orce</source>
        <translation>접촉력(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Ghosts</source>
        <translation>잔상(&amp;G)</translation>
    </message>
    <message>
        <source>Longer trails</source>
        <translation>자취 길게</translation>
    </message>
    <message>
        <source>Shorter trails</source>
        <translation>자취 짧게</translation>
    </message>
    <message>
        <source>&amp;Leave a ghost here</source>
        <translation>여기에 잔상 남기기(&amp;L)</translation>
    </message>
    <message>
        <source>Remove all ghosts</source>
        <translation>모든 잔상 제거</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>측정(&amp;A)</translation>
    </message>
    <message>
        <source>Measure: next joint</source>
        <translation>측정: 다음 관절</translation>
    </message>
    <message>
        <source>Measure: joint before</source>
        <translation>측정: 이전 관절</translation>
    </message>
    <message>
        <source>Measure from, then to this joint</source>
        <translation>이 관절에서, 다음은 이 관절까지 측정</translation>
    </message>
    <message>
        <source>Leave measuring</source>
        <translation>측정 끝내기</translation>
    </message>
    <message>
        <source>Co&amp;py a picture</source>
        <translation>그림 복사(&amp;P)</translation>
    </message>
    <message>
        <source>Save a p&amp;icture…</source>
        <translation>그림 저장(&amp;I)…</translation>
    </message>
    <message>
        <source>Click two joints; or %1 and %2 lead to a joint, %3 takes it</source>
        <translation>관절 두 개를 클릭하세요. 또는 %1과 %2(으)로 관절에 가서 %3(으)로 선택</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageTools</name>
    <message>
        <source>Camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Where the camera stands</source>
        <translation>카메라의 위치</translation>
    </message>
    <message>
        <source>Shown in 3D</source>
        <translation>3D 표시 항목</translation>
    </message>
    <message>
        <source>What the 3D view shows</source>
        <translation>3D 보기에 표시하는 것</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>측정</translation>
    </message>
    <message>
        <source>Trails, frames</source>
        <translation>자취, 프레임</translation>
    </message>
    <message>
        <source>Frames of trail before the shown one</source>
        <translation>현재 프레임 앞의 자취 프레임 수</translation>
    </message>
    <message>
        <source>Frames of trail after the shown one</source>
        <translation>현재 프레임 뒤의 자취 프레임 수</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageView</name>
    <message>
        <source>3D view</source>
        <translation>3D 보기</translation>
    </message>
    <message>
        <source>The fighters at the playhead: a drag turns, the wheel zooms</source>
        <translation>재생 헤드 위치의 선수들. 끌어서 회전, 휠로 확대/축소</translation>
    </message>
    <message>
        <source>before the action</source>
        <translation>동작 전</translation>
    </message>
    <message>
        <source>after the action</source>
        <translation>동작 후</translation>
    </message>
    <message>
        <source>grid 1 m</source>
        <translation>격자 1 m</translation>
    </message>
    <message>
        <source>   ·   left limbs lighter</source>
        <translation>   ·   왼쪽 팔다리 밝게</translation>
    </message>
    <message>
        <source>   ·   arrow: contact force, 0.5 m per BW</source>
        <translation>   ·   화살표: 접촉력, BW당 0.5 m</translation>
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
        <translation>%1, %2에서 %3까지</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1, %2에서</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>%1에서</translation>
    </message>
    <message>
        <source>No joint is chosen. %1</source>
        <translation>선택한 관절이 없습니다. %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StatisticsBox</name>
    <message>
        <source>actions</source>
        <translation>동작</translation>
    </message>
    <message>
        <source>Actions that the stream is cut into</source>
        <translation>흐름을 나눈 동작의 수</translation>
    </message>
    <message>
        <source>min/s</source>
        <translation>극소/s</translation>
    </message>
    <message>
        <source>Minima a second that cut by themselves</source>
        <translation>그 자체로 경계가 된 초당 극소점 수</translation>
    </message>
    <message>
        <source>corr.</source>
        <translation>수정</translation>
    </message>
    <message>
        <source>Share of boundaries that a hand removed, moved or added</source>
        <translation>수동으로 제거, 이동, 추가한 경계의 비율</translation>
    </message>
    <message>
        <source>left</source>
        <translation>남음</translation>
    </message>
    <message>
        <source>Suspects that nobody has decided yet. Every decision teaches what is suspect, so that others may be cleared, too</source>
        <translation>아직 아무도 결정하지 않은 의심점. 결정할 때마다 무엇이 의심스러운지 학습하므로 다른 것도 함께 해결될 수 있습니다</translation>
    </message>
    <message>
        <source>take</source>
        <translation>테이크</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SurpriseStrip</name>
    <message>
        <source>Surprise of the transitions</source>
        <translation>전이의 의외도</translation>
    </message>
    <message>
        <source>Both terms</source>
        <translation>두 항</translation>
    </message>
    <message>
        <source>−log P(next | own, opponent, motion): seen how it moves, another label was likelier. Finds labels that are wrong.</source>
        <translation>−log P(다음 | 자기, 상대, 모션): 움직임을 보니 다른 레이블이 더 유력했습니다. 틀린 레이블을 찾습니다.</translation>
    </message>
    <message>
        <source>Label term alone</source>
        <translation>레이블 항만</translation>
    </message>
    <message>
        <source>−log P(next | own, opponent): a label that seldom follows. Finds rare decisions.</source>
        <translation>−log P(다음 | 자기, 상대): 드물게 뒤따르는 레이블. 드문 결정을 찾습니다.</translation>
    </message>
    <message>
        <source>Geometry term alone</source>
        <translation>기하 항만</translation>
    </message>
    <message>
        <source>−log density of places, facing and poses under the label, from its mean: no probability. Finds odd poses and places.</source>
        <translation>레이블에 따른 위치, 방향, 포즈의 −log 밀도, 평균 기준. 확률이 아닙니다. 특이한 포즈와 위치를 찾습니다.</translation>
    </message>
    <message>
        <source>How unexpected each transition was to a model that had not seen it, in nats.
%1</source>
        <translation>각 전이를 본 적 없는 모델에 그 전이가 얼마나 의외였는지(나트).
%1</translation>
    </message>
    <message>
        <source>Which surprise is shown</source>
        <translation>표시할 의외도</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>의외도</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 → %4 while %5   ·   %6</source>
        <translation>%1 · %2 · %3 → %4, 상대 %5   ·   %6</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SuspectsModel</name>
    <message>
        <source>, removed</source>
        <translation>, 제거됨</translation>
    </message>
    <message>
        <source>, accepted</source>
        <translation>, 수락됨</translation>
    </message>
    <message>
        <source>, set by hand</source>
        <translation>, 수동으로 지정</translation>
    </message>
    <message>
        <source>%1, suspicion %2: %3</source>
        <translation>%1, 의심도 %2: %3</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>What speaks against the minimum, and how deep it is</source>
        <translation>극소점을 의심하게 하는 것과 그 깊이</translation>
    </message>
    <message>
        <source>How likely the minimum is spurious, learnt from what hands removed and accepted; ✓ accepted or set by hand, × removed</source>
        <translation>극소점이 가짜일 가능성. 수동으로 제거하고 수락한 것에서 학습합니다. ✓ 수락했거나 수동으로 지정, × 제거됨</translation>
    </message>
    <message>
        <source>time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>why</source>
        <translation>이유</translation>
    </message>
    <message>
        <source>susp.</source>
        <translation>의심도</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TakesList</name>
    <message>
        <source>%1
Double-click or F2 renames, Alt+↑ ↓ or a drag moves it.</source>
        <translation>%1
두 번 클릭 또는 F2로 이름을 바꾸고, Alt+↑ ↓ 또는 끌기로 옮깁니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TimelineView</name>
    <message>
        <source>time, frame</source>
        <translation>시간, 프레임</translation>
    </message>
    <message>
        <source>time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>Release to move the boundary here, Esc to leave it, Ctrl or Alt to place it freely.</source>
        <translation>놓으면 경계를 여기로 옮깁니다. Esc로 그만두고, Ctrl 또는 Alt로 자유롭게 놓습니다.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>타임라인</translation>
    </message>
    <message>
        <source>Force curves of the fighters, the boundaries that cut them, and the actions between</source>
        <translation>선수의 힘 곡선, 그것을 나누는 경계, 그 사이의 동작</translation>
    </message>
    <message>
        <source>Preparing curves</source>
        <translation>곡선 준비 중</translation>
    </message>
    <message>
        <source>%1 · frame %2</source>
        <translation>%1 · 프레임 %2</translation>
    </message>
    <message>
        <source>%1 · %2 · frame %3</source>
        <translation>%1 · %2 · 프레임 %3</translation>
    </message>
    <message>
        <source> · action %1</source>
        <translation> · 동작 %1</translation>
    </message>
    <message>
        <source> · note: %1</source>
        <translation> · 메모: %1</translation>
    </message>
    <message>
        <source> · removed boundary</source>
        <translation> · 제거한 경계</translation>
    </message>
    <message>
        <source> · accepted boundary</source>
        <translation> · 수락한 경계</translation>
    </message>
    <message>
        <source> · moved boundary</source>
        <translation> · 옮긴 경계</translation>
    </message>
    <message>
        <source> · added boundary</source>
        <translation> · 추가한 경계</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Tour</name>
    <message>
        <source>&amp;Tour on the demo bout</source>
        <translation>데모 대련 둘러보기(&amp;T)</translation>
    </message>
    <message>
        <source>Tour: next step</source>
        <translation>둘러보기: 다음 단계</translation>
    </message>
    <message>
        <source>Tour: step before</source>
        <translation>둘러보기: 이전 단계</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>둘러보기 나가기</translation>
    </message>
    <message>
        <source>Correct a suspect</source>
        <translation>의심점 바로잡기</translation>
    </message>
    <message>
        <source>Label an action</source>
        <translation>동작에 레이블 붙이기</translation>
    </message>
    <message>
        <source>%1 leads to the action that says most; it loops. Say what it is: %2 is a left punch forward, %3 a right one; the palette shows the other keys.</source>
        <translation>%1을(를) 누르면 가장 도움이 되는 동작으로 가서 루프로 재생합니다. 무엇인지 답하세요: %2 왼손 펀치 앞으로, %3 오른손 펀치 앞으로. 다른 키는 팔레트에 있습니다.</translation>
    </message>
    <message>
        <source>Let the machine say the rest</source>
        <translation>나머지는 학습기에 맡기기</translation>
    </message>
    <message>
        <source>A machine learns from your labels. One is few: here a third of the bout can be labelled for you. Then %1 accepts all that the machine is sure of; %2 takes it back.</source>
        <translation>학습기는 사용자의 레이블에서 배웁니다. 하나로는 부족하니, 여기서는 대련의 3분의 1에 레이블을 대신 붙일 수 있습니다. 그런 다음 %1(으)로 학습기가 확신하는 것을 모두 수락하고, %2(으)로 되돌립니다.</translation>
    </message>
    <message>
        <source>Label a third for me</source>
        <translation>3분의 1 레이블 대신 붙이기</translation>
    </message>
    <message>
        <source>See what follows what</source>
        <translation>무엇이 무엇을 뒤따르는지 보기</translation>
    </message>
    <message>
        <source>A row is what goes on, a column what comes next. Click a cell: the moments behind it are listed, a click plays one. %1 leads to the most surprising moment.</source>
        <translation>행은 진행 중인 것, 열은 다음에 오는 것입니다. 셀을 클릭하면 근거 장면이 나열되고, 장면을 클릭하면 재생합니다. %1을(를) 누르면 가장 의외인 순간으로 갑니다.</translation>
    </message>
    <message>
        <source>Let them fight on</source>
        <translation>계속 싸우게 하기</translation>
    </message>
    <message>
        <source>%1 starts a bout that was never fought, made from what was learnt. Every choice stands at the right; a click takes another one. Back with %2, on otherwise with %3.</source>
        <translation>%1을(를) 누르면 배운 것으로 만든, 실제로는 없던 대련이 시작됩니다. 모든 선택이 오른쪽에 보이고, 클릭하면 다른 것을 고릅니다. %2(으)로 돌아가고, %3(으)로 다르게 계속합니다.</translation>
    </message>
    <message>
        <source>The minima of the force cut the bout into actions; a few are wrong. %1 leads to the likeliest, plays it and says why; %2 stops. %3 keeps it, %4 removes it.</source>
        <translation>힘의 극소점이 대련을 동작으로 나눕니다. 몇 개는 틀렸습니다. %1을(를) 누르면 가장 유력한 의심점으로 가서 재생하고 이유를 보여 줍니다. %2(으)로 멈추고, %3(으)로 유지하거나 %4(으)로 제거하세요.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TourBox</name>
    <message>
        <source>Back</source>
        <translation>뒤로</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ 완료</translation>
    </message>
    <message>
        <source>This step is done</source>
        <translation>이 단계를 마쳤습니다</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>나가기</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 / %2: %3</translation>
    </message>
    <message>
        <source>Tour, step %1</source>
        <translation>둘러보기, %1단계</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>마치기</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>다음</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TraceBox</name>
    <message>
        <source>Behind it</source>
        <translation>근거</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>선택 항목</translation>
    </message>
    <message>
        <source>Transitions behind it</source>
        <translation>근거가 된 전이</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>의외도</translation>
    </message>
    <message>
        <source>Choose a cell, a node, an edge or a row above: the moments behind it appear here, and a click plays them.</source>
        <translation>위에서 셀, 노드, 간선 또는 행을 고르면 근거가 된 장면이 여기에 나타나고, 클릭하면 재생합니다.</translation>
    </message>
    <message>
        <source>%1. Never seen.</source>
        <translation>%1. 관찰된 적 없음.</translation>
    </message>
    <message>
        <source>%1. Seen once.</source>
        <translation>%1. 한 번 관찰.</translation>
    </message>
    <message>
        <source>%1. Seen %2 times.</source>
        <translation>%1. %2번 관찰.</translation>
    </message>
    <message>
        <source>%1. Never seen so; these share the own label.</source>
        <translation>%1. 이렇게 관찰된 적 없음. 다음은 자기 레이블이 같습니다.</translation>
    </message>
    <message>
        <source>%1. Never seen so; these share the opponent&apos;s label.</source>
        <translation>%1. 이렇게 관찰된 적 없음. 다음은 상대 레이블이 같습니다.</translation>
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
        <translation>%1, %2: %3
%4
클릭하면 재생합니다</translation>
    </message>
    <message>
        <source>Surprise (%1), nats: how unexpected it was to a model that had not seen it</source>
        <translation>의외도(%1), 나트: 본 적 없는 모델에 얼마나 의외였는지</translation>
    </message>
    <message>
        <source>time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>own → next</source>
        <translation>자기 → 다음</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>의외도</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TrackPainter</name>
    <message>
        <source>The recording of %1 is missing. File ▸ Find recording… points to it.</source>
        <translation>%1의 녹화가 없습니다. 파일 ▸ 녹화 찾기…로 위치를 알려 주세요.</translation>
    </message>
    <message>
        <source>No contact force: this skeleton has no body that is known here. S adds boundaries by hand.</source>
        <translation>접촉력 없음: 이 골격에서 알려진 인체를 찾지 못했습니다. S로 경계를 직접 추가합니다.</translation>
    </message>
    <message>
        <source>force, BW</source>
        <translation>힘, BW</translation>
    </message>
    <message>
        <source>unsmoothed</source>
        <translation>평활화 안 함</translation>
    </message>
    <message>
        <source>COM, m</source>
        <translation>질량 중심, m</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>hands, m/s</source>
        <translation>손, m/s</translation>
    </message>
    <message>
        <source>feet, m/s</source>
        <translation>발, m/s</translation>
    </message>
    <message>
        <source>left</source>
        <translation>왼쪽</translation>
    </message>
    <message>
        <source>right</source>
        <translation>오른쪽</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TransitionBox</name>
    <message>
        <source>Transition</source>
        <translation>전이</translation>
    </message>
    <message>
        <source>The transition</source>
        <translation>이 전이</translation>
    </message>
    <message>
        <source>Ways that the transition can go</source>
        <translation>전이가 갈 수 있는 길</translation>
    </message>
    <message>
        <source>A click, or Return, takes another way</source>
        <translation>클릭하거나 Return을 누르면 다른 길로 갑니다</translation>
    </message>
    <message>
        <source>Choose a block, or the transition before it.</source>
        <translation>블록이나 그 앞의 전이를 고르세요.</translation>
    </message>
    <message>
        <source>The first block begins where it was recorded.</source>
        <translation>첫 블록은 녹화된 곳에서 시작합니다.</translation>
    </message>
    <message>
        <source>There is no transition.</source>
        <translation>전이가 없습니다.</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>모션을 만들고 있습니다.</translation>
    </message>
    <message>
        <source>straight from pose to pose</source>
        <translation>포즈에서 포즈로 곧바로</translation>
    </message>
    <message>
        <source>on a curve</source>
        <translation>곡선으로</translation>
    </message>
    <message>
        <source>along recorded clips past %1 poses</source>
        <translation>포즈 %1개를 지나 녹화된 클립을 따라</translation>
    </message>
    <message>
        <source>between poses that are alike</source>
        <translation>비슷한 포즈 사이</translation>
    </message>
    <message>
        <source>To %1: %2 s, %3%4</source>
        <translation>%1(으)로: %2 s, %3%4</translation>
    </message>
    <message>
        <source>. Locked.</source>
        <translation>. 잠김.</translation>
    </message>
    <message>
        <source>drawn by cost</source>
        <translation>비용에 따라 뽑음</translation>
    </message>
    <message>
        <source>path %1 · they meet as they are</source>
        <translation>경로 %1 · 그대로 이어짐</translation>
    </message>
    <message>
        <source>path %1 · cost %2 · clips: %3</source>
        <translation>경로 %1 · 비용 %2 · 클립: %3</translation>
    </message>
    <message>
        <source>curve (Bézier)</source>
        <translation>곡선(베지에)</translation>
    </message>
    <message>
        <source>straight, for comparison</source>
        <translation>직선, 비교용</translation>
    </message>
    <message>
        <source>Take another transition</source>
        <translation>다른 전이 쓰기</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TransportBar</name>
    <message>
        <source>Time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>프레임 %1</translation>
    </message>
    <message>
        <source>Playback speed: - slower, + faster</source>
        <translation>재생 속도: - 느리게, + 빠르게</translation>
    </message>
    <message>
        <source>Rows ▾</source>
        <translation>행 ▾</translation>
    </message>
    <message>
        <source>Rows of the timeline</source>
        <translation>타임라인의 행</translation>
    </message>
    <message>
        <source>What the timeline shows: curves, speeds, units of the ruler</source>
        <translation>타임라인에 표시하는 것: 곡선, 속도, 눈금자 단위</translation>
    </message>
    <message>
        <source>selected: boundary of %1 at %2</source>
        <translation>선택: %1의 경계, %2</translation>
    </message>
    <message>
        <source>selected: action of %1, %2 to %3</source>
        <translation>선택: %1의 동작, %2~%3</translation>
    </message>
    <message>
        <source>active: %1</source>
        <translation>활성: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::UnmatchedBox</name>
    <message>
        <source>Put boundary</source>
        <translation>경계 넣기</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>잊기</translation>
    </message>
    <message>
        <source>Corrections without a minimum</source>
        <translation>극소점이 없는 수정</translation>
    </message>
    <message>
        <source>With the present settings these corrections mean nothing any more.</source>
        <translation>현재 설정에서는 이 수정이 더는 의미가 없습니다.</translation>
    </message>
    <message>
        <source>Put a boundary by hand where the correction had one</source>
        <translation>수정에 경계가 있던 곳에 수동으로 경계를 넣습니다</translation>
    </message>
    <message>
        <source>Drop the correction from the project</source>
        <translation>프로젝트에서 이 수정을 버립니다</translation>
    </message>
</context>
<context>
    <name>kumite::studio::VersionsDialog</name>
    <message>
        <source>Restore</source>
        <translation>복원</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>사본 열기</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>버전</translation>
    </message>
    <message>
        <source>Versions, the newest first</source>
        <translation>버전, 최신순</translation>
    </message>
    <message>
        <source>States that were saved over; a double-click restores one</source>
        <translation>덮어쓴 이전 상태. 두 번 클릭하면 복원합니다</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>저장 시각</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>테이크</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>수정</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Open the chosen version as a project without a file</source>
        <translation>선택한 버전을 파일 없는 프로젝트로 열기</translation>
    </message>
    <message>
        <source>Make the chosen version the open project; undo takes it back (Enter)</source>
        <translation>선택한 버전을 현재 프로젝트로 만듭니다. 실행 취소로 되돌립니다 (Enter)</translation>
    </message>
    <message>
        <source>Leave everything as it is (Esc)</source>
        <translation>모두 그대로 두기 (Esc)</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>찾는 중…</translation>
    </message>
    <message>
        <source>Reading versions</source>
        <translation>버전 읽는 중</translation>
    </message>
    <message>
        <source>No earlier version yet. Every save keeps what the file held before; the last ten are listed here.</source>
        <translation>이전 버전이 아직 없습니다. 저장할 때마다 파일의 이전 내용을 보관하며, 마지막 열 개가 여기에 나열됩니다.</translation>
    </message>
    <message>
        <source>What the project file held before each of the last saves. Restoring is an edit: undo takes it back, and the file changes only when you save.</source>
        <translation>최근 저장 직전마다의 프로젝트 파일 내용. 복원은 편집이므로 실행 취소로 되돌릴 수 있고, 파일은 저장할 때만 바뀝니다.</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>읽을 수 없음</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WelcomePage</name>
    <message>
        <source>Cut a recorded bout into actions: both fighters in 3D over the force that they exert against the ground. Its minima are the boundaries; you correct the few that are wrong. Then say what a few actions are, and the machine says it of the rest.</source>
        <translation>녹화한 대련을 동작으로 나눕니다. 두 선수가 3D로, 그 아래에 지면을 누르는 힘이 보입니다. 힘의 극소점이 경계이며, 틀린 몇 개만 바로잡으면 됩니다. 그런 다음 동작 몇 개가 무엇인지 알려 주면 나머지는 학습기가 답합니다.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>시작하기</translation>
    </message>
    <message>
        <source>Or drop recordings (BVH, or AMC with its ASF) or a project on this window.</source>
        <translation>또는 녹화(BVH, ASF가 딸린 AMC)나 프로젝트를 이 창에 끌어다 놓으세요.</translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation>최근에 연 항목</translation>
    </message>
    <message>
        <source>Projects and recordings that you open appear here, with the day and the folder.</source>
        <translation>연 프로젝트와 녹화가 날짜, 폴더와 함께 여기에 나타납니다.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WelcomePicture</name>
    <message>
        <source>Two fighters over the curves of their contact force, which is cut into actions at its minima</source>
        <translation>접촉력 곡선 위의 두 선수. 곡선은 극소점에서 동작으로 나뉩니다</translation>
    </message>
    <message>
        <source>force</source>
        <translation>힘</translation>
    </message>
    <message>
        <source>actions</source>
        <translation>동작</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WhatIfBox</name>
    <message>
        <source>at playhead</source>
        <translation>재생 헤드 위치</translation>
    </message>
    <message>
        <source>Both labels are those of the moment that is shown</source>
        <translation>두 레이블 모두 표시된 순간의 것</translation>
    </message>
    <message>
        <source>own</source>
        <translation>자기</translation>
    </message>
    <message>
        <source>What the fighter does now</source>
        <translation>선수가 지금 하는 것</translation>
    </message>
    <message>
        <source>opponent</source>
        <translation>상대</translation>
    </message>
    <message>
        <source>What the opponent does now</source>
        <translation>상대가 지금 하는 것</translation>
    </message>
    <message>
        <source>What comes next</source>
        <translation>다음에 오는 것</translation>
    </message>
    <message>
        <source>What next?</source>
        <translation>다음은?</translation>
    </message>
    <message>
        <source>What %1 may do next, the likeliest first</source>
        <translation>%1이(가) 다음에 할 수 있는 것, 유력한 순</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>아무거나</translation>
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
        <translation>레이블 %1</translation>
    </message>
    <message>
        <source>geom. %1</source>
        <translation>기하 %1</translation>
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
        <translation>%1: P %2, 레이블 항 %3</translation>
    </message>
    <message>
        <source>, geometry term %1</source>
        <translation>, 기하 항 %1</translation>
    </message>
    <message>
        <source>
Seen %1 times with both labels, %2 with the own, %3 with the opponent&apos;s</source>
        <translation>
두 레이블 모두로 %1번, 자기 레이블로 %2번, 상대 레이블로 %3번 관찰</translation>
    </message>
    <message>
        <source>
This is what came next</source>
        <translation>
실제로 다음에 온 것입니다</translation>
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
        <translation>돌출도 %1</translation>
    </message>
    <message>
        <source>slow left kick, %1</source>
        <translation>느린 왼발 킥, %1</translation>
    </message>
    <message>
        <source>slow right kick, %1</source>
        <translation>느린 오른발 킥, %1</translation>
    </message>
    <message>
        <source>left foot moves at %1 m/s, %2</source>
        <translation>왼발이 %1 m/s로 움직임, %2</translation>
    </message>
    <message>
        <source>right foot moves at %1 m/s, %2</source>
        <translation>오른발이 %1 m/s로 움직임, %2</translation>
    </message>
    <message>
        <source>shallow, %1</source>
        <translation>얕음, %1</translation>
    </message>
    <message>
        <source>%1 s from the next minimum, %2</source>
        <translation>다음 극소점과 %1 s 거리, %2</translation>
    </message>
    <message>
        <source>hardly dips (to %1), %2</source>
        <translation>거의 내려가지 않음(%1까지), %2</translation>
    </message>
    <message>
        <source>nothing unusual, %1</source>
        <translation>특이 사항 없음, %1</translation>
    </message>
    <message>
        <source>left kick</source>
        <translation>왼발 킥</translation>
    </message>
    <message>
        <source>right kick</source>
        <translation>오른발 킥</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>왼발</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>오른발</translation>
    </message>
    <message>
        <source>shallow</source>
        <translation>얕음</translation>
    </message>
    <message>
        <source>crowded</source>
        <translation>밀집</translation>
    </message>
    <message>
        <source>hardly dips</source>
        <translation>거의 내려가지 않음</translation>
    </message>
    <message>
        <source>%1, suspicion %2</source>
        <translation>%1, 의심도 %2</translation>
    </message>
    <message>
        <source>removal at %1</source>
        <translation>제거: %1</translation>
    </message>
    <message>
        <source>addition at %1</source>
        <translation>추가: %1</translation>
    </message>
    <message>
        <source>move from %1 to %2</source>
        <translation>이동: %1 → %2</translation>
    </message>
    <message>
        <source>acceptance at %1</source>
        <translation>수락: %1</translation>
    </message>
    <message>
        <source>fighter %1</source>
        <translation>선수 %1</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>오늘 %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>어제 %1</translation>
    </message>
    <message>
        <source>Computer %1, process %2, since %3.</source>
        <translation>컴퓨터 %1, 프로세스 %2, %3부터.</translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s)</source>
        <translation>
            <numerusform>편집 %n개</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::WorkspaceBar</name>
    <message>
        <source>Workspaces</source>
        <translation>작업 공간</translation>
    </message>
    <message>
        <source>%1 workspace</source>
        <translation>%1 작업 공간</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Workspaces</name>
    <message>
        <source>%1 workspace</source>
        <translation>%1 작업 공간</translation>
    </message>
</context>
</TS>
