<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Core</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>Labels übernehmen</translation>
    </message>
    <message>
        <source>Take over labels of %1</source>
        <translation>Labels von %1 übernehmen</translation>
    </message>
    <message>
        <source>Remove boundary %1</source>
        <translation>Grenze entfernen: %1</translation>
    </message>
    <message>
        <source>Restore boundary %1</source>
        <translation>Grenze wiederherstellen: %1</translation>
    </message>
    <message>
        <source>Add boundary %1</source>
        <translation>Grenze hinzufügen: %1</translation>
    </message>
    <message>
        <source>Move boundary %1</source>
        <translation>Grenze verschieben: %1</translation>
    </message>
    <message>
        <source>Accept boundary %1</source>
        <translation>Grenze annehmen: %1</translation>
    </message>
    <message>
        <source>Change segmentation settings</source>
        <translation>Schnitteinstellungen ändern</translation>
    </message>
    <message>
        <source>Change body model to %1</source>
        <translation>Körpermodell in %1 ändern</translation>
    </message>
    <message>
        <source>Restore the version of %1</source>
        <translation>Version von %1 wiederherstellen</translation>
    </message>
    <message>
        <source>Add clips</source>
        <translation>Clips hinzufügen</translation>
    </message>
    <message>
        <source>Remove clips</source>
        <translation>Clips entfernen</translation>
    </message>
    <message>
        <source>Add take %1</source>
        <translation>Take %1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove take %1</source>
        <translation>Take %1 entfernen</translation>
    </message>
    <message>
        <source>Rename take to %1</source>
        <translation>Take in %1 umbenennen</translation>
    </message>
    <message>
        <source>Move take %1 to place %2</source>
        <translation>Take %1 an Platz %2 verschieben</translation>
    </message>
    <message>
        <source>Swap fighters</source>
        <translation>Kämpfer tauschen</translation>
    </message>
    <message>
        <source>Change time offset, fighter %1</source>
        <translation>Zeitversatz ändern, Kämpfer %1</translation>
    </message>
    <message>
        <source>Change floor, fighter %1</source>
        <translation>Boden ändern, Kämpfer %1</translation>
    </message>
    <message>
        <source>Change role %1, fighter %2</source>
        <translation>Rolle %1 ändern, Kämpfer %2</translation>
    </message>
    <message>
        <source>Relink recording, fighter %1</source>
        <translation>Aufnahme neu verknüpfen, Kämpfer %1</translation>
    </message>
    <message>
        <source>Keep bout as take %1</source>
        <translation>Kampf als Take %1 behalten</translation>
    </message>
    <message>
        <source>Keep motion as take %1</source>
        <translation>Bewegung als Take %1 behalten</translation>
    </message>
    <message>
        <source>Label action %1, fighter %2: %3</source>
        <translation>Aktion %1 labeln, Kämpfer %2: %3</translation>
    </message>
    <message>
        <source>Label action %1, fighter %2</source>
        <translation>Aktion %1 labeln, Kämpfer %2</translation>
    </message>
    <message>
        <source>Label %1 actions, fighter %2: %3</source>
        <translation>%1 Aktionen labeln, Kämpfer %2: %3</translation>
    </message>
    <message>
        <source>Label %1 actions, fighter %2</source>
        <translation>%1 Aktionen labeln, Kämpfer %2</translation>
    </message>
    <message>
        <source>Label %1 actions: %2</source>
        <translation>%1 Aktionen labeln: %2</translation>
    </message>
    <message>
        <source>Label %1 actions</source>
        <translation>%1 Aktionen labeln</translation>
    </message>
    <message>
        <source>Clear label, action %1, fighter %2</source>
        <translation>Label löschen, Aktion %1, Kämpfer %2</translation>
    </message>
    <message>
        <source>Clear label, %1 actions, fighter %2</source>
        <translation>Label löschen, %1 Aktionen, Kämpfer %2</translation>
    </message>
    <message>
        <source>Accept labels</source>
        <translation>Labels annehmen</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>Labels importieren</translation>
    </message>
    <message>
        <source>Merge labels</source>
        <translation>Labels zusammenführen</translation>
    </message>
    <message>
        <source>Change vocabulary to %1</source>
        <translation>Vokabular in %1 ändern</translation>
    </message>
    <message>
        <source>Change rules</source>
        <translation>Regeln ändern</translation>
    </message>
    <message>
        <source>Change learning settings</source>
        <translation>Lerneinstellungen ändern</translation>
    </message>
    <message>
        <source>Keep model</source>
        <translation>Modell behalten</translation>
    </message>
    <message>
        <source>Remove note %1</source>
        <translation>Notiz entfernen: %1</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>Notiz: %1</translation>
    </message>
    <message>
        <source>Accept what rules say</source>
        <translation>Annehmen, was Regeln sagen</translation>
    </message>
    <message>
        <source>Accept 1 label</source>
        <translation>1 Label annehmen</translation>
    </message>
    <message>
        <source>Accept %1 labels</source>
        <translation>%1 Labels annehmen</translation>
    </message>
    <message>
        <source>at %1, fighter %2</source>
        <translation>bei %1, Kämpfer %2</translation>
    </message>
    <message>
        <source>A model of two fighters needs a take with two of them.</source>
        <translation>Ein Modell zweier Kämpfer braucht einen Take mit zweien.</translation>
    </message>
    <message>
        <source>No action is labelled yet: label some by hand and let the machine do the rest, or import labels.</source>
        <translation>Noch ist keine Aktion gelabelt: einige von Hand labeln und die Maschine den Rest machen lassen oder Labels importieren.</translation>
    </message>
    <message>
        <source>No transition has the labels of all its three actions: label more of both fighters.</source>
        <translation>Kein Übergang hat die Labels aller drei Aktionen: mehr von beiden Kämpfern labeln.</translation>
    </message>
    <message>
        <source>cannot be read: %1.</source>
        <translation>kann nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>cannot read: %1.</source>
        <translation>Lesen nicht möglich: %1.</translation>
    </message>
    <message>
        <source>cannot write: %1.</source>
        <translation>Schreiben nicht möglich: %1.</translation>
    </message>
    <message>
        <source>cannot make this folder: %1.</source>
        <translation>dieser Ordner kann nicht angelegt werden: %1.</translation>
    </message>
    <message>
        <source>is a folder, expected a file.</source>
        <translation>ist ein Ordner, erwartet wird eine Datei.</translation>
    </message>
    <message>
        <source>is no regular file; save it as one first.</source>
        <translation>ist keine gewöhnliche Datei; speichern Sie sie erst als solche.</translation>
    </message>
    <message>
        <source>is a folder, expected a file to write.</source>
        <translation>ist ein Ordner; zum Schreiben wird eine Datei erwartet.</translation>
    </message>
    <message>
        <source>is what is read here; write to another file.</source>
        <translation>wird hier selbst gelesen; schreiben Sie in eine andere Datei.</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>Every motion has too few frames for %1 key poses.</source>
        <translation>Keine Bewegung hat genug Frames für %1 Schlüsselposen.</translation>
    </message>
    <message>
        <source>There is no frame of %1 to write.</source>
        <translation>Von %1 gibt es kein Frame zu schreiben.</translation>
    </message>
    <message>
        <source>The file holds %1 skeletons: %2. The first is read unless --root names another.</source>
        <translation>Die Datei enthält %1 Skelette: %2. Gelesen wird das erste, sofern --root kein anderes nennt.</translation>
    </message>
    <message>
        <source>found several skeletons beside it (%1), expected one (name it with --asf)</source>
        <translation>daneben liegen mehrere Skelette (%1), erwartet wird eines (mit --asf angeben)</translation>
    </message>
    <message>
        <source>found %1, expected %2</source>
        <translation>gefunden: %1, erwartet: %2</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>das Ende der Datei</translation>
    </message>
    <message>
        <source>only the %1 channels that CHANNELS announces</source>
        <translation>nur die %1 Kanäle, die CHANNELS ankündigt</translation>
    </message>
    <message>
        <source>A split by takes needs two takes or more with labelled transitions.</source>
        <translation>Eine Aufteilung nach Takes braucht mindestens zwei Takes mit gelabelten Übergängen.</translation>
    </message>
    <message>
        <source>There are too few labelled transitions to set some apart.</source>
        <translation>Es gibt zu wenige gelabelte Übergänge, um einige davon zurückzuhalten.</translation>
    </message>
    <message>
        <source>For labelling, these joints take their parents&apos; place: %1.</source>
        <translation>Beim Labeln stehen für diese Gelenke ihre Elterngelenke: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no aspect of the vocabulary %2.</source>
        <translation>„%1“ nennt keinen Aspekt des Vokabulars %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no qualifier of %2.</source>
        <translation>„%1“ nennt keinen Zusatz von %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names an aspect twice.</source>
        <translation>„%1“ nennt einen Aspekt zweimal.</translation>
    </message>
    <message>
        <source>After %1 a confidence is expected, such as 0.6 or 60 %.</source>
        <translation>Nach %1 wird eine Sicherheit erwartet, etwa 0.6 oder 60 %.</translation>
    </message>
    <message>
        <source>After %1 a confidence is expected, such as 0.6 or 60 %, not %2.</source>
        <translation>Nach %1 wird eine Sicherheit erwartet, etwa 0.6 oder 60 %, nicht %2.</translation>
    </message>
    <message>
        <source>Say whether the confidence is &quot;below %1&quot; or &quot;above %1&quot;.</source>
        <translation>Sagen Sie, ob die Sicherheit darunter („below %1“) oder darüber („above %1“) liegt.</translation>
    </message>
    <message>
        <source>After %1 a time is expected, such as %2.</source>
        <translation>Nach %1 wird eine Zeit erwartet, etwa %2.</translation>
    </message>
    <message>
        <source>After %1 a time is expected, such as %2, not %3.</source>
        <translation>Nach %1 wird eine Zeit erwartet, etwa %2, nicht %3.</translation>
    </message>
    <message>
        <source>After %1 two times are expected, such as 0:30 to 1:00.</source>
        <translation>Nach %1 werden zwei Zeiten erwartet, etwa 0:30 to 1:00.</translation>
    </message>
    <message>
        <source>After %1 1 or 2 is expected.</source>
        <translation>Nach %1 wird 1 oder 2 erwartet.</translation>
    </message>
    <message>
        <source>After %1 1 or 2 is expected, not %2.</source>
        <translation>Nach %1 wird 1 oder 2 erwartet, nicht %2.</translation>
    </message>
    <message>
        <source>There is no take %1; the takes are %2.</source>
        <translation>Einen Take %1 gibt es nicht; die Takes sind %2.</translation>
    </message>
    <message>
        <source>Say which take; the takes are %1.</source>
        <translation>Sagen Sie, welcher Take; die Takes sind %1.</translation>
    </message>
    <message>
        <source>No aspect has a &quot;strike&quot;: %1 will never find anything to react to.</source>
        <translation>Kein Aspekt hat „strike“: %1 wird nie etwas finden, worauf zu reagieren wäre.</translation>
    </message>
    <message>
        <source>The key %1 stands for both %2 and %3.</source>
        <translation>Die Taste %1 steht für %2 und zugleich für %3.</translation>
    </message>
    <message>
        <source>In %1 the key %2 stands for both %3 and %4.</source>
        <translation>In %1 steht die Taste %2 für %3 und zugleich für %4.</translation>
    </message>
    <message>
        <source>The target has no %1: their turns go to the joints below them.</source>
        <translation>Dem Zielskelett fehlt %1: Die Drehungen gehen an die Gelenke darunter.</translation>
    </message>
    <message>
        <source>The source has no %1: they keep their rest relative to their parent.</source>
        <translation>Dem Quellskelett fehlt %1: Diese Gelenke behalten ihre Ruhelage gegenüber dem Elterngelenk.</translation>
    </message>
    <message>
        <source>No joint was found for: %1.</source>
        <translation>Kein Gelenk gefunden für: %1.</translation>
    </message>
    <message>
        <source>Joint %1 does not stand behind its parent.</source>
        <translation>Gelenk %1 steht nicht hinter seinem Elterngelenk.</translation>
    </message>
    <message>
        <source>The channels of joint %1 do not follow the ones before.</source>
        <translation>Die Kanäle von Gelenk %1 schließen nicht an die vorigen an.</translation>
    </message>
    <message>
        <source>The End Site %1 has channels.</source>
        <translation>End Site %1 hat Kanäle.</translation>
    </message>
    <message>
        <source>The offset of joint %1 is not a finite number.</source>
        <translation>Der Offset von Gelenk %1 ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>Frame 0 is a rest pose, not motion; takes leave it out.</source>
        <translation>Frame 0 ist eine Ruhepose, keine Bewegung; Takes lassen es weg.</translation>
    </message>
    <message>
        <source>Frames 0 to %1 are a rest pose, not motion; takes leave them out.</source>
        <translation>Frames 0 bis %1 sind eine Ruhepose, keine Bewegung; Takes lassen sie weg.</translation>
    </message>
    <message>
        <source>Fighter %1 has no boundary near frame %2.</source>
        <translation>Kämpfer %1 hat keine Grenze nahe Frame %2.</translation>
    </message>
    <message>
        <source>Fighter %1 has no boundary near frame %2; the nearest is at %3.</source>
        <translation>Kämpfer %1 hat keine Grenze nahe Frame %2; die nächste ist bei %3.</translation>
    </message>
    <message>
        <source>the recording is missing; its boundaries cannot be edited.</source>
        <translation>die Aufnahme fehlt; ihre Grenzen lassen sich nicht bearbeiten.</translation>
    </message>
    <message>
        <source>A time offset must be a number.</source>
        <translation>Ein Zeitversatz muss eine Zahl sein.</translation>
    </message>
    <message>
        <source>A placement must be a number.</source>
        <translation>Eine Ortsangabe muss eine Zahl sein.</translation>
    </message>
    <message>
        <source>The floor&apos;s height must be a number.</source>
        <translation>Die Höhe des Bodens muss eine Zahl sein.</translation>
    </message>
    <message>
        <source>There is a take named &quot;%1&quot; already.</source>
        <translation>Einen Take namens „%1“ gibt es schon.</translation>
    </message>
    <message>
        <source>%1 has another skeleton: it is not the recording that is missing.</source>
        <translation>%1 hat ein anderes Skelett: Das ist nicht die fehlende Aufnahme.</translation>
    </message>
    <message>
        <source>the suffix says what to write, expected .bvh, .glb, .npz, .csv, .json or .eaf.</source>
        <translation>die Endung sagt, was geschrieben wird; erwartet: .bvh, .glb, .npz, .csv, .json oder .eaf.</translation>
    </message>
    <message>
        <source>the recording is missing; the take cannot be written without it.</source>
        <translation>die Aufnahme fehlt; ohne sie lässt sich der Take nicht schreiben.</translation>
    </message>
    <message>
        <source>a graph is written as .csv, .json or .graphml.</source>
        <translation>ein Graph wird als .csv, .json oder .graphml geschrieben.</translation>
    </message>
    <message>
        <source>there is no joint named &quot;%1&quot;; there is: %2.</source>
        <translation>ein Gelenk namens „%1“ gibt es nicht; es gibt: %2.</translation>
    </message>
    <message>
        <source>the name holds bytes that are no UTF-8 text; rename the file or folder.</source>
        <translation>der Name enthält Bytes, die kein UTF-8-Text sind; benennen Sie die Datei oder den Ordner um.</translation>
    </message>
    <message>
        <source>the key pose of clip &quot;%1&quot; is not in the project</source>
        <translation>die Schlüsselpose aus Clip „%1“ ist nicht im Projekt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no source.</source>
        <translation>„%1“ ist keine Quelle.</translation>
    </message>
    <message>
        <source>labels are written as .csv, .json or .eaf.</source>
        <translation>Labels werden als .csv, .json oder .eaf geschrieben.</translation>
    </message>
    <message>
        <source>labels are read from .csv, .json and .eaf files.</source>
        <translation>Labels werden aus .csv-, .json- und .eaf-Dateien gelesen.</translation>
    </message>
    <message>
        <source>the project has no take &quot;%1&quot;.</source>
        <translation>das Projekt hat keinen Take „%1“.</translation>
    </message>
    <message>
        <source>the take has no such fighter.</source>
        <translation>diesen Kämpfer hat der Take nicht.</translation>
    </message>
    <message>
        <source>no action there.</source>
        <translation>dort ist keine Aktion.</translation>
    </message>
    <message>
        <source>its action takes the label of %1.</source>
        <translation>seine Aktion bekommt das Label von %1.</translation>
    </message>
    <message>
        <source>no joint has the role pelvis, so its actions cannot be compared.</source>
        <translation>kein Gelenk hat die Rolle Becken, daher lassen sich die Aktionen nicht vergleichen.</translation>
    </message>
    <message>
        <source>the recording is missing; its actions cannot be labelled.</source>
        <translation>die Aufnahme fehlt; ihre Aktionen lassen sich nicht labeln.</translation>
    </message>
    <message>
        <source>has no body with two legs; it is left out.</source>
        <translation>hat keinen Körper mit zwei Beinen und wird weggelassen.</translation>
    </message>
    <message>
        <source>%1 It is left out.</source>
        <translation>%1 Das wird weggelassen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: expected frames as A:B after the @.</source>
        <translation>„%1“: Nach dem @ werden Frames als A:B erwartet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: these frames are not in it; it has %2 to %3.</source>
        <translation>„%1“: Diese Frames hat die Aktion nicht; sie hat %2 bis %3.</translation>
    </message>
    <message>
        <source>No action of the library is labelled &quot;%1&quot;.</source>
        <translation>Keine Aktion der Bibliothek hat das Label „%1“.</translation>
    </message>
    <message>
        <source>No action of the library is labelled &quot;%1&quot; of that player.</source>
        <translation>Keine Aktion dieses Kämpfers in der Bibliothek hat das Label „%1“.</translation>
    </message>
    <message>
        <source>None of these clips is of that player.</source>
        <translation>Keiner dieser Clips ist von diesem Kämpfer.</translation>
    </message>
    <message>
        <source>joint &quot;%1&quot; is gone; the role %2 has no joint now.</source>
        <translation>das Gelenk „%1“ gibt es nicht mehr; die Rolle %2 hat jetzt kein Gelenk.</translation>
    </message>
    <message>
        <source>%1 The recording is left out; its corrections are kept.</source>
        <translation>%1 Die Aufnahme wird weggelassen; ihre Korrekturen bleiben erhalten.</translation>
    </message>
    <message>
        <source>the recording is missing; put it back or relink it. Its corrections are kept.</source>
        <translation>die Aufnahme fehlt; legen Sie sie zurück, oder verknüpfen Sie sie neu. Ihre Korrekturen bleiben erhalten.</translation>
    </message>
    <message>
        <source>the recording has changed since it became part of the project; check the boundaries, then relink it to accept the change.</source>
        <translation>die Aufnahme hat sich geändert, seit sie zum Projekt gehört; prüfen Sie die Grenzen, und verknüpfen Sie sie dann neu, um die Änderung anzunehmen.</translation>
    </message>
    <message>
        <source>the recording is missing; the take cannot be shown without it.</source>
        <translation>die Aufnahme fehlt; ohne sie lässt sich der Take nicht zeigen.</translation>
    </message>
    <message>
        <source>There is no take named &quot;%1&quot;; the project has none.</source>
        <translation>Einen Take namens „%1“ gibt es nicht; das Projekt hat gar keinen.</translation>
    </message>
    <message>
        <source>There is no take named &quot;%1&quot;; there is: %2.</source>
        <translation>Einen Take namens „%1“ gibt es nicht; es gibt: %2.</translation>
    </message>
    <message>
        <source>no contact force without a body; no joint has the role %1.</source>
        <translation>keine Kontaktkraft ohne Körper; kein Gelenk hat die Rolle %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; of fighter %2 is no correction without a minimum.</source>
        <translation>„%1“ von Kämpfer %2 ist keine Korrektur ohne Minimum.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; leaves no boundary that could be added.</source>
        <translation>„%1“ hinterlässt keine Grenze, die sich hinzufügen ließe.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be reached: the nearest target that can is %2.</source>
        <translation>„%1“ ist nicht erreichbar: Das nächste erreichbare Ziel ist %2.</translation>
    </message>
    <message>
        <source>What was saved before could not be kept. %1</source>
        <translation>Der vorige Stand der Datei ließ sich nicht aufheben. %1</translation>
    </message>
    <message>
        <source>holds %1 frames only; the take ends there for this fighter.</source>
        <translation>enthält nur %1 Frames; für diesen Kämpfer endet der Take dort.</translation>
    </message>
    <message>
        <source>holds %1 frames now, the take begins at frame %2; the recording is left out.</source>
        <translation>enthält jetzt %1 Frames, der Take beginnt bei Frame %2; die Aufnahme wird weggelassen.</translation>
    </message>
    <message>
        <source>holds %1 frames now; the take ends there.</source>
        <translation>enthält jetzt %1 Frames; der Take endet dort.</translation>
    </message>
    <message>
        <source>a cutoff of %1 Hz smooths nothing at %2 frames a second; choose one below %3 Hz.</source>
        <translation>eine Grenzfrequenz von %1 Hz glättet bei %2 Frames pro Sekunde nichts; wählen Sie eine unter %3 Hz.</translation>
    </message>
    <message>
        <source>the annotation &quot;%1&quot; has no time and is left out.</source>
        <translation>die Annotation „%1“ hat keine Zeit und wird weggelassen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no action that can be asked for; there are %2, what they strike with, and ASPECT:QUALIFIER.</source>
        <translation>„%1“ ist keine Aktion, die man sich wünschen kann; es gibt %2, womit sie treffen, und ASPEKT:ZUSATZ.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing.</source>
        <translation>„%1“ fehlt.</translation>
    </message>
    <message>
        <source>expected a list.</source>
        <translation>eine Liste wird erwartet.</translation>
    </message>
    <message>
        <source>expected an object.</source>
        <translation>ein Objekt wird erwartet.</translation>
    </message>
    <message>
        <source>expected a whole number.</source>
        <translation>eine ganze Zahl wird erwartet.</translation>
    </message>
    <message>
        <source>expected a number.</source>
        <translation>eine Zahl wird erwartet.</translation>
    </message>
    <message>
        <source>expected a finite number.</source>
        <translation>eine endliche Zahl wird erwartet.</translation>
    </message>
    <message>
        <source>expected a number above 0.</source>
        <translation>eine Zahl über 0 wird erwartet.</translation>
    </message>
    <message>
        <source>expected true or false.</source>
        <translation>true oder false wird erwartet.</translation>
    </message>
    <message>
        <source>expected text.</source>
        <translation>Text wird erwartet.</translation>
    </message>
    <message>
        <source>expected 0 or more.</source>
        <translation>0 oder mehr wird erwartet.</translation>
    </message>
    <message>
        <source>expected [begin, end] with 0 &lt;= begin &lt; end.</source>
        <translation>[begin, end] mit 0 &lt;= begin &lt; end wird erwartet.</translation>
    </message>
    <message>
        <source>expected an object with &quot;key_poses&quot;: 1, &quot;rate&quot; and &quot;keys&quot;.</source>
        <translation>ein Objekt mit &quot;key_poses&quot;: 1, &quot;rate&quot; und &quot;keys&quot; wird erwartet.</translation>
    </message>
    <message>
        <source>expected a colour like #3a86d8.</source>
        <translation>eine Farbe wie #3a86d8 wird erwartet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no joint role.</source>
        <translation>„%1“ ist keine Gelenkrolle.</translation>
    </message>
    <message>
        <source>is no joint role.</source>
        <translation>ist keine Gelenkrolle.</translation>
    </message>
    <message>
        <source>is no vocabulary: it has no &quot;vocabulary&quot; version.</source>
        <translation>ist kein Vokabular: Die Versionsangabe „vocabulary“ fehlt.</translation>
    </message>
    <message>
        <source>is the id of two qualifiers.</source>
        <translation>ist die ID zweier Zusätze.</translation>
    </message>
    <message>
        <source>is the id of two aspects.</source>
        <translation>ist die ID zweier Aspekte.</translation>
    </message>
    <message>
        <source>is the name of two takes.</source>
        <translation>ist der Name zweier Takes.</translation>
    </message>
    <message>
        <source>a take has one or two fighters.</source>
        <translation>ein Take hat einen oder zwei Kämpfer.</translation>
    </message>
    <message>
        <source>a vocabulary has one aspect or more.</source>
        <translation>ein Vokabular hat mindestens einen Aspekt.</translation>
    </message>
    <message>
        <source>an aspect has two qualifiers or more.</source>
        <translation>ein Aspekt hat mindestens zwei Zusätze.</translation>
    </message>
    <message>
        <source>is none of the qualifiers.</source>
        <translation>ist keiner der Zusätze.</translation>
    </message>
    <message>
        <source>there is no aspect &quot;%1&quot;.</source>
        <translation>einen Aspekt „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>The system&apos;s OpenSSL library cannot compute SHA-256.</source>
        <translation>Die OpenSSL-Bibliothek des Systems kann SHA-256 nicht berechnen.</translation>
    </message>
    <message>
        <source>A demo bout lasts from 1 second to 24 hours; %1 seconds were asked for.</source>
        <translation>Ein Demo-Kampf dauert zwischen 1 Sekunde und 24 Stunden; verlangt waren %1 Sekunden.</translation>
    </message>
    <message>
        <source>A demo bout has 24 to 240 frames a second; %1 were asked for.</source>
        <translation>Ein Demo-Kampf hat 24 bis 240 Frames pro Sekunde; verlangt waren %1.</translation>
    </message>
    <message>
        <source>There is no key pose to make a motion of.</source>
        <translation>Es gibt keine Schlüsselpose, aus der eine Bewegung werden könnte.</translation>
    </message>
    <message>
        <source>The library holds no motion.</source>
        <translation>Die Bibliothek enthält keine Bewegung.</translation>
    </message>
    <message>
        <source>There is no key at frame %1.</source>
        <translation>Bei Frame %1 steht keine Schlüsselpose.</translation>
    </message>
    <message>
        <source>Frame %1 is not behind the key before.</source>
        <translation>Frame %1 liegt nicht hinter der vorigen Schlüsselpose.</translation>
    </message>
    <message>
        <source>Keys can be brought nearer or farther by a factor above 0 only.</source>
        <translation>Schlüsselposen lassen sich nur mit einem Faktor über 0 enger oder weiter stellen.</translation>
    </message>
    <message>
        <source>Keys cannot be brought that far.</source>
        <translation>So weit lassen sich Schlüsselposen nicht verschieben.</translation>
    </message>
    <message>
        <source>Key poses need a skeleton.</source>
        <translation>Schlüsselposen brauchen ein Skelett.</translation>
    </message>
    <message>
        <source>Key poses need a rate above 0.</source>
        <translation>Schlüsselposen brauchen eine Rate über 0.</translation>
    </message>
    <message>
        <source>The key at frame %1 is a pose of another skeleton.</source>
        <translation>Die Schlüsselpose bei Frame %1 gehört zu einem anderen Skelett.</translation>
    </message>
    <message>
        <source>The key at frame %1 comes after one at frame %2.</source>
        <translation>Die Schlüsselpose bei Frame %1 steht hinter einer bei Frame %2.</translation>
    </message>
    <message>
        <source>Frames %1:%2 are not in the take, which has %3.</source>
        <translation>Die Frames %1:%2 liegen nicht im Take; er hat %3.</translation>
    </message>
    <message>
        <source>The part comes from another skeleton.</source>
        <translation>Der Teil stammt von einem anderen Skelett.</translation>
    </message>
    <message>
        <source>Frames %1 to %2 are not in the source, which has %3.</source>
        <translation>Die Frames %1 bis %2 liegen nicht in der Quelle; sie hat %3.</translation>
    </message>
    <message>
        <source>There is no key pose to look for.</source>
        <translation>Es gibt keine Schlüsselpose, nach der sich suchen ließe.</translation>
    </message>
    <message>
        <source>At most 1000 key poses can be looked for.</source>
        <translation>Suchen lassen sich höchstens 1000 Schlüsselposen.</translation>
    </message>
    <message>
        <source>Every key pose needs its features and its frame.</source>
        <translation>Jede Schlüsselpose braucht ihre Merkmale und ihr Frame.</translation>
    </message>
    <message>
        <source>Key poses must stand in the order of their frames, one per frame.</source>
        <translation>Schlüsselposen müssen in der Folge ihrer Frames stehen, eine je Frame.</translation>
    </message>
    <message>
        <source>Two examples of the strike cannot be aligned in time.</source>
        <translation>Zwei Beispiele der Technik lassen sich zeitlich nicht ausrichten.</translation>
    </message>
    <message>
        <source>There is no example of the strike to blend.</source>
        <translation>Es gibt kein Beispiel der Technik zum Mischen.</translation>
    </message>
    <message>
        <source>The skeleton has no %1: its roles tell nothing that could hit.</source>
        <translation>Dem Skelett fehlt %1: Seine Rollen nennen nichts, was treffen könnte.</translation>
    </message>
    <message>
        <source>Strike &quot;%1&quot; is of another skeleton.</source>
        <translation>Die Technik „%1“ gehört zu einem anderen Skelett.</translation>
    </message>
    <message>
        <source>Feature poses must come in pairs, one of the query and one of the clip.</source>
        <translation>Merkmalsposen müssen paarweise kommen, eine der Anfrage und eine des Clips.</translation>
    </message>
    <message>
        <source>Feature poses must follow each other in time.</source>
        <translation>Merkmalsposen müssen zeitlich aufeinander folgen.</translation>
    </message>
    <message>
        <source>An AMC file does not say its frame rate: 120 Hz is assumed; give another with --rate.</source>
        <translation>Eine AMC-Datei nennt ihre Framerate nicht: 120 Hz werden angenommen; mit --rate geben Sie eine andere an.</translation>
    </message>
    <message>
        <source>Frame %1, the last, is cut: it is dropped.</source>
        <translation>Frame %1, das letzte, ist unvollständig und entfällt.</translation>
    </message>
    <message>
        <source>Frame %1 does not follow the one before it by number: the frames are taken one after the other.</source>
        <translation>Frame %1 folgt der Nummer nach nicht auf das vorige: Die Frames werden der Reihe nach genommen.</translation>
    </message>
    <message>
        <source>found %1 numbers, expected %2 for bone %3 in frame %4</source>
        <translation>gefunden: %1 Zahlen, erwartet: %2 für Knochen %3 in Frame %4</translation>
    </message>
    <message>
        <source>found no line for bone %1 in frame %2, expected one for each bone with a dof</source>
        <translation>keine Zeile für Knochen %1 in Frame %2 gefunden, erwartet: eine für jeden Knochen mit dof</translation>
    </message>
    <message>
        <source>found %1, expected a unit of length greater than zero</source>
        <translation>gefunden: %1, erwartet: eine Längeneinheit größer als null</translation>
    </message>
    <message>
        <source>found a bone without name, expected one</source>
        <translation>Knochen ohne Namen gefunden, erwartet: ein Name</translation>
    </message>
    <message>
        <source>found a second bone %1, expected one</source>
        <translation>zweiter Knochen %1 gefunden, erwartet: nur einer</translation>
    </message>
    <message>
        <source>found bone %1 a second time, expected one parent for each</source>
        <translation>Knochen %1 ein zweites Mal gefunden, erwartet: nur ein Elternknochen für jeden</translation>
    </message>
    <message>
        <source>found bone %1 that does not hang on the root, expected it in :hierarchy</source>
        <translation>Knochen %1 hängt nicht an der Wurzel, erwartet: ein Eintrag in :hierarchy</translation>
    </message>
    <message>
        <source>found a skeleton without any dof, expected an order for the root</source>
        <translation>Skelett ganz ohne dof gefunden, erwartet: eine Angabe order für die Wurzel</translation>
    </message>
    <message>
        <source>Bone %1 changes its length: that is not used.</source>
        <translation>Knochen %1 ändert seine Länge: Das wird nicht verwendet.</translation>
    </message>
    <message>
        <source>found more joints than a skeleton can have, expected %1 at most</source>
        <translation>mehr Gelenke gefunden, als ein Skelett haben kann, erwartet: höchstens %1</translation>
    </message>
    <message>
        <source>%1 has no OFFSET: taken as 0 0 0.</source>
        <translation>%1 hat kein OFFSET: 0 0 0 wird angenommen.</translation>
    </message>
    <message>
        <source>%1 has channels or children: read as a joint.</source>
        <translation>%1 hat Kanäle oder Kinder: als Gelenk gelesen.</translation>
    </message>
    <message>
        <source>found a second %1, expected one in joint %2</source>
        <translation>%1 ein zweites Mal gefunden, erwartet: nur einmal in Gelenk %2</translation>
    </message>
    <message>
        <source>found a skeleton without any channel, expected CHANNELS</source>
        <translation>Skelett ohne einen einzigen Kanal gefunden, erwartet: CHANNELS</translation>
    </message>
    <message>
        <source>found %1 numbers after Frame Time, expected at least one frame of %2 numbers</source>
        <translation>gefunden: %1 Zahlen nach Frame Time, erwartet: mindestens ein Frame mit %2 Zahlen</translation>
    </message>
    <message>
        <source>found more frames than can be counted, expected fewer</source>
        <translation>mehr Frames gefunden, als sich zählen lassen, erwartet: weniger</translation>
    </message>
    <message>
        <source>A .glb file cannot hold more than 4 GB: export a shorter range.</source>
        <translation>Eine .glb-Datei fasst höchstens 4 GB: Exportieren Sie einen kürzeren Bereich.</translation>
    </message>
    <message>
        <source>There is no figure to write.</source>
        <translation>Es gibt keine Figur zu schreiben.</translation>
    </message>
    <message>
        <source>A glTF skeleton cannot have more than 65 535 joints.</source>
        <translation>Ein glTF-Skelett kann höchstens 65 535 Gelenke haben.</translation>
    </message>
    <message>
        <source>is not valid JSON here.</source>
        <translation>ist hier kein gültiges JSON.</translation>
    </message>
    <message>
        <source>holds a number that is too large.</source>
        <translation>enthält eine zu große Zahl.</translation>
    </message>
    <message>
        <source>A .npz file cannot hold more than 4 GB: export a shorter range.</source>
        <translation>Eine .npz-Datei fasst höchstens 4 GB: Exportieren Sie einen kürzeren Bereich.</translation>
    </message>
    <message>
        <source>found no skeleton beside it, expected an .asf file (name it with --asf)</source>
        <translation>daneben liegt kein Skelett, erwartet wird eine .asf-Datei (mit --asf angeben)</translation>
    </message>
    <message>
        <source>found an ASF skeleton, which holds no motion, expected the .amc file that belongs to it.</source>
        <translation>das ist ein ASF-Skelett, das keine Bewegung enthält; erwartet wird die zugehörige .amc-Datei.</translation>
    </message>
    <message>
        <source>The recording holds no skeleton.</source>
        <translation>Die Aufnahme enthält kein Skelett.</translation>
    </message>
    <message>
        <source>found UTF-16 text, expected plain text (save the file as UTF-8)</source>
        <translation>UTF-16-Text gefunden, erwartet: einfacher Text (speichern Sie die Datei als UTF-8)</translation>
    </message>
    <message>
        <source>has a quote that is not closed.</source>
        <translation>hat ein Anführungszeichen, das nicht geschlossen wird.</translation>
    </message>
    <message>
        <source>No joint has the role pelvis: actions cannot be compared.</source>
        <translation>Kein Gelenk hat die Rolle Becken: Aktionen lassen sich nicht vergleichen.</translation>
    </message>
    <message>
        <source>Nothing stands before &quot;or&quot;.</source>
        <translation>Vor „or“ steht nichts.</translation>
    </message>
    <message>
        <source>Nothing stands after &quot;or&quot;.</source>
        <translation>Nach „or“ steht nichts.</translation>
    </message>
    <message>
        <source>Something is missing after &quot;not&quot;.</source>
        <translation>Nach „not“ fehlt etwas.</translation>
    </message>
    <message>
        <source>Points to be aligned must come in pairs.</source>
        <translation>Punkte zum Ausrichten müssen paarweise kommen.</translation>
    </message>
    <message>
        <source>Points to be aligned need a weight above zero.</source>
        <translation>Punkte zum Ausrichten brauchen ein Gewicht über null.</translation>
    </message>
    <message>
        <source>A rate must be a positive number of frames a second.</source>
        <translation>Eine Rate muss eine positive Zahl von Frames pro Sekunde sein.</translation>
    </message>
    <message>
        <source>Foot locking needs a frame to show.</source>
        <translation>Das Festhalten der Füße braucht ein Frame, das gezeigt wird.</translation>
    </message>
    <message>
        <source>Foot locking needs to know of every frame which feet stand.</source>
        <translation>Zum Festhalten der Füße muss für jedes Frame bekannt sein, welche Füße stehen.</translation>
    </message>
    <message>
        <source>A clip without frames cannot be joined.</source>
        <translation>Ein Clip ohne Frames lässt sich nicht verbinden.</translation>
    </message>
    <message>
        <source>Clips can be joined only at one rate and on one skeleton.</source>
        <translation>Clips lassen sich nur bei gleicher Rate und gleichem Skelett verbinden.</translation>
    </message>
    <message>
        <source>A motion needs a skeleton.</source>
        <translation>Eine Bewegung braucht ein Skelett.</translation>
    </message>
    <message>
        <source>A motion&apos;s frame time must be a positive number of seconds.</source>
        <translation>Die Dauer eines Frames muss eine positive Zahl von Sekunden sein.</translation>
    </message>
    <message>
        <source>A motion&apos;s channel values do not fill its frames.</source>
        <translation>Die Kanalwerte der Bewegung füllen ihre Frames nicht.</translation>
    </message>
    <message>
        <source>A channel value is not a finite number.</source>
        <translation>Ein Kanalwert ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>A clip&apos;s rig does not have the joints of its motion.</source>
        <translation>Das Rig eines Clips hat nicht die Gelenke seiner Bewegung.</translation>
    </message>
    <message>
        <source>A clip of %1 joints cannot be written with the %2 joints of another skeleton: retarget it first.</source>
        <translation>Ein Clip mit %1 Gelenken lässt sich nicht mit den %2 Gelenken eines anderen Skeletts schreiben: Erst ist ein Retargeting nötig.</translation>
    </message>
    <message>
        <source>Ways are scaled by %1 for the legs&apos; lengths.</source>
        <translation>Wege werden mit %1 skaliert, weil die Beine verschieden lang sind.</translation>
    </message>
    <message>
        <source>%1 moves by up to %2 cm of its own, which is not kept: %3 carries the body.</source>
        <translation>%1 bewegt sich selbst um bis zu %2 cm, was verloren geht: Den Körper trägt %3.</translation>
    </message>
    <message>
        <source>The bone to %1 changes by up to %2 cm; its mean is kept.</source>
        <translation>Der Knochen zu %1 ändert seine Länge um bis zu %2 cm; behalten wird das Mittel.</translation>
    </message>
    <message>
        <source>No neck: the chest (%1) stands in for it.</source>
        <translation>Kein Hals: Die Brust (%1) steht für ihn.</translation>
    </message>
    <message>
        <source>The joint names say nothing; the roles were read off the skeleton&apos;s shape. Check left and right.</source>
        <translation>Die Namen der Gelenke sagen nichts; die Rollen wurden aus der Form des Skeletts gelesen. Prüfen Sie links und rechts.</translation>
    </message>
    <message>
        <source>This skeleton is not a human body that is known here: it is shown and measured, but the contact force needs joint roles. Name them by hand if it is one.</source>
        <translation>Dieses Skelett ist kein hier bekannter menschlicher Körper: Es wird gezeigt und vermessen, aber die Kontaktkraft braucht Gelenkrollen. Ist es doch einer, so benennen Sie sie von Hand.</translation>
    </message>
    <message>
        <source>A skeleton needs at least one joint.</source>
        <translation>Ein Skelett braucht mindestens ein Gelenk.</translation>
    </message>
    <message>
        <source>A skeleton&apos;s channel count does not add up.</source>
        <translation>Die Anzahl der Kanäle eines Skeletts geht nicht auf.</translation>
    </message>
    <message>
        <source>The body lies along the x axis; y was taken for up. Say which axis is up.</source>
        <translation>Der Körper liegt entlang der x-Achse; als Hochachse wurde y angenommen. Sagen Sie, welche Achse nach oben zeigt.</translation>
    </message>
    <message>
        <source>Without legs the unit cannot be found; centimetres are assumed.</source>
        <translation>Ohne Beine lässt sich die Einheit nicht ermitteln; Zentimeter werden angenommen.</translation>
    </message>
    <message>
        <source>The labels belong to another segmentation.</source>
        <translation>Die Labels gehören zu einer anderen Segmentierung.</translation>
    </message>
    <message>
        <source>The differences belong to another segmentation or vocabulary.</source>
        <translation>Die Unterschiede gehören zu einer anderen Segmentierung oder einem anderen Vokabular.</translation>
    </message>
    <message>
        <source>Fighter %1 has no removed boundary near frame %2.</source>
        <translation>Kämpfer %1 hat keine entfernte Grenze nahe Frame %2.</translation>
    </message>
    <message>
        <source>Fighter %1 has another boundary at frame %2; move that one first.</source>
        <translation>Kämpfer %1 hat bei Frame %2 schon eine Grenze; verschieben Sie erst diese.</translation>
    </message>
    <message>
        <source>Frame %1 is not inside the take, whose last frame is %2: a boundary cannot stand there.</source>
        <translation>Frame %1 liegt nicht im Inneren des Takes, dessen letztes Frame %2 ist: Dort kann keine Grenze stehen.</translation>
    </message>
    <message>
        <source>The boundary can move between its neighbours only: frames %1 to %2.</source>
        <translation>Die Grenze lässt sich nur zwischen ihren Nachbarn verschieben: Frames %1 bis %2.</translation>
    </message>
    <message>
        <source>The boundary at frame %1 is an end of the take, which stays.</source>
        <translation>Die Grenze bei Frame %1 ist ein Ende des Takes und bleibt.</translation>
    </message>
    <message>
        <source>Take %1, player %2: its skeleton has other joints than that of the first take, so it is left out of bouts.</source>
        <translation>Take %1, Kämpfer %2: Das Skelett hat andere Gelenke als das des ersten Takes und bleibt bei Kämpfen außen vor.</translation>
    </message>
    <message>
        <source>No action of player %1 begins in frames %2 to %3 of take %4.</source>
        <translation>In den Frames %2 bis %3 von Take %4 beginnt keine Aktion von Kämpfer %1.</translation>
    </message>
    <message>
        <source>Player %1 does not attack in frames %2 to %3 of take %4.</source>
        <translation>Kämpfer %1 greift in den Frames %2 bis %3 von Take %4 nicht an.</translation>
    </message>
    <message>
        <source>Player %1 never attacks.</source>
        <translation>Kämpfer %1 greift nie an.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden: %2.</translation>
    </message>
    <message>
        <source>The cutoff must be a positive number of Hz.</source>
        <translation>Die Grenzfrequenz muss eine positive Zahl in Hz sein.</translation>
    </message>
    <message>
        <source>The prominence must be a number of body weights, 0 or more.</source>
        <translation>Die Prominenz muss eine Zahl von Körpergewichten sein, 0 oder mehr.</translation>
    </message>
    <message>
        <source>A take needs a name.</source>
        <translation>Ein Take braucht einen Namen.</translation>
    </message>
    <message>
        <source>A take has one or two fighters.</source>
        <translation>Ein Take hat einen oder zwei Kämpfer.</translation>
    </message>
    <message>
        <source>There is no such place in the list of takes.</source>
        <translation>Diesen Platz gibt es in der Liste der Takes nicht.</translation>
    </message>
    <message>
        <source>There is one fighter only: nothing to swap.</source>
        <translation>Es gibt nur einen Kämpfer: nichts zu tauschen.</translation>
    </message>
    <message>
        <source>The skeleton has no such joint.</source>
        <translation>Dieses Gelenk hat das Skelett nicht.</translation>
    </message>
    <message>
        <source>%1 holds %2 frames, but the take reaches to frame %3: it is not the recording that is missing.</source>
        <translation>%1 enthält %2 Frames, der Take reicht aber bis Frame %3: Das ist nicht die fehlende Aufnahme.</translation>
    </message>
    <message>
        <source>The placement cannot be written: neither the root nor a joint right below it has all position and rotation channels.</source>
        <translation>Der Ort lässt sich nicht schreiben: Weder die Wurzel noch ein Gelenk direkt darunter hat alle Positions- und Rotationskanäle.</translation>
    </message>
    <message>
        <source>A take is made of one or two recordings.</source>
        <translation>Ein Take entsteht aus einer oder zwei Aufnahmen.</translation>
    </message>
    <message>
        <source>The take&apos;s name holds bytes that are no UTF-8 text.</source>
        <translation>Der Name des Takes enthält Bytes, die kein UTF-8-Text sind.</translation>
    </message>
    <message>
        <source>A frame rate lies between 1 and 10000 Hz.</source>
        <translation>Eine Framerate liegt zwischen 1 und 10000 Hz.</translation>
    </message>
    <message>
        <source>The recordings run at %1 and %2 Hz; each keeps its own rate.</source>
        <translation>Die Aufnahmen laufen mit %1 und %2 Hz; jede behält ihre Rate.</translation>
    </message>
    <message>
        <source>Take %1, player %2: no pelvis or no centre of mass is known, so its actions are left out.</source>
        <translation>Take %1, Kämpfer %2: Becken oder Schwerpunkt ist nicht bekannt, daher werden seine Aktionen weggelassen.</translation>
    </message>
    <message>
        <source>Player %1: %2 of %3 actions have no label and are left out, with every transition that touches them.</source>
        <translation>Kämpfer %1: %2 von %3 Aktionen haben kein Label und werden weggelassen, samt jedem Übergang, der sie berührt.</translation>
    </message>
    <message>
        <source>No take of two has a recording of player %1 with the skeleton of the bout: it was removed since the bout was begun.</source>
        <translation>Kein Take mit zwei Kämpfern hat eine Aufnahme von Kämpfer %1 mit dem Skelett des Kampfs: Sie wurde entfernt, seit der Kampf begann.</translation>
    </message>
    <message>
        <source>An .eaf file holds one take: say which.</source>
        <translation>Eine .eaf-Datei enthält einen Take: Sagen Sie, welchen.</translation>
    </message>
    <message>
        <source>is empty.</source>
        <translation>ist leer.</translation>
    </message>
    <message>
        <source>has no column %1; a label table needs begin_s, end_s and label.</source>
        <translation>hat keine Spalte %1; eine Label-Tabelle braucht begin_s, end_s und label.</translation>
    </message>
    <message>
        <source>holds no labels: it has neither &quot;kumite_labels&quot; nor &quot;players&quot;.</source>
        <translation>enthält keine Labels: Es gibt weder „kumite_labels“ noch „players“.</translation>
    </message>
    <message>
        <source>There is no action %1; the fighter has %2.</source>
        <translation>Eine Aktion %1 gibt es nicht; der Kämpfer hat %2.</translation>
    </message>
    <message>
        <source>The vocabulary has no aspect %1.</source>
        <translation>Das Vokabular hat keinen Aspekt %1.</translation>
    </message>
    <message>
        <source>%1 has no qualifier %2.</source>
        <translation>%1 hat keinen Zusatz %2.</translation>
    </message>
    <message>
        <source>The label belongs to another vocabulary.</source>
        <translation>Das Label gehört zu einem anderen Vokabular.</translation>
    </message>
    <message>
        <source>The thresholds of the rules must be numbers, 0 or more.</source>
        <translation>Die Schwellen der Regeln müssen Zahlen sein, 0 oder mehr.</translation>
    </message>
    <message>
        <source>A cross-validation has two folds or more.</source>
        <translation>Eine Kreuzvalidierung hat mindestens zwei Gruppen.</translation>
    </message>
    <message>
        <source>A library&apos;s rate lies between %1 and %2 Hz.</source>
        <translation>Die Rate einer Bibliothek liegt zwischen %1 und %2 Hz.</translation>
    </message>
    <message>
        <source>The library is empty: no source holds the motion of a body.</source>
        <translation>Die Bibliothek ist leer: Keine Quelle enthält die Bewegung eines Körpers.</translation>
    </message>
    <message>
        <source>The library has no clip &quot;%1&quot;; it has %2.</source>
        <translation>Die Bibliothek hat keinen Clip „%1“; sie hat %2.</translation>
    </message>
    <message>
        <source>None of these clips shows a hand or a foot that strikes.</source>
        <translation>Keiner dieser Clips zeigt eine Hand oder einen Fuß, der zuschlägt.</translation>
    </message>
    <message>
        <source>No strike of the %1 was found in &quot;%2&quot;.</source>
        <translation>In „%2“ wurde keine Technik mit %1 gefunden.</translation>
    </message>
    <message>
        <source>%1 was not where the project says; the same recording was found at %2.</source>
        <translation>%1 war nicht dort, wo das Projekt sagt; dieselbe Aufnahme wurde unter %2 gefunden.</translation>
    </message>
    <message>
        <source>%1 is there already: choose another name.</source>
        <translation>%1 gibt es schon: Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>is a recording; make a project of it with kumite new.</source>
        <translation>ist eine Aufnahme; machen Sie mit kumite new ein Projekt daraus.</translation>
    </message>
    <message>
        <source>is not a Kumite project: it has no &quot;kumite&quot; version.</source>
        <translation>ist kein Kumite-Projekt: Die Versionsangabe „kumite“ fehlt.</translation>
    </message>
    <message>
        <source>was written by a newer Kumite (file version %1, this one reads up to %2); open it with that one.</source>
        <translation>wurde von einem neueren Kumite geschrieben (Dateiversion %1, dieses hier liest bis %2); öffnen Sie die Datei damit.</translation>
    </message>
    <message>
        <source>No motion from key poses of %1: %2</source>
        <translation>Keine Bewegung aus Schlüsselposen von %1: %2</translation>
    </message>
    <message>
        <source>There is no clip to rate.</source>
        <translation>Es gibt keinen Clip zu bewerten.</translation>
    </message>
    <message>
        <source>Frame %1 is not inside the take: a boundary cannot stand there.</source>
        <translation>Frame %1 liegt nicht im Inneren des Takes: Dort kann keine Grenze stehen.</translation>
    </message>
    <message>
        <source>Fighter %1 has another boundary at frame %2; forget this one.</source>
        <translation>Kämpfer %1 hat bei Frame %2 schon eine Grenze; vergessen Sie diese Korrektur.</translation>
    </message>
    <message>
        <source>Fighter %1 has no action at frame %2.</source>
        <translation>Kämpfer %1 hat bei Frame %2 keine Aktion.</translation>
    </message>
    <message>
        <source>The budget is a share of all actions, above 0 and at most 1.</source>
        <translation>Das Budget ist ein Anteil aller Aktionen, über 0 und höchstens 1.</translation>
    </message>
    <message>
        <source>Player %1 has no labelled action that follows another labelled one: label more of it.</source>
        <translation>Kämpfer %1 hat keine gelabelte Aktion, die auf eine andere gelabelte folgt: Labeln Sie mehr von ihm.</translation>
    </message>
    <message>
        <source>The captured attack holds no action.</source>
        <translation>Der aufgenommene Angriff enthält keine Aktion.</translation>
    </message>
    <message>
        <source>No take of two shows player %1.</source>
        <translation>Kein Take mit zwei Kämpfern zeigt Kämpfer %1.</translation>
    </message>
    <message>
        <source>The captured attack cannot be shown: its take is missing.</source>
        <translation>Der aufgenommene Angriff lässt sich nicht zeigen: Sein Take fehlt.</translation>
    </message>
    <message>
        <source>Player %1 shows nothing but attacks outside of the captured one.</source>
        <translation>Kämpfer %1 zeigt außerhalb des aufgenommenen Angriffs nichts als Angriffe.</translation>
    </message>
    <message>
        <source>No recorded moment shows both fighters labelled.</source>
        <translation>In keinem aufgenommenen Moment sind beide Kämpfer gelabelt.</translation>
    </message>
    <message>
        <source>Only a bout with an avatar can be steered.</source>
        <translation>Nur ein Kampf mit Avatar lässt sich steuern.</translation>
    </message>
    <message>
        <source>The library was made without an avatar&apos;s model.</source>
        <translation>Die Bibliothek wurde ohne Modell für einen Avatar erstellt.</translation>
    </message>
    <message>
        <source>Player %1 never shows &quot;%2&quot; after another labelled action.</source>
        <translation>Kämpfer %1 zeigt „%2“ nie nach einer anderen gelabelten Aktion.</translation>
    </message>
    <message>
        <source>A weight is 0 (never) or a positive factor.</source>
        <translation>Ein Gewicht ist 0 (nie) oder ein positiver Faktor.</translation>
    </message>
    <message>
        <source>A temperature is 0 or positive.</source>
        <translation>Eine Temperatur ist 0 oder positiv.</translation>
    </message>
    <message>
        <source>No action of the avatar is followed by half a second of its take.</source>
        <translation>Auf keine Aktion des Avatars folgt noch eine halbe Sekunde ihres Takes.</translation>
    </message>
    <message>
        <source>The action has no frame.</source>
        <translation>Die Aktion hat kein Frame.</translation>
    </message>
    <message>
        <source>The threshold of pose clusters must be a positive number.</source>
        <translation>Die Schwelle für Posencluster muss eine positive Zahl sein.</translation>
    </message>
    <message>
        <source>The block &quot;%1&quot; has no motion.</source>
        <translation>Der Block „%1“ hat keine Bewegung.</translation>
    </message>
    <message>
        <source>Frames %1:%2 cannot be taken from &quot;%3&quot;, which has %4.</source>
        <translation>Die Frames %1:%2 gibt es in „%3“ nicht; dort sind es %4.</translation>
    </message>
    <message>
        <source>The block &quot;%1&quot; has no frame.</source>
        <translation>Der Block „%1“ hat kein Frame.</translation>
    </message>
    <message>
        <source>The sequence has no block.</source>
        <translation>Die Sequenz hat keinen Block.</translation>
    </message>
    <message>
        <source>There is no path in the graph between these two actions; choose a curve, or clips played backward.</source>
        <translation>Zwischen diesen beiden Aktionen gibt es im Graphen keinen Weg; wählen Sie eine Kurve oder rückwärts gespielte Clips.</translation>
    </message>
    <message>
        <source>There are %1 candidate paths, counted from 0: no path %2.</source>
        <translation>Es gibt %1 mögliche Wege, gezählt ab 0: keinen Weg %2.</translation>
    </message>
    <message>
        <source>A transition needs motion on both sides.</source>
        <translation>Ein Übergang braucht Bewegung auf beiden Seiten.</translation>
    </message>
    <message>
        <source>%1 (%2–%3 s, fighter %4): %5</source>
        <translation>%1 (%2–%3 s, Kämpfer %4): %5</translation>
    </message>
    <message>
        <source>at least one whole frame</source>
        <translation>mindestens ein ganzes Frame</translation>
    </message>
    <message>
        <source>the number of a frame</source>
        <translation>die Nummer eines Frames</translation>
    </message>
    <message>
        <source>a bone of the skeleton that has a dof, or the number of the frame after %1</source>
        <translation>ein Knochen des Skeletts, der einen dof hat, oder die Nummer des Frames nach %1</translation>
    </message>
    <message>
        <source>each bone once in frame %1</source>
        <translation>jeder Knochen nur einmal in Frame %1</translation>
    </message>
    <message>
        <source>a number for bone %1 in frame %2</source>
        <translation>eine Zahl für Knochen %1 in Frame %2</translation>
    </message>
    <message>
        <source>only %1 numbers for bone %2 in frame %3</source>
        <translation>nur %1 Zahlen für Knochen %2 in Frame %3</translation>
    </message>
    <message>
        <source>a section of an ASF file, such as :units or :bonedata</source>
        <translation>ein Abschnitt einer ASF-Datei wie :units oder :bonedata</translation>
    </message>
    <message>
        <source>the section :root</source>
        <translation>der Abschnitt :root</translation>
    </message>
    <message>
        <source>the section :hierarchy</source>
        <translation>der Abschnitt :hierarchy</translation>
    </message>
    <message>
        <source>deg or rad</source>
        <translation>deg oder rad</translation>
    </message>
    <message>
        <source>order, axis, position or orientation</source>
        <translation>order, axis, position oder orientation</translation>
    </message>
    <message>
        <source>10000 bones at most</source>
        <translation>höchstens 10000 Knochen</translation>
    </message>
    <message>
        <source>end, behind the last line of a bone</source>
        <translation>end hinter der letzten Zeile eines Knochens</translation>
    </message>
    <message>
        <source>the name of a bone of :bonedata, or end</source>
        <translation>der Name eines Knochens aus :bonedata oder end</translation>
    </message>
    <message>
        <source>an order of rotations, such as XYZ</source>
        <translation>eine Reihenfolge von Drehungen wie XYZ</translation>
    </message>
    <message>
        <source>each degree of freedom once</source>
        <translation>jeder Freiheitsgrad nur einmal</translation>
    </message>
    <message>
        <source>OFFSET, CHANNELS, JOINT, End Site or } in joint %1</source>
        <translation>OFFSET, CHANNELS, JOINT, End Site oder } in Gelenk %1</translation>
    </message>
    <message>
        <source>the number of channels, 0 to 6</source>
        <translation>die Anzahl der Kanäle, 0 bis 6</translation>
    </message>
    <message>
        <source>each channel once in a joint</source>
        <translation>jeder Kanal nur einmal in einem Gelenk</translation>
    </message>
    <message>
        <source>channel %1 of %2: Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation</source>
        <translation>Kanal %1 von %2: Xposition, Yposition, Zposition, Xrotation, Yrotation oder Zrotation</translation>
    </message>
    <message>
        <source>a finite number with a decimal point</source>
        <translation>eine endliche Zahl mit Dezimalpunkt</translation>
    </message>
    <message>
        <source>no action of the opponent at that time</source>
        <translation>zu dieser Zeit keine Aktion des Gegners</translation>
    </message>
    <message>
        <source>the opponent&apos;s action is no attack</source>
        <translation>die Aktion des Gegners ist kein Angriff</translation>
    </message>
    <message>
        <source>stands left</source>
        <translation>Stand links</translation>
    </message>
    <message>
        <source>stands right</source>
        <translation>Stand rechts</translation>
    </message>
    <message>
        <source>in the air</source>
        <translation>in der Luft</translation>
    </message>
    <message>
        <source>opponent&apos;s %1, closing only %2 m/s</source>
        <translation>%1 vom Gegner, nähert sich nur mit %2 m/s</translation>
    </message>
    <message>
        <source>opponent&apos;s %1, closing %2 m/s</source>
        <translation>%1 vom Gegner, nähert sich mit %2 m/s</translation>
    </message>
    <message>
        <source>%1 at the beginning, %2 at the end</source>
        <translation>am Anfang %1, am Ende %2</translation>
    </message>
    <message>
        <source>There is no root %1; the recording has %2.</source>
        <translation>Eine Wurzel %1 gibt es nicht; die Aufnahme hat %2.</translation>
    </message>
    <message>
        <source>The body stands on its head most of the time: is up right?</source>
        <translation>Der Körper steht meist auf dem Kopf: Stimmt die Hochachse?</translation>
    </message>
    <message>
        <source>The legs would be %1 m long: is the unit (%2) right?</source>
        <translation>Die Beine wären %1 m lang: Stimmt die Einheit (%2)?</translation>
    </message>
    <message>
        <source>Relative to the legs the target&apos;s arms are %1 % longer: hands do not reach the same places.</source>
        <translation>Im Verhältnis zu den Beinen hat das Zielskelett %1 % längere Arme: Die Hände erreichen nicht dieselben Stellen.</translation>
    </message>
    <message>
        <source>Relative to the legs the target&apos;s arms are %1 % shorter: hands do not reach the same places.</source>
        <translation>Im Verhältnis zu den Beinen hat das Zielskelett %1 % kürzere Arme: Die Hände erreichen nicht dieselben Stellen.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>frames %1:%2 cannot be taken from a recording of %3 frames.</source>
        <translation>die Frames %1:%2 gibt es in einer Aufnahme von %3 Frames nicht.</translation>
    </message>
    <message>
        <source>found %1 data, expected BVH or ASF/AMC: import it into Blender and export it as Motion Capture (.bvh).</source>
        <translation>gefunden: %1-Daten, erwartet: BVH oder ASF/AMC. Importieren Sie die Datei in Blender, und exportieren Sie sie als Motion Capture (.bvh).</translation>
    </message>
    <message>
        <source>the opponent&apos;s action is not labelled yet</source>
        <translation>die Aktion des Gegners ist noch nicht gelabelt</translation>
    </message>
</context>
<context>
    <name>KeysSheet</name>
    <message>
        <source>Kumite: keys and mouse</source>
        <translation>Kumite: Tasten und Maus</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>pelvis</source>
        <translation>Becken</translation>
    </message>
    <message>
        <source>spine</source>
        <translation>Wirbelsäule</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>left clavicle</source>
        <translation>linkes Schlüsselbein</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>linke Schulter</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>linker Ellbogen</translation>
    </message>
    <message>
        <source>left wrist</source>
        <translation>linkes Handgelenk</translation>
    </message>
    <message>
        <source>left hip</source>
        <translation>linke Hüfte</translation>
    </message>
    <message>
        <source>left knee</source>
        <translation>linkes Knie</translation>
    </message>
    <message>
        <source>left ankle</source>
        <translation>linker Knöchel</translation>
    </message>
    <message>
        <source>left toe</source>
        <translation>linke Zehen</translation>
    </message>
    <message>
        <source>right clavicle</source>
        <translation>rechtes Schlüsselbein</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>rechte Schulter</translation>
    </message>
    <message>
        <source>right elbow</source>
        <translation>rechter Ellbogen</translation>
    </message>
    <message>
        <source>right wrist</source>
        <translation>rechtes Handgelenk</translation>
    </message>
    <message>
        <source>right hip</source>
        <translation>rechte Hüfte</translation>
    </message>
    <message>
        <source>right knee</source>
        <translation>rechtes Knie</translation>
    </message>
    <message>
        <source>right ankle</source>
        <translation>rechter Knöchel</translation>
    </message>
    <message>
        <source>right toe</source>
        <translation>rechte Zehen</translation>
    </message>
</context>
<context>
    <name>ShortLabel</name>
    <message>
        <source>fwd</source>
        <translation>vor</translation>
    </message>
    <message>
        <source>bwd</source>
        <translation>rück</translation>
    </message>
    <message>
        <source>bwdfwd</source>
        <translation>rü-vo</translation>
    </message>
    <message>
        <source>fwdbwd</source>
        <translation>vo-rü</translation>
    </message>
    <message>
        <source>up</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>down</source>
        <translation>runt.</translation>
    </message>
    <message>
        <source>downup</source>
        <translation>ru-ho</translation>
    </message>
    <message>
        <source>kick</source>
        <translation>Tritt</translation>
    </message>
    <message>
        <source>punch</source>
        <translation>Schl.</translation>
    </message>
    <message>
        <source>L-L</source>
        <translation>L-L</translation>
    </message>
    <message>
        <source>L-R</source>
        <translation>L-R</translation>
    </message>
    <message>
        <source>L-F</source>
        <translation>L-F</translation>
    </message>
    <message>
        <source>R-L</source>
        <translation>R-L</translation>
    </message>
    <message>
        <source>R-R</source>
        <translation>R-R</translation>
    </message>
    <message>
        <source>R-F</source>
        <translation>R-F</translation>
    </message>
    <message>
        <source>F-L</source>
        <translation>F-L</translation>
    </message>
    <message>
        <source>F-R</source>
        <translation>F-R</translation>
    </message>
    <message>
        <source>F-F</source>
        <translation>F-F</translation>
    </message>
</context>
<context>
    <name>Vocabulary</name>
    <message>
        <source>Left punch</source>
        <translation>Schlag links</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vor</translation>
    </message>
    <message>
        <source>back</source>
        <translation>zurück</translation>
    </message>
    <message>
        <source>back and forward</source>
        <translation>zurück und vor</translation>
    </message>
    <message>
        <source>forward and back</source>
        <translation>vor und zurück</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>Right punch</source>
        <translation>Schlag rechts</translation>
    </message>
    <message>
        <source>Left kick</source>
        <translation>Tritt links</translation>
    </message>
    <message>
        <source>up</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>down</source>
        <translation>runter</translation>
    </message>
    <message>
        <source>down and up</source>
        <translation>runter und hoch</translation>
    </message>
    <message>
        <source>Right kick</source>
        <translation>Tritt rechts</translation>
    </message>
    <message>
        <source>Jump</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>React</source>
        <translation>Reaktion</translation>
    </message>
    <message>
        <source>to a kick</source>
        <translation>auf Tritt</translation>
    </message>
    <message>
        <source>to a punch</source>
        <translation>auf Schlag</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>left to left</source>
        <translation>links zu links</translation>
    </message>
    <message>
        <source>left to right</source>
        <translation>links zu rechts</translation>
    </message>
    <message>
        <source>left to flight</source>
        <translation>links zu Flug</translation>
    </message>
    <message>
        <source>right to left</source>
        <translation>rechts zu links</translation>
    </message>
    <message>
        <source>right to right</source>
        <translation>rechts zu rechts</translation>
    </message>
    <message>
        <source>right to flight</source>
        <translation>rechts zu Flug</translation>
    </message>
    <message>
        <source>flight to left</source>
        <translation>Flug zu links</translation>
    </message>
    <message>
        <source>flight to right</source>
        <translation>Flug zu rechts</translation>
    </message>
    <message>
        <source>flight to flight</source>
        <translation>Flug zu Flug</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Key: %1</source>
        <translation>Taste: %1</translation>
    </message>
</context>
<context>
    <name>kumite</name>
    <message>
        <source>Male means (de Leva 1996)</source>
        <translation>Mittelwerte Männer (de Leva 1996)</translation>
    </message>
    <message>
        <source>Female means (de Leva 1996)</source>
        <translation>Mittelwerte Frauen (de Leva 1996)</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>heute %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>gestern %1</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>foot contact</source>
        <translation>Fußkontakt</translation>
    </message>
    <message>
        <source>boundary of the other</source>
        <translation>Grenze des anderen</translation>
    </message>
    <message>
        <source>playhead</source>
        <translation>Abspielkopf</translation>
    </message>
</context>
<context>
    <name>kumite::studio</name>
    <message>
        <source>example, sample, tutorial, try</source>
        <translation>beispiel, muster, anleitung, ausprobieren, demo</translation>
    </message>
    <message>
        <source>import, load, bvh, amc, asf, mocap, motion capture, new project</source>
        <translation>importieren, laden, bvh, amc, asf, mocap, motion capture, neues projekt</translation>
    </message>
    <message>
        <source>load, kumite file</source>
        <translation>laden, kumite-datei</translation>
    </message>
    <message>
        <source>store, write</source>
        <translation>sichern, schreiben</translation>
    </message>
    <message>
        <source>copy, rename project, duplicate</source>
        <translation>kopie, projekt umbenennen, duplizieren</translation>
    </message>
    <message>
        <source>backup, restore, earlier, revert, snapshot</source>
        <translation>sicherung, backup, wiederherstellen, früher, zurücksetzen, schnappschuss</translation>
    </message>
    <message>
        <source>csv, json, table, spreadsheet, results, segmentation</source>
        <translation>csv, json, tabelle, ergebnisse, segmentierung</translation>
    </message>
    <message>
        <source>bvh, skeleton, animation, blender, mocap</source>
        <translation>bvh, skelett, animation, blender, mocap</translation>
    </message>
    <message>
        <source>missing, relink, locate, moved</source>
        <translation>fehlt, neu verknüpfen, finden, verschoben</translation>
    </message>
    <message>
        <source>exit, close, leave</source>
        <translation>schließen, verlassen, quit</translation>
    </message>
    <message>
        <source>back, revert, oops</source>
        <translation>zurück, undo, hoppla</translation>
    </message>
    <message>
        <source>again, repeat</source>
        <translation>nochmal, erneut, redo</translation>
    </message>
    <message>
        <source>settings, options, configuration, shortcuts, autosave</source>
        <translation>optionen, konfiguration, tastenkürzel, automatisch speichern</translation>
    </message>
    <message>
        <source>import, new, load, clip, session</source>
        <translation>importieren, neu, laden, clip, sitzung</translation>
    </message>
    <message>
        <source>name, title</source>
        <translation>name, titel</translation>
    </message>
    <message>
        <source>delete, close, clip</source>
        <translation>löschen, schließen, clip</translation>
    </message>
    <message>
        <source>previous clip, switch</source>
        <translation>voriger clip, wechseln</translation>
    </message>
    <message>
        <source>next clip, switch</source>
        <translation>nächster clip, wechseln</translation>
    </message>
    <message>
        <source>switch, opponent, toggle, player</source>
        <translation>wechseln, gegner, umschalten, spieler</translation>
    </message>
    <message>
        <source>joints, roles, skeleton, rate, offset, sync, floor, body model, mass</source>
        <translation>gelenke, rollen, skelett, rate, versatz, synchron, boden, körpermodell, masse</translation>
    </message>
    <message>
        <source>exchange, colours, player</source>
        <translation>vertauschen, farben, spieler</translation>
    </message>
    <message>
        <source>warnings, problems, errors, log, report</source>
        <translation>warnungen, probleme, fehler, protokoll, bericht</translation>
    </message>
    <message>
        <source>delete, erase, clear, undelete, merge, cut</source>
        <translation>löschen, entfernen, wiederherstellen, verbinden, schnitt</translation>
    </message>
    <message>
        <source>split, cut, insert, new, razor, slice, mark, here</source>
        <translation>teilen, schneiden, einfügen, neu, klinge, markieren, hier</translation>
    </message>
    <message>
        <source>merge left, combine, previous</source>
        <translation>links verbinden, zusammenfassen, vorige</translation>
    </message>
    <message>
        <source>merge right, combine, next</source>
        <translation>rechts verbinden, zusammenfassen, nächste</translation>
    </message>
    <message>
        <source>nudge left, shift</source>
        <translation>nach links schieben, verschieben</translation>
    </message>
    <message>
        <source>nudge right, shift</source>
        <translation>nach rechts schieben, verschieben</translation>
    </message>
    <message>
        <source>repeat, zoom to action, segment</source>
        <translation>wiederholen, zur aktion zoomen, segment, schleife</translation>
    </message>
    <message>
        <source>comment, annotate, remark, text, label</source>
        <translation>kommentar, anmerkung, bemerkung, text, label</translation>
    </message>
    <message>
        <source>review, suspicious, error, uncertain, queue</source>
        <translation>prüfen, verdächtig, fehler, unsicher, warteschlange</translation>
    </message>
    <message>
        <source>review, suspicious</source>
        <translation>prüfen, verdächtig</translation>
    </message>
    <message>
        <source>accept, approve, confirm, ok, yes, good</source>
        <translation>annehmen, bestätigen, ok, ja, gut</translation>
    </message>
    <message>
        <source>reject, delete, dismiss, discard, no, false, wrong</source>
        <translation>ablehnen, löschen, verwerfen, nein, falsch</translation>
    </message>
    <message>
        <source>reset, reopen, undecided, withdraw</source>
        <translation>zurücksetzen, wieder öffnen, unentschieden, widerrufen</translation>
    </message>
    <message>
        <source>difference, a/b, versus, parameters</source>
        <translation>unterschied, a/b, gegenüber, parameter</translation>
    </message>
    <message>
        <source>raw, unfiltered, noise</source>
        <translation>roh, ungefiltert, rauschen</translation>
    </message>
    <message>
        <source>com, cog, gravity</source>
        <translation>com, massenmittelpunkt, gravitation</translation>
    </message>
    <message>
        <source>velocity, wrist, punch</source>
        <translation>geschwindigkeit, handgelenk, schlag, faust</translation>
    </message>
    <message>
        <source>velocity, ankle, kick</source>
        <translation>geschwindigkeit, knöchel, tritt</translation>
    </message>
    <message>
        <source>seconds, frames, timecode</source>
        <translation>sekunden, frames, timecode</translation>
    </message>
    <message>
        <source>start, stop, run</source>
        <translation>start, stopp, play</translation>
    </message>
    <message>
        <source>pause, halt</source>
        <translation>pause, anhalten</translation>
    </message>
    <message>
        <source>rewind, shuttle</source>
        <translation>zurückspulen, shuttle</translation>
    </message>
    <message>
        <source>fast forward, shuttle</source>
        <translation>vorspulen, shuttle</translation>
    </message>
    <message>
        <source>previous frame, step</source>
        <translation>voriges frame, schritt</translation>
    </message>
    <message>
        <source>next frame, step</source>
        <translation>nächstes frame, schritt</translation>
    </message>
    <message>
        <source>beginning, first frame, rewind</source>
        <translation>anfang, erstes frame, zurückspulen</translation>
    </message>
    <message>
        <source>last frame</source>
        <translation>letztes frame</translation>
    </message>
    <message>
        <source>slow motion, speed, rate</source>
        <translation>zeitlupe, tempo, rate</translation>
    </message>
    <message>
        <source>speed up, rate</source>
        <translation>beschleunigen, rate</translation>
    </message>
    <message>
        <source>repeat, cycle</source>
        <translation>wiederholen, endlos</translation>
    </message>
    <message>
        <source>in point, mark in, start, range</source>
        <translation>in-punkt, anfang markieren, start, bereich</translation>
    </message>
    <message>
        <source>out point, mark out, end, range</source>
        <translation>out-punkt, ende markieren, bereich</translation>
    </message>
    <message>
        <source>fit, frame all, zoom out, home, reset view</source>
        <translation>einpassen, alles, herauszoomen, ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>frame selected, zoom in, focus, centre</source>
        <translation>auswahl einpassen, hineinzoomen, fokus, zentrieren</translation>
    </message>
    <message>
        <source>sidebar, show panels, focus mode</source>
        <translation>seitenleiste, bedienfelder zeigen, fokusmodus</translation>
    </message>
    <message>
        <source>maximise, maximize</source>
        <translation>maximieren, fullscreen</translation>
    </message>
    <message>
        <source>font size, zoom, bigger, accessibility, scale</source>
        <translation>Schriftgröße, Zoom, größer, Barrierefreiheit, Skalierung</translation>
    </message>
    <message>
        <source>font size, zoom, scale</source>
        <translation>Schriftgröße, Zoom, Skalierung</translation>
    </message>
    <message>
        <source>dark mode, light mode, colours, auto</source>
        <translation>dunkelmodus, hellmodus, farben, automatisch</translation>
    </message>
    <message>
        <source>light mode, bright, white, day, colours</source>
        <translation>hellmodus, hell, weiß, tag, farben</translation>
    </message>
    <message>
        <source>dark mode, black, night, colours</source>
        <translation>dunkelmodus, schwarz, nacht, farben</translation>
    </message>
    <message>
        <source>camera, front view</source>
        <translation>kamera, vorderansicht</translation>
    </message>
    <message>
        <source>camera, side view, left, right, profile</source>
        <translation>kamera, seitenansicht, links, rechts, profil</translation>
    </message>
    <message>
        <source>camera, top view, bird</source>
        <translation>kamera, draufsicht, vogelperspektive</translation>
    </message>
    <message>
        <source>camera, behind, third person</source>
        <translation>kamera, hinten, dritte person</translation>
    </message>
    <message>
        <source>camera, track</source>
        <translation>kamera, verfolgen</translation>
    </message>
    <message>
        <source>footsteps, feet, ground</source>
        <translation>schritte, füße, boden</translation>
    </message>
    <message>
        <source>trajectory, path, motion trail</source>
        <translation>trajektorie, pfad, bewegungsspur</translation>
    </message>
    <message>
        <source>com, cog, center, gravity</source>
        <translation>com, massenmittelpunkt, zentrum, gravitation</translation>
    </message>
    <message>
        <source>arrow, vector, ground reaction</source>
        <translation>pfeil, vektor, bodenreaktion</translation>
    </message>
    <message>
        <source>onion skin</source>
        <translation>zwiebelschicht, onion skin</translation>
    </message>
    <message>
        <source>onion skin, pose, stamp</source>
        <translation>zwiebelschicht, onion skin, pose, stempel</translation>
    </message>
    <message>
        <source>delete ghosts, onion skin</source>
        <translation>geister löschen, zwiebelschicht</translation>
    </message>
    <message>
        <source>distance, ruler, speed, tape</source>
        <translation>abstand, lineal, geschwindigkeit, maßband</translation>
    </message>
    <message>
        <source>screenshot, clipboard, image</source>
        <translation>bildschirmfoto, screenshot, zwischenablage, bild</translation>
    </message>
    <message>
        <source>screenshot, render, image, png, export picture, capture</source>
        <translation>bildschirmfoto, screenshot, rendern, bild, png, exportieren, aufnehmen</translation>
    </message>
    <message>
        <source>start, stop, preview</source>
        <translation>start, stopp, vorschau</translation>
    </message>
    <message>
        <source>jump back, skip</source>
        <translation>zurückspringen, überspringen</translation>
    </message>
    <message>
        <source>jump forward, skip</source>
        <translation>vorspringen, überspringen</translation>
    </message>
    <message>
        <source>preview, result, assembled, synthesised, before, after</source>
        <translation>vorschau, ergebnis, zusammengesetzt, synthetisch, vorher, nachher</translation>
    </message>
    <message>
        <source>punch, kick, strike, aim, reach, target tool</source>
        <translation>schlag, faust, tritt, technik, zielen, erreichen, zielwerkzeug</translation>
    </message>
    <message>
        <source>insert key, new pose, keyframe, set key</source>
        <translation>schlüsselpose einfügen, neue pose, keyframe, key setzen</translation>
    </message>
    <message>
        <source>delete key, erase</source>
        <translation>schlüsselpose löschen, keyframe, entfernen</translation>
    </message>
    <message>
        <source>previous keyframe, jump</source>
        <translation>voriger keyframe, springen</translation>
    </message>
    <message>
        <source>next keyframe, jump</source>
        <translation>nächster keyframe, springen</translation>
    </message>
    <message>
        <source>nudge left, time, shift</source>
        <translation>nach links schieben, zeit, verschieben</translation>
    </message>
    <message>
        <source>nudge right, time, shift</source>
        <translation>nach rechts schieben, zeit, verschieben</translation>
    </message>
    <message>
        <source>duplicate key, clone, paste</source>
        <translation>schlüsselpose duplizieren, klonen, einfügen, keyframe</translation>
    </message>
    <message>
        <source>flip, left, right, symmetry, reverse</source>
        <translation>umdrehen, links, rechts, symmetrie, umkehren</translation>
    </message>
    <message>
        <source>grab, capture, snapshot, recording</source>
        <translation>greifen, aufnehmen, schnappschuss, aufnahme</translation>
    </message>
    <message>
        <source>paste pose, browse, frame, library, import pose</source>
        <translation>Pose einfügen, durchsuchen, Bild, Bibliothek, Pose importieren</translation>
    </message>
    <message>
        <source>rotate, gizmo, ring, fk, angle, elbow, knee</source>
        <translation>drehen, Gizmo, Ring, FK, Winkel, Ellbogen, Knie</translation>
    </message>
    <message>
        <source>rotate, gizmo, ring, fk, angle</source>
        <translation>drehen, Gizmo, Ring, FK, Winkel</translation>
    </message>
    <message>
        <source>ripple, shift, time, slide left</source>
        <translation>verschieben, Zeit, nach links</translation>
    </message>
    <message>
        <source>ripple, shift, time, slide right</source>
        <translation>verschieben, Zeit, nach rechts</translation>
    </message>
    <message>
        <source>retime, faster, speed up, compress, scale time</source>
        <translation>Tempo, schneller, beschleunigen, stauchen, Zeit skalieren</translation>
    </message>
    <message>
        <source>retime, slower, slow down, stretch, scale time</source>
        <translation>Tempo, langsamer, verlangsamen, strecken, Zeit skalieren</translation>
    </message>
    <message>
        <source>before, after, compare, side by side, a/b, unadjusted</source>
        <translation>vorher, nachher, vergleichen, nebeneinander, A/B, unangepasst</translation>
    </message>
    <message>
        <source>onion skin, onion skinning, ghost</source>
        <translation>Zwiebelhaut, Onion Skin, Geisterbild</translation>
    </message>
    <message>
        <source>partial edit, swap arm, splice, layer, fix, retake</source>
        <translation>Teil ersetzen, Arm tauschen, Ebene, ausbessern, neu aufnehmen</translation>
    </message>
    <message>
        <source>tab, panel, joint, handle</source>
        <translation>Reiter, Seite, Gelenk, Griff</translation>
    </message>
    <message>
        <source>tab, panel, find similar, retrieval, sources, parts</source>
        <translation>Reiter, Seite, Ähnliches finden, Suche, Quellen, Teile</translation>
    </message>
    <message>
        <source>lock, fix, nail, constraint, hold foot</source>
        <translation>sperren, fixieren, festnageln, zwang, fuß halten</translation>
    </message>
    <message>
        <source>effector, hand, foot, ik, select</source>
        <translation>effektor, hand, fuß, ik, auswählen</translation>
    </message>
    <message>
        <source>raise, nudge, ik</source>
        <translation>heben, schieben, ik</translation>
    </message>
    <message>
        <source>lower, nudge, ik</source>
        <translation>senken, schieben, ik</translation>
    </message>
    <message>
        <source>nudge, ik, left</source>
        <translation>schieben, ik, links</translation>
    </message>
    <message>
        <source>nudge, ik, right</source>
        <translation>schieben, ik, rechts</translation>
    </message>
    <message>
        <source>nudge, ik, back</source>
        <translation>schieben, ik, hinten</translation>
    </message>
    <message>
        <source>nudge, ik, forward</source>
        <translation>schieben, ik, vorn</translation>
    </message>
    <message>
        <source>source, automatic, best match, reset</source>
        <translation>quelle, automatisch, beste übereinstimmung, zurücksetzen</translation>
    </message>
    <message>
        <source>delete all, reset, start over</source>
        <translation>alle löschen, zurücksetzen, neu beginnen</translation>
    </message>
    <message>
        <source>import, library, load, bvh</source>
        <translation>importieren, bibliothek, laden, bvh</translation>
    </message>
    <message>
        <source>import, library, directory, bvh</source>
        <translation>importieren, bibliothek, verzeichnis, bvh</translation>
    </message>
    <message>
        <source>save, bake, new take</source>
        <translation>speichern, backen, neuer take</translation>
    </message>
    <message>
        <source>save, bvh, gltf, glb, animation</source>
        <translation>speichern, bvh, gltf, glb, animation</translation>
    </message>
    <message>
        <source>beginning, rewind</source>
        <translation>anfang, zurückspulen</translation>
    </message>
    <message>
        <source>repeat, cycle, endless</source>
        <translation>wiederholen, schleife, endlos</translation>
    </message>
    <message>
        <source>play live, game, controller, real time</source>
        <translation>live spielen, spiel, controller, echtzeit</translation>
    </message>
    <message>
        <source>stop live, end</source>
        <translation>live beenden, ende</translation>
    </message>
    <message>
        <source>insert, append, clip, action</source>
        <translation>einfügen, anhängen, clip, aktion</translation>
    </message>
    <message>
        <source>replace, exchange, other action</source>
        <translation>ersetzen, austauschen, andere aktion</translation>
    </message>
    <message>
        <source>delete, erase, cut</source>
        <translation>löschen, entfernen, ausschneiden</translation>
    </message>
    <message>
        <source>select, jump</source>
        <translation>auswählen, springen</translation>
    </message>
    <message>
        <source>move left, reorder</source>
        <translation>nach links, umordnen</translation>
    </message>
    <message>
        <source>move right, reorder</source>
        <translation>nach rechts, umordnen</translation>
    </message>
    <message>
        <source>repeat, again, loop</source>
        <translation>wiederholen, nochmal, schleife</translation>
    </message>
    <message>
        <source>repeat less</source>
        <translation>weniger wiederholen</translation>
    </message>
    <message>
        <source>trim, in point, cut start</source>
        <translation>trimmen, in-punkt, anfang kürzen</translation>
    </message>
    <message>
        <source>trim, out point, cut end</source>
        <translation>trimmen, out-punkt, ende kürzen</translation>
    </message>
    <message>
        <source>untrim, reset</source>
        <translation>trimmen aufheben, zurücksetzen</translation>
    </message>
    <message>
        <source>random, reroll, blend, other path</source>
        <translation>zufall, würfeln, überblenden, anderer weg</translation>
    </message>
    <message>
        <source>random, reroll, shuffle</source>
        <translation>zufall, würfeln, mischen</translation>
    </message>
    <message>
        <source>fix, hold, keep</source>
        <translation>fixieren, halten, behalten</translation>
    </message>
    <message>
        <source>delete all, new, reset</source>
        <translation>alles löschen, neu, zurücksetzen</translation>
    </message>
    <message>
        <source>search, filter, actions</source>
        <translation>suche, filter, aktionen</translation>
    </message>
    <message>
        <source>library, list, show</source>
        <translation>bibliothek, liste, zeigen</translation>
    </message>
    <message>
        <source>clusters, poses, graph, space</source>
        <translation>cluster, posen, graph, raum</translation>
    </message>
    <message>
        <source>manual, documentation, guide</source>
        <translation>handbuch, dokumentation, anleitung</translation>
    </message>
    <message>
        <source>tutorial, introduction, start, guide</source>
        <translation>tutorial, einführung, start, anleitung</translation>
    </message>
    <message>
        <source>formula, explain, statistics, papers, sources</source>
        <translation>formel, erklären, statistik, artikel, quellen</translation>
    </message>
    <message>
        <source>tutorial, introduction, walkthrough, wizard, guide</source>
        <translation>tutorial, einführung, tour, assistent, anleitung</translation>
    </message>
    <message>
        <source>explain, context help</source>
        <translation>erklären, kontexthilfe, direkthilfe</translation>
    </message>
    <message>
        <source>explain, accessibility</source>
        <translation>erklären, barrierefreiheit</translation>
    </message>
    <message>
        <source>shortcuts, hotkeys, cheat sheet, help, manual, print</source>
        <translation>tastenkürzel, hotkeys, spickzettel, hilfe, handbuch, drucken</translation>
    </message>
    <message>
        <source>release notes, changelog, news, version</source>
        <translation>versionshinweise, änderungen, neuigkeiten, version</translation>
    </message>
    <message>
        <source>version, licence, license</source>
        <translation>version, lizenz</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ActionTiles</name>
    <message>
        <source>Similar actions</source>
        <translation>Ähnliche Aktionen</translation>
    </message>
    <message>
        <source>Those that look most like the current action, side by side.</source>
        <translation>Die der aktuellen Aktion am ähnlichsten sehen, nebeneinander.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ActionsModel</name>
    <message>
        <source>%1, %2 from %3
Return adds it, Shift+Return swaps it for the chosen block</source>
        <translation>%1, %2 aus %3
Eingabe fügt sie hinzu, Umschalt+Eingabe tauscht den gewählten Block gegen sie</translation>
    </message>
    <message>
        <source>action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>where</source>
        <translation>wo</translation>
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
        <translation>Zeit des Kampfs</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutCommands</name>
    <message>
        <source>Avatar: %1</source>
        <translation>Avatar: %1</translation>
    </message>
    <message>
        <source>The analysis is not finished yet.</source>
        <translation>Die Analyse ist noch nicht fertig.</translation>
    </message>
    <message>
        <source>Keep the bout as a take</source>
        <translation>Kampf als Take behalten</translation>
    </message>
    <message>
        <source>Recordings, NAME-1 and NAME-2 (*.bvh)</source>
        <translation>Aufnahmen, NAME-1 und NAME-2 (*.bvh)</translation>
    </message>
    <message>
        <source>Keeping the bout</source>
        <translation>Kampf wird behalten</translation>
    </message>
    <message>
        <source>The project changed while the bout was written. Its files are there; open them as a take, or keep it again under another name.</source>
        <translation>Das Projekt wurde geändert, während der Kampf geschrieben wurde. Die Dateien sind da; öffnen Sie sie als Take, oder behalten Sie den Kampf noch einmal unter anderem Namen.</translation>
    </message>
    <message>
        <source>Kept as take %1. Detection alone finds %2 % and %3 % of its boundaries.</source>
        <translation>Als Take %1 behalten. Die Erkennung allein findet %2 % und %3 % seiner Grenzen.</translation>
    </message>
    <message>
        <source>Writing the bout</source>
        <translation>Kampf wird geschrieben</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Export the bout</source>
        <translation>Kampf exportieren</translation>
    </message>
    <message>
        <source>Motion of both, NAME-1 and NAME-2 (*.bvh);;glTF: skeletons and animation (*.glb);;Pictures, 30 a second (*.png);;Video, by ffmpeg (*.mp4);;Log: everything that makes it again (*.json)</source>
        <translation>Bewegung beider, NAME-1 und NAME-2 (*.bvh);;glTF: Skelette und Animation (*.glb);;Bilder, 30 je Sekunde (*.png);;Video, mit ffmpeg (*.mp4);;Protokoll: alles, um ihn wieder zu erzeugen (*.json)</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>&amp;Bout</source>
        <translation>&amp;Kampf</translation>
    </message>
    <message>
        <source>&amp;Fight or pause</source>
        <translation>&amp;Kämpfen oder anhalten</translation>
    </message>
    <message>
        <source>Begin a&amp;new</source>
        <translation>&amp;Neu beginnen</translation>
    </message>
    <message>
        <source>Begin with the next &amp;seed</source>
        <translation>Mit dem nächsten &amp;Startwert beginnen</translation>
    </message>
    <message>
        <source>Go on from here with other &amp;draws</source>
        <translation>Von hier anders &amp;weiter</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ein Frame zurück</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Ein Frame vor</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>Eine Sekunde zurück</translation>
    </message>
    <message>
        <source>One second on</source>
        <translation>Eine Sekunde vor</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>To the end of what was shown</source>
        <translation>Zum Ende des Gezeigten</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>&amp;Automatic: the model decides</source>
        <translation>&amp;Automatisch: Das Modell entscheidet</translation>
    </message>
    <message>
        <source>A&amp;vatar: keys lead one fighter</source>
        <translation>A&amp;vatar: Tasten führen einen Kämpfer</translation>
    </message>
    <message>
        <source>&amp;Passive: one answers a captured attack</source>
        <translation>&amp;Passiv: Einer antwortet auf einen aufgenommenen Angriff</translation>
    </message>
    <message>
        <source>Avatar: key %1</source>
        <translation>Avatar: Taste %1</translation>
    </message>
    <message>
        <source>Avatar: forget &amp;what was asked for</source>
        <translation>Avatar: Gewünschtes ver&amp;gessen</translation>
    </message>
    <message>
        <source>&amp;Measure the quality</source>
        <translation>&amp;Qualität messen</translation>
    </message>
    <message>
        <source>&amp;Keep as a take…</source>
        <translation>Als &amp;Take behalten…</translation>
    </message>
    <message>
        <source>E&amp;xport the bout…</source>
        <translation>Kampf e&amp;xportieren…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutExport</name>
    <message>
        <source>%1: it cannot be written there.</source>
        <translation>%1: Dorthin kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>There is no ffmpeg on this computer, which a video needs: install it (on Debian and Ubuntu: sudo apt install ffmpeg), or export pictures (.png).</source>
        <translation>Auf diesem Computer fehlt ffmpeg, das für ein Video nötig ist: Installieren Sie es (unter Debian und Ubuntu: sudo apt install ffmpeg), oder exportieren Sie Bilder (.png).</translation>
    </message>
    <message>
        <source>%1 cannot be started.</source>
        <translation>%1 kann nicht gestartet werden.</translation>
    </message>
    <message>
        <source>ffmpeg could not write the video: %1</source>
        <translation>ffmpeg konnte das Video nicht schreiben: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutPage</name>
    <message>
        <source>Why there is no bout</source>
        <translation>Warum es keinen Kampf gibt</translation>
    </message>
    <message>
        <source>Anew</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>Behalten…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>A bout that goes on for ever, made from what was learnt of the labelled actions, appears here.</source>
        <translation>Hier erscheint ein endloser Kampf aus dem, was aus den gelabelten Aktionen gelernt wurde.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutPanel</name>
    <message>
        <source>foot skate</source>
        <translation>Fußrutschen</translation>
    </message>
    <message>
        <source>Share of frames in which a foot near the floor slides faster than 0.5 m/s</source>
        <translation>Anteil der Frames, in denen ein Fuß nahe am Boden schneller als 0,5 m/s rutscht</translation>
    </message>
    <message>
        <source>in the floor</source>
        <translation>im Boden</translation>
    </message>
    <message>
        <source>Share of frames with a foot more than 5 mm in the floor</source>
        <translation>Anteil der Frames mit einem Fuß mehr als 5 mm im Boden</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Share of frames with the bodies more than 3 cm in each other</source>
        <translation>Anteil der Frames, in denen die Körper mehr als 3 cm ineinander stecken</translation>
    </message>
    <message>
        <source>joins</source>
        <translation>Nahtstellen</translation>
    </message>
    <message>
        <source>Joint accelerations where actions are joined, their 99th percentile over that inside recorded actions</source>
        <translation>Gelenkbeschleunigungen an den Nahtstellen der Aktionen: ihr 99. Perzentil im Verhältnis zu dem in aufgenommenen Aktionen</translation>
    </message>
    <message>
        <source>facing</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Mean angle between where a fighter faces and its opponent</source>
        <translation>Mittlerer Winkel zwischen der Blickrichtung eines Kämpfers und seinem Gegner</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Mean distance between both fighters</source>
        <translation>Mittlerer Abstand beider Kämpfer</translation>
    </message>
    <message>
        <source>hit timing</source>
        <translation>Treffer-Timing</translation>
    </message>
    <message>
        <source>How far reactions are from their due moment, on average</source>
        <translation>Wie weit Reaktionen im Mittel von ihrem fälligen Moment entfernt sind</translation>
    </message>
    <message>
        <source>variety</source>
        <translation>Vielfalt</translation>
    </message>
    <message>
        <source>Share of distinct runs of three labels; falls with length</source>
        <translation>Anteil verschiedener Folgen von drei Labels; sinkt mit der Länge</translation>
    </message>
    <message>
        <source>reacts first</source>
        <translation>reagiert zuerst</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Avatar</source>
        <translation>Avatar</translation>
    </message>
    <message>
        <source>Passive</source>
        <translation>Passiv</translation>
    </message>
    <message>
        <source>The model decides for both</source>
        <translation>Das Modell entscheidet für beide</translation>
    </message>
    <message>
        <source>Keys and pointer lead one fighter, the model the other</source>
        <translation>Tasten und Zeiger führen einen Kämpfer, das Modell den anderen</translation>
    </message>
    <message>
        <source>One replays a captured attack that the model has not seen; the other answers and may not attack</source>
        <translation>Einer spielt einen aufgenommenen Angriff nach, den das Modell nicht kennt; der andere antwortet und darf nicht angreifen</translation>
    </message>
    <message>
        <source>Under attack the avatar may answer before it does as asked</source>
        <translation>Unter Angriff darf der Avatar antworten, bevor er das Gewünschte tut</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>The same seed gives the same bout</source>
        <translation>Derselbe Startwert ergibt denselben Kampf</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>0: always the likeliest; 1: as learnt; above: more even</source>
        <translation>0: immer das Wahrscheinlichste; 1: wie gelernt; darüber: gleichmäßiger</translation>
    </message>
    <message>
        <source>State of the bout</source>
        <translation>Zustand des Kampfs</translation>
    </message>
    <message>
        <source>Why this?</source>
        <translation>Warum das?</translation>
    </message>
    <message>
        <source>The choice</source>
        <translation>Die Wahl</translation>
    </message>
    <message>
        <source>What else it could have done</source>
        <translation>Was sonst möglich war</translation>
    </message>
    <message>
        <source>A click takes another one and goes on from there</source>
        <translation>Ein Klick nimmt eine andere und macht von dort weiter</translation>
    </message>
    <message>
        <source>It cannot be taken: %1.</source>
        <translation>Sie ist nicht wählbar: %1.</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Measures all that was shown, beside the longest recording</source>
        <translation>Misst alles bisher Gezeigte, neben der längsten Aufnahme</translation>
    </message>
    <message>
        <source>Quality of the bout and of the recording</source>
        <translation>Qualität des Kampfs und der Aufnahme</translation>
    </message>
    <message>
        <source>bout</source>
        <translation>Kampf</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>aufgenommen</translation>
    </message>
    <message>
        <source>attacker</source>
        <translation>Angreifer</translation>
    </message>
    <message>
        <source>avatar</source>
        <translation>Avatar</translation>
    </message>
    <message>
        <source>Who attacks</source>
        <translation>Wer angreift</translation>
    </message>
    <message>
        <source>Who is led</source>
        <translation>Wer geführt wird</translation>
    </message>
    <message>
        <source>The fighter that replays a captured attack</source>
        <translation>Der Kämpfer, der einen aufgenommenen Angriff nachspielt</translation>
    </message>
    <message>
        <source>The fighter that keys and clicks on the floor lead</source>
        <translation>Der Kämpfer, den Tasten und Klicks auf den Boden führen</translation>
    </message>
    <message>
        <source>A bout is being prepared.</source>
        <translation>Ein Kampf wird vorbereitet.</translation>
    </message>
    <message>
        <source>Keys 1 to 9 ask the avatar for something, a click on the floor says where to be.</source>
        <translation>Die Tasten 1 bis 9 geben dem Avatar einen Wunsch, ein Klick auf den Boden einen Ort.</translation>
    </message>
    <message>
        <source>Asked for: %1</source>
        <translation>Gewünscht: %1</translation>
    </message>
    <message>
        <source>Labels or boundaries changed: begin anew to use them.</source>
        <translation>Labels oder Grenzen haben sich geändert: Beginnen Sie neu, um sie zu nutzen.</translation>
    </message>
    <message>
        <source>Each choice, with all that could have been, appears here.</source>
        <translation>Hier erscheint jede Wahl mit allem, was möglich gewesen wäre.</translation>
    </message>
    <message>
        <source>%1 at %2, after %3, while %4</source>
        <translation>%1 bei %2, nach %3, Gegner: %4</translation>
    </message>
    <message>
        <source>: replayed</source>
        <translation>: nachgespielt</translation>
    </message>
    <message>
        <source>: chosen by hand</source>
        <translation>: von Hand gewählt</translation>
    </message>
    <message>
        <source>: as asked for</source>
        <translation>: wie gewünscht</translation>
    </message>
    <message>
        <source> (no other stance was left)</source>
        <translation> (kein anderer Stand war übrig)</translation>
    </message>
    <message>
        <source>Measure (%1 s)</source>
        <translation>Messen (%1 s)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutSession</name>
    <message>
        <source>anything</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Preparing a bout</source>
        <translation>Kampf wird vorbereitet</translation>
    </message>
    <message>
        <source>Measuring the bout</source>
        <translation>Kampf wird gemessen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutStrip</name>
    <message>
        <source>Actions of the bout</source>
        <translation>Aktionen des Kampfs</translation>
    </message>
    <message>
        <source>%1 · %2 to %3 · %4</source>
        <translation>%1 · %2 bis %3 · %4</translation>
    </message>
    <message>
        <source>   ·   as asked for</source>
        <translation>   ·   wie gewünscht</translation>
    </message>
    <message>
        <source>   ·   chosen by hand</source>
        <translation>   ·   von Hand gewählt</translation>
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
        <translation>Label %1</translation>
    </message>
    <message>
        <source>geom. %1</source>
        <translation>Geom. %1</translation>
    </message>
    <message>
        <source>both %1</source>
        <translation>beide %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CandidatesModel</name>
    <message>
        <source>no example</source>
        <translation>kein Beispiel</translation>
    </message>
    <message>
        <source>not in this mode</source>
        <translation>nicht in diesem Modus</translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation>nicht gewünscht</translation>
    </message>
    <message>
        <source>other stance</source>
        <translation>anderer Stand</translation>
    </message>
    <message>
        <source>banned</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>%1: chance %2, label term %3, geometry term %4, product %5</source>
        <translation>%1: Chance %2, Label-Term %3, Geometrie-Term %4, Produkt %5</translation>
    </message>
    <message>
        <source>
Sample: %1, %2</source>
        <translation>
Beispiel: %1, %2</translation>
    </message>
    <message>
        <source>
Could not be drawn: %1</source>
        <translation>
Konnte nicht gezogen werden: %1</translation>
    </message>
    <message>
        <source>
This was chosen</source>
        <translation>
Das wurde gewählt</translation>
    </message>
    <message>
        <source>
A click takes it instead</source>
        <translation>
Ein Klick nimmt dies stattdessen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ClusterMap</name>
    <message>
        <source>Map of poses</source>
        <translation>Posenkarte</translation>
    </message>
    <message>
        <source>A map of the poses appears here: like ones near each other, and the way that a transition takes.</source>
        <translation>Hier erscheint eine Karte der Posen: ähnliche nah beieinander, dazu der Weg eines Übergangs.</translation>
    </message>
    <message>
        <source>%1 kinds of poses, like ones near each other · line: what leads where</source>
        <translation>%1 Arten von Posen, ähnliche nah beieinander · Linie: was wohin führt</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CommandPalette</name>
    <message>
        <source> · on</source>
        <translation> · an</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Eintippen, was Sie tun wollen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>A name, a menu or a word for it: ↑ ↓ choose, Return runs, Esc leaves</source>
        <translation>Ein Name, ein Menü oder ein Wort dafür: ↑ ↓ wählen, Eingabe führt aus, Esc schließt</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>%1 · “%2”</source>
        <translation>%1 · „%2“</translation>
    </message>
    <message>
        <source>No command that can be run now is called “%1”.</source>
        <translation>Kein Befehl, der jetzt ausführbar ist, heißt „%1“.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CompareBox</name>
    <message>
        <source>Compare with settings B</source>
        <translation>Mit Einstellungen B vergleichen</translation>
    </message>
    <message>
        <source> B</source>
        <translation> B</translation>
    </message>
    <message>
        <source>Use B</source>
        <translation>B verwenden</translation>
    </message>
    <message>
        <source>Draw beside the project&apos;s boundaries (A) those that other settings give</source>
        <translation>Neben den Grenzen des Projekts (A) die anderer Einstellungen zeichnen</translation>
    </message>
    <message>
        <source>Boundaries that differ</source>
        <translation>Abweichende Grenzen</translation>
    </message>
    <message>
        <source>On the timeline: ○ only in A, dotted lines only in B</source>
        <translation>Auf der Zeitleiste: ○ nur in A, gepunktete Linien nur in B</translation>
    </message>
    <message>
        <source>Cut the project by settings B</source>
        <translation>Projekt mit Einstellungen B schneiden</translation>
    </message>
    <message>
        <source>Comparing settings</source>
        <translation>Einstellungen werden verglichen</translation>
    </message>
    <message>
        <source>%1: %2 in both, %3 only A, %4 only B</source>
        <translation>%1: %2 in beiden, %3 nur A, %4 nur B</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CompareLabelsBox</name>
    <message>
        <source>Take theirs</source>
        <translation>Anderes nehmen</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Meins behalten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>Aspekt</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>κ</source>
        <translation>κ</translation>
    </message>
    <message>
        <source>Agreement per aspect</source>
        <translation>Übereinstimmung je Aspekt</translation>
    </message>
    <message>
        <source>Both: actions of which both people said something. κ (Cohen): how much more often they say the same than by chance; 1 always, 0 as often as by chance.</source>
        <translation>Beide: Aktionen, zu denen beide Personen etwas gesagt haben. κ (Cohen): wie viel öfter sie dasselbe sagen als durch Zufall; 1 immer, 0 so oft wie durch Zufall.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Their value, as said by a hand; goes on to the next (Enter)</source>
        <translation>Der Wert der anderen Person, wie von Hand gesagt; weiter zum nächsten (Eingabe)</translation>
    </message>
    <message>
        <source>What the project says stays; goes on to the next (Backspace)</source>
        <translation>Was das Projekt sagt, bleibt; weiter zum nächsten (Rücktaste)</translation>
    </message>
    <message>
        <source>Theirs for all that are not decided, as one step of the history</source>
        <translation>Für alle unentschiedenen den Wert der anderen Person, als ein Schritt des Verlaufs</translation>
    </message>
    <message>
        <source>Their labels where you have none, as said by a hand, in one step</source>
        <translation>Labels der anderen Person, wo Sie keines haben, wie von Hand gesagt, in einem Schritt</translation>
    </message>
    <message>
        <source>The boundaries have changed. Open %1 once more to compare.</source>
        <translation>Die Grenzen haben sich geändert. Öffnen Sie %1 noch einmal zum Vergleichen.</translation>
    </message>
    <message>
        <source>Another person&apos;s labels are compared here with those of the project: Label &gt; Compare with labels of… opens their file.</source>
        <translation>Hier werden die Labels einer anderen Person mit denen des Projekts verglichen: Labels &gt; Vergleichen mit Labels von… öffnet ihre Datei.</translation>
    </message>
    <message>
        <source>%1: 1 action labelled by both, %2 alike</source>
        <translation>%1: 1 von beiden gelabelte Aktion, %2 gleich</translation>
    </message>
    <message>
        <source>%1: %3 actions labelled by both, %2 alike</source>
        <translation>%1: %3 von beiden gelabelte Aktionen, %2 gleich</translation>
    </message>
    <message>
        <source>, κ %1</source>
        <translation>, κ %1</translation>
    </message>
    <message>
        <source>. No difference to decide.</source>
        <translation>. Kein Unterschied zu entscheiden.</translation>
    </message>
    <message>
        <source>. 1 difference to decide.</source>
        <translation>. 1 Unterschied zu entscheiden.</translation>
    </message>
    <message>
        <source>. %1 differences to decide.</source>
        <translation>. %1 Unterschiede zu entscheiden.</translation>
    </message>
    <message>
        <source> Only you labelled %1 more.</source>
        <translation> Nur Sie haben %1 weitere gelabelt.</translation>
    </message>
    <message>
        <source>Theirs for all %1</source>
        <translation>Anderes für alle %1</translation>
    </message>
    <message>
        <source>Add the 1 that only they labelled</source>
        <translation>Die 1 nur dort gelabelte hinzufügen</translation>
    </message>
    <message>
        <source>Add the %1 that only they labelled</source>
        <translation>Die %1 nur dort gelabelten hinzufügen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ConfusionMatrix</name>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>Confusion matrix</source>
        <translation>Konfusionsmatrix</translation>
    </message>
    <message>
        <source>by rule</source>
        <translation>per Regel</translation>
    </message>
    <message>
        <source>by machine</source>
        <translation>per Maschine</translation>
    </message>
    <message>
        <source>%1 by hand and %2: </source>
        <translation>%1 von Hand und %2: </translation>
    </message>
    <message>
        <source>%1 by hand, %2 %3: </source>
        <translation>%1 von Hand, %2 %3: </translation>
    </message>
    <message>
        <source>1 action</source>
        <translation>1 Aktion</translation>
    </message>
    <message>
        <source>%1 actions</source>
        <translation>%1 Aktionen</translation>
    </message>
    <message>
        <source>, %1 of %2</source>
        <translation>, %1 von %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DetectionBox</name>
    <message>
        <source>Warning about the cutoff</source>
        <translation>Warnung zur Grenzfrequenz</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DifferencesModel</name>
    <message>
        <source>%1, %2, %3: mine %4, theirs %5</source>
        <translation>%1, %2, %3: meins %4, anderes %5</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>Aspekt</translation>
    </message>
    <message>
        <source>mine</source>
        <translation>meins</translation>
    </message>
    <message>
        <source>theirs</source>
        <translation>anderes</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DistanceGridView</name>
    <message>
        <source>Distances of poses where motions are joined</source>
        <translation>Abstände der Posen an der Nahtstelle der Bewegungen</translation>
    </message>
    <message>
        <source>How far the poses are from each other: the last frames of what was there down, the first frames of what comes in to the right. The stronger the colour, the nearer they are; the ring is where both were joined.</source>
        <translation>Wie weit die Posen voneinander entfernt sind: nach unten die letzten Frames der alten Bewegung, nach rechts die ersten der neuen. Je kräftiger die Farbe, desto näher; der Ring zeigt, wo verbunden wurde.</translation>
    </message>
    <message>
        <source>frames that come in →</source>
        <translation>neue Frames →</translation>
    </message>
    <message>
        <source>← frames there</source>
        <translation>← alte Frames</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Document</name>
    <message>
        <source>The force curves are still being computed; try again in a moment.</source>
        <translation>Die Kraftkurven werden noch berechnet; versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>Computing force curves</source>
        <translation>Kraftkurven werden berechnet</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DocumentPanel</name>
    <message>
        <source>Add recordings to begin a take.</source>
        <translation>Fügen Sie Aufnahmen hinzu, um einen Take zu beginnen.</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Takes</translation>
    </message>
    <message>
        <source>Fighters</source>
        <translation>Kämpfer</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source> (missing)</source>
        <translation> (fehlt)</translation>
    </message>
    <message>
        <source>%1: %2
%3 Hz, %4 frames
Double-click: start, place, floor, joints</source>
        <translation>%1: %2
%3 Hz, %4 Frames
Doppelklick: Start, Ort, Boden, Gelenke</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FighterProperties</name>
    <message>
        <source>Fighter properties</source>
        <translation>Eigenschaften des Kämpfers</translation>
    </message>
    <message>
        <source>Fighter</source>
        <translation>Kämpfer</translation>
    </message>
    <message>
        <source>Whose properties are shown: the active fighter&apos;s (Tab)</source>
        <translation>Wessen Eigenschaften gezeigt werden: die des aktiven Kämpfers (Tab)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Start in seconds</source>
        <translation>Start in Sekunden</translation>
    </message>
    <message>
        <source>When its first frame stands on the clock of the take; puts the fighters in step.</source>
        <translation>Wann sein erstes Frame auf der Uhr des Takes steht; bringt die Kämpfer in Gleichtakt.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Starts at</source>
        <translation>Beginnt bei</translation>
    </message>
    <message>
        <source>Place in the bout</source>
        <translation>Ort im Kampf</translation>
    </message>
    <message>
        <source>x in metres</source>
        <translation>x in Metern</translation>
    </message>
    <message>
        <source>Shifts the fighter to the side.</source>
        <translation>Verschiebt den Kämpfer zur Seite.</translation>
    </message>
    <message>
        <source>z in metres</source>
        <translation>z in Metern</translation>
    </message>
    <message>
        <source>Shifts the fighter forward or back.</source>
        <translation>Verschiebt den Kämpfer vor oder zurück.</translation>
    </message>
    <message>
        <source>Turn in degrees</source>
        <translation>Drehung in Grad</translation>
    </message>
    <message>
        <source>Turns the fighter about the origin of its recording, before it is shifted.</source>
        <translation>Dreht den Kämpfer um den Ursprung seiner Aufnahme, bevor er verschoben wird.</translation>
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
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>found from the feet</source>
        <translation>aus den Füßen ermittelt</translation>
    </message>
    <message>
        <source>The height at which the feet rest; switch it off to set the floor by hand.</source>
        <translation>Die Höhe, auf der die Füße ruhen; ausschalten, um den Boden von Hand zu setzen.</translation>
    </message>
    <message>
        <source>Height of the floor in metres</source>
        <translation>Höhe des Bodens in Metern</translation>
    </message>
    <message>
        <source>Where the floor is in the space of the recording.</source>
        <translation>Wo der Boden im Raum der Aufnahme liegt.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Body model of the project</source>
        <translation>Körpermodell des Projekts</translation>
    </message>
    <message>
        <source>Body model</source>
        <translation>Körpermodell</translation>
    </message>
    <message>
        <source>How the mass is spread over the body: what the centre of mass and with it the contact force are made of.</source>
        <translation>Wie die Masse über den Körper verteilt ist: Daraus entstehen der Schwerpunkt und damit die Kontaktkraft.</translation>
    </message>
    <message>
        <source>Which joint is what</source>
        <translation>Welches Gelenk was ist</translation>
    </message>
    <message>
        <source>Joint of the role %1</source>
        <translation>Gelenk der Rolle %1</translation>
    </message>
    <message>
        <source>The joint of the recording that is the %1 of the body.</source>
        <translation>Das Gelenk der Aufnahme, das am Körper die Rolle %1 hat.</translation>
    </message>
    <message>
        <source>Start, place, floor and joints of a fighter appear here as soon as there is a take.</source>
        <translation>Start, Ort, Boden und Gelenke eines Kämpfers erscheinen hier, sobald es einen Take gibt.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 Hz, frames %2 to %3 of %4, %5 joints</source>
        <translation>%1 Hz, Frames %2 bis %3 von %4, %5 Gelenke</translation>
    </message>
    <message>
        <source>one unit is %1 m, %2 is up</source>
        <translation>eine Einheit ist %1 m, %2 zeigt nach oben</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>The recording is missing: File, Find recording.</source>
        <translation>Die Aufnahme fehlt: Datei, Aufnahme suchen.</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei…</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>1 role has no joint.</source>
        <translation>1 Rolle hat kein Gelenk.</translation>
    </message>
    <message>
        <source>%1 roles have no joint.</source>
        <translation>%1 Rollen haben kein Gelenk.</translation>
    </message>
    <message>
        <source>Open a body model</source>
        <translation>Körpermodell öffnen</translation>
    </message>
    <message>
        <source>Body models (*.json)</source>
        <translation>Körpermodelle (*.json)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FileActions</name>
    <message>
        <source>A project opens alone: choose one .kumite file, or one or two recordings.</source>
        <translation>Ein Projekt wird allein geöffnet: Wählen Sie eine .kumite-Datei oder eine oder zwei Aufnahmen.</translation>
    </message>
    <message>
        <source>A take has one or two fighters: choose one or two recordings, not %1.</source>
        <translation>Ein Take hat einen oder zwei Kämpfer: Wählen Sie eine oder zwei Aufnahmen, nicht %1.</translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation>Anderswo geöffnet</translation>
    </message>
    <message>
        <source>%1 is open in another studio.</source>
        <translation>%1 ist in einem anderen Studio geöffnet.</translation>
    </message>
    <message>
        <source>A copy can be changed and saved under another name. Taking over, you save into this file, and so may the other.</source>
        <translation>Eine Kopie lässt sich ändern und unter anderem Namen speichern. Übernehmen Sie, so speichern Sie in diese Datei, und das andere Studio vielleicht auch.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Kopie öffnen</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Found in %1</source>
        <translation>In %1 gefunden</translation>
    </message>
    <message>
        <source>Making the demo bout</source>
        <translation>Demo-Kampf wird erzeugt</translation>
    </message>
    <message>
        <source>The demo bout: two made fighters. Save it to keep what you change.</source>
        <translation>Der Demo-Kampf: zwei erzeugte Kämpfer. Speichern Sie ihn, um Ihre Änderungen zu behalten.</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1 wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Found while recovering</source>
        <translation>Beim Wiederherstellen gefunden</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Found in the recordings</source>
        <translation>In den Aufnahmen gefunden</translation>
    </message>
    <message>
        <source>Open one or two recordings</source>
        <translation>Eine oder zwei Aufnahmen öffnen</translation>
    </message>
    <message>
        <source>Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)</source>
        <translation>Aufnahmen (*.bvh *.BVH *.amc *.AMC);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Kumite projects (*.kumite)</source>
        <translation>Kumite-Projekte (*.kumite)</translation>
    </message>
    <message>
        <source>Where is %1 of %2?</source>
        <translation>Wo ist %1 von %2?</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Found while saving</source>
        <translation>Beim Speichern gefunden</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Save all the same</source>
        <translation>Trotzdem speichern</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Changed on the disk</source>
        <translation>Auf der Platte geändert</translation>
    </message>
    <message>
        <source>%1 was changed outside this window since you opened it.</source>
        <translation>%1 wurde außerhalb dieses Fensters geändert, seit Sie die Datei geöffnet haben.</translation>
    </message>
    <message>
        <source>It was written %1. If you save over it, what it holds now is kept as a version.</source>
        <translation>Sie wurde %1 geschrieben. Wenn Sie sie überschreiben, bleibt ihr jetziger Inhalt als Version erhalten.</translation>
    </message>
    <message>
        <source>Save over it</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Export the actions of this take</source>
        <translation>Aktionen dieses Takes exportieren</translation>
    </message>
    <message>
        <source>Table of actions (*.csv);;Segmentation (*.json)</source>
        <translation>Tabelle der Aktionen (*.csv);;Segmentierung (*.json)</translation>
    </message>
    <message>
        <source>Export the motion of this take</source>
        <translation>Bewegung dieses Takes exportieren</translation>
    </message>
    <message>
        <source>Motion, one file per fighter (*.bvh)</source>
        <translation>Bewegung, eine Datei je Kämpfer (*.bvh)</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1 exportiert.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>Reading the version of %1</source>
        <translation>Die Version von %1 wird gelesen</translation>
    </message>
    <message>
        <source>Found in the version</source>
        <translation>In der Version gefunden</translation>
    </message>
    <message>
        <source>Restored the version of %1; Ctrl+Z takes it back.</source>
        <translation>Die Version von %1 ist wiederhergestellt; Strg+Z nimmt das zurück.</translation>
    </message>
    <message>
        <source>That version is what is open.</source>
        <translation>Diese Version ist gerade geöffnet.</translation>
    </message>
    <message>
        <source>The version of %1 is open as a copy.</source>
        <translation>Die Version von %1 ist als Kopie geöffnet.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Änderungen an %1 speichern?</translation>
    </message>
    <message>
        <source>What is not saved is lost.</source>
        <translation>Was nicht gespeichert wird, geht verloren.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FindBox</name>
    <message>
        <source>Actions found</source>
        <translation>Gefundene Aktionen</translation>
    </message>
    <message>
        <source>right kick up, machine, below 0.6</source>
        <translation>z. B. right kick up, machine, below 0.6</translation>
    </message>
    <message>
        <source>Find actions</source>
        <translation>Aktionen suchen</translation>
    </message>
    <message>
        <source>Aspects and qualifiers (kick, right punch fwd, jump none), who said it (by hand, machine, rule), how surely (uncertain, below 0.6), which fighter or take, when (after 1:20, longer than 1 s), unlabelled. All must hold; &quot;or&quot; joins two, &quot;not&quot; turns one round. Source and confidence are those of the aspects that are named.</source>
        <translation>Aspekte und Zusätze (kick, right punch fwd, jump none), wer es sagt (by hand, machine, rule), wie sicher (uncertain, below 0.6), welcher Kämpfer oder Take, wann (after 1:20, longer than 1 s), ohne Label (unlabelled). Alles muss zutreffen; „or“ verbindet zwei, „not“ kehrt eines um. Quelle und Sicherheit sind die der genannten Aspekte.</translation>
    </message>
    <message>
        <source>What was understood</source>
        <translation>Was verstanden wurde</translation>
    </message>
    <message>
        <source>Choose all that were found in this take: the next label goes to all of them, as one step</source>
        <translation>Alle in diesem Take gefundenen auswählen: Das nächste Label gilt für alle, in einem Schritt</translation>
    </message>
    <message>
        <source>1 action</source>
        <translation>1 Aktion</translation>
    </message>
    <message>
        <source>%1 actions</source>
        <translation>%1 Aktionen</translation>
    </message>
    <message>
        <source>Choose all %1</source>
        <translation>Alle %1 auswählen</translation>
    </message>
    <message>
        <source>The actions of the bout appear here once a recording is cut.</source>
        <translation>Die Aktionen des Kampfs erscheinen hier, sobald eine Aufnahme geschnitten ist.</translation>
    </message>
    <message>
        <source>No action is like that.</source>
        <translation>Keine Aktion passt dazu.</translation>
    </message>
    <message>
        <source>Choose all</source>
        <translation>Alle auswählen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FindingsPage</name>
    <message>
        <source>Findings in the recordings</source>
        <translation>Befunde zu den Aufnahmen</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Diese Seite schließen (Esc)</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>What is odd or worth knowing about the recordings of a project is listed here. There is nothing.</source>
        <translation>Hier steht, was an den Aufnahmen eines Projekts seltsam oder wissenswert ist. Es gibt nichts.</translation>
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
        <translation>Wer es sagt; bei mehreren Aspekten der unsicherste</translation>
    </message>
    <message>
        <source>Confidence; of several aspects the least</source>
        <translation>Sicherheit; bei mehreren Aspekten die geringste</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>by</source>
        <translation>von</translation>
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
        <translation>Matrix</translation>
    </message>
    <message>
        <source>Transitions as a matrix (V)</source>
        <translation>Übergänge als Matrix (V)</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Graph</translation>
    </message>
    <message>
        <source>Transitions as circles and edges (V)</source>
        <translation>Übergänge als Kreise und Kanten (V)</translation>
    </message>
    <message>
        <source>What %1 does next (Tab)</source>
        <translation>Was %1 als Nächstes tut (Tab)</translation>
    </message>
    <message>
        <source>compared with nothing</source>
        <translation>ohne Vergleich</translation>
    </message>
    <message>
        <source>with the other fighter</source>
        <translation>mit dem anderen Kämpfer</translation>
    </message>
    <message>
        <source>with labels by hand alone</source>
        <translation>nur mit Labels von Hand</translation>
    </message>
    <message>
        <source>with EQU7</source>
        <translation>mit EQU7</translation>
    </message>
    <message>
        <source>with EQU6</source>
        <translation>mit EQU6</translation>
    </message>
    <message>
        <source>with EQU5</source>
        <translation>mit EQU5</translation>
    </message>
    <message>
        <source>What it is compared with</source>
        <translation>Womit verglichen wird</translation>
    </message>
    <message>
        <source>Compares with another, side by side or as a difference</source>
        <translation>Vergleicht mit einer anderen, nebeneinander oder als Differenz</translation>
    </message>
    <message>
        <source>What each fighter tends to do next</source>
        <translation>Wozu jeder Kämpfer als Nächstes neigt</translation>
    </message>
    <message>
        <source>Why nothing is shown</source>
        <translation>Warum nichts gezeigt wird</translation>
    </message>
    <message>
        <source>Transitions are being learnt from the labels.</source>
        <translation>Übergänge werden aus den Labels gelernt.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphCommands</name>
    <message>
        <source>Export transitions</source>
        <translation>Übergänge exportieren</translation>
    </message>
    <message>
        <source>Edges as a table (*.csv);;Graph and model (*.json);;Graph (*.graphml);;Picture (*.png);;Picture of lines (*.svg)</source>
        <translation>Kanten als Tabelle (*.csv);;Graph und Modell (*.json);;Graph (*.graphml);;Bild (*.png);;Vektorbild (*.svg)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>&amp;Graph</source>
        <translation>&amp;Graph</translation>
    </message>
    <message>
        <source>&amp;Matrix or graph</source>
        <translation>&amp;Matrix oder Graph</translation>
    </message>
    <message>
        <source>Graph in &amp;space</source>
        <translation>Graph &amp;im Raum</translation>
    </message>
    <message>
        <source>&amp;Play what is behind it, the next each time</source>
        <translation>Ab&amp;spielen, was dahintersteckt, jedes Mal das Nächste</translation>
    </message>
    <message>
        <source>&amp;Next surprise</source>
        <translation>&amp;Nächste Überraschung</translation>
    </message>
    <message>
        <source>Pre&amp;vious surprise</source>
        <translation>&amp;Vorige Überraschung</translation>
    </message>
    <message>
        <source>Surprise of bo&amp;th terms</source>
        <translation>Überraschung aus &amp;beiden Termen</translation>
    </message>
    <message>
        <source>S&amp;urprise of the label term</source>
        <translation>Überraschung aus dem &amp;Label-Term</translation>
    </message>
    <message>
        <source>Su&amp;rprise of the geometry term</source>
        <translation>Überraschung aus dem &amp;Geometrie-Term</translation>
    </message>
    <message>
        <source>Rows by &amp;own label</source>
        <translation>Zeilen nach &amp;eigenem Label</translation>
    </message>
    <message>
        <source>Ro&amp;ws by opponent&apos;s label</source>
        <translation>Zeilen nach Label &amp;des Gegners</translation>
    </message>
    <message>
        <source>Rows by &amp;both labels</source>
        <translation>&amp;Zeilen nach beiden Labels</translation>
    </message>
    <message>
        <source>Sort by &amp;count</source>
        <translation>Nach &amp;Anzahl sortieren</translation>
    </message>
    <message>
        <source>Sort by n&amp;ame</source>
        <translation>Nach Namen s&amp;ortieren</translation>
    </message>
    <message>
        <source>Sort by &amp;likeness</source>
        <translation>Nach Ähnlic&amp;hkeit sortieren</translation>
    </message>
    <message>
        <source>Lar&amp;ger cells</source>
        <translation>G&amp;rößere Zellen</translation>
    </message>
    <message>
        <source>Smaller cells</source>
        <translation>Kleinere Zellen</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>Alles ein&amp;passen</translation>
    </message>
    <message>
        <source>E&amp;xport transitions…</source>
        <translation>Übergänge e&amp;xportieren…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphExport</name>
    <message>
        <source>Transitions</source>
        <translation>Übergänge</translation>
    </message>
    <message>
        <source>%1: the name must end in .csv, .json, .graphml, .png or .svg.</source>
        <translation>%1: Der Name muss auf .csv, .json, .graphml, .png oder .svg enden.</translation>
    </message>
    <message>
        <source>%1: it cannot be written there.</source>
        <translation>%1: Dorthin kann nicht geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphPanel</name>
    <message>
        <source>What a fighter does next, given what both are doing, and the moments of the recording behind each probability appear here.</source>
        <translation>Hier erscheint, was ein Kämpfer als Nächstes tut, je nachdem, was beide tun, und die Momente der Aufnahme hinter jeder Wahrscheinlichkeit.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphSession</name>
    <message>
        <source>%1: more often</source>
        <translation>%1: öfter</translation>
    </message>
    <message>
        <source>others</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>P &lt;0.001</source>
        <translation>P &lt;0,001</translation>
    </message>
    <message>
        <source>P %1</source>
        <translation>P %1</translation>
    </message>
    <message>
        <source>surprise %1 (%2 seen the motion): label %3 (%4), geometry %5</source>
        <translation>Überraschung %1 (%2 bei gesehener Bewegung): Label %3 (%4), Geometrie %5</translation>
    </message>
    <message>
        <source>Learning transitions</source>
        <translation>Übergänge werden gelernt</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>all labels</source>
        <translation>alle Labels</translation>
    </message>
    <message>
        <source>labels by hand</source>
        <translation>Labels von Hand</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphView</name>
    <message>
        <source>Graph of transitions</source>
        <translation>Graph der Übergänge</translation>
    </message>
    <message>
        <source>A node is a label, an edge leads to what follows. A click shows the moments behind it.</source>
        <translation>Ein Knoten ist ein Label, eine Kante führt zu dem, was folgt. Ein Klick zeigt die Momente dahinter.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Help</name>
    <message>
        <source>&amp;Help on this workspace</source>
        <translation>&amp;Hilfe zu diesem Arbeitsbereich</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>&amp;Erste Schritte</translation>
    </message>
    <message>
        <source>What the &amp;numbers mean</source>
        <translation>Was die &amp;Zahlen bedeuten</translation>
    </message>
    <message>
        <source>&amp;What is this? Click on it</source>
        <translation>&amp;Was ist das? Darauf klicken</translation>
    </message>
    <message>
        <source>What has the f&amp;ocus?</source>
        <translation>Was hat den &amp;Fokus?</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>What is n&amp;ew</source>
        <translation>Was ist &amp;neu</translation>
    </message>
    <message>
        <source>&amp;About Kumite</source>
        <translation>Ü&amp;ber Kumite</translation>
    </message>
    <message>
        <source>About Kumite</source>
        <translation>Über Kumite</translation>
    </message>
    <message>
        <source>Kumite %1

A studio for annotating two-player martial-arts motion capture.</source>
        <translation>Kumite %1

Ein Studio zum Annotieren von Kampfsport-Motion-Capture mit zwei Personen.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HelpWindow</name>
    <message>
        <source>The page before</source>
        <translation>Die vorige Seite</translation>
    </message>
    <message>
        <source>On again</source>
        <translation>Wieder vor</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Close the help (Esc)</source>
        <translation>Hilfe schließen (Esc)</translation>
    </message>
    <message>
        <source>Search all pages</source>
        <translation>Alle Seiten durchsuchen</translation>
    </message>
    <message>
        <source>Shows the pages that hold all of these words. Return: the next place; Shift+Return: the one before. (Ctrl+F)</source>
        <translation>Zeigt die Seiten, die alle diese Wörter enthalten. Eingabe: die nächste Stelle; Umschalt+Eingabe: die vorige. (Strg+F)</translation>
    </message>
    <message>
        <source>How often the words were found</source>
        <translation>Wie oft die Wörter gefunden wurden</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>The pages of the help</source>
        <translation>Die Seiten der Hilfe</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>Die Seite</translation>
    </message>
    <message>
        <source>Tab leads from link to link, Return follows one.</source>
        <translation>Tab führt von Link zu Link, Eingabe folgt einem.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Found %1 times on this page</source>
        <translation>Auf dieser Seite %1 Mal gefunden</translation>
    </message>
    <message>
        <source>Show this page</source>
        <translation>Diese Seite zeigen</translation>
    </message>
    <message>
        <source>No page holds these words.</source>
        <translation>Keine Seite enthält diese Wörter.</translation>
    </message>
    <message>
        <source>%1 of %2 on this page</source>
        <translation>%1 von %2 auf dieser Seite</translation>
    </message>
    <message>
        <source>%1 — Help</source>
        <translation>%1 — Hilfe</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HistoryModel</name>
    <message>
        <source>%1
The project as it is now.</source>
        <translation>%1
Das Projekt, wie es jetzt ist.</translation>
    </message>
    <message>
        <source>%1
Click to go back to this state.</source>
        <translation>%1
Klicken, um zu diesem Zustand zurückzugehen.</translation>
    </message>
    <message>
        <source>%1
Undone. Click to redo up to here.</source>
        <translation>%1
Rückgängig gemacht. Klicken, um bis hierher zu wiederholen.</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, rückgängig</translation>
    </message>
    <message>
        <source>%1, now</source>
        <translation>%1, jetzt</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HitBox</name>
    <message>
        <source>Hit a target</source>
        <translation>Ein Ziel treffen</translation>
    </message>
    <message>
        <source>Drag the target in the 3D view: the strike follows it. Dots: where whole examples hit; the box: what is reached.</source>
        <translation>Das Ziel in der 3D-Ansicht ziehen: Die Technik folgt ihm. Punkte: wo ganze Beispiele treffen; Kasten: was erreicht wird.</translation>
    </message>
    <message>
        <source>Strike</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Which strike; its examples are the actions with that label</source>
        <translation>Welche Technik; ihre Beispiele sind die Aktionen mit diesem Label</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>ein Ort</translation>
    </message>
    <message>
        <source>Aim at</source>
        <translation>Zielen auf</translation>
    </message>
    <message>
        <source>A place in space, or the opponent as the recording&apos;s playhead shows it; a click on its marks in the 3D view aims there</source>
        <translation>Ein Ort im Raum oder der Gegner, wie ihn der Abspielkopf der Aufnahme zeigt; ein Klick auf seine Marken in der 3D-Ansicht zielt dorthin</translation>
    </message>
    <message>
        <source>Distance of the opponent, metres</source>
        <translation>Entfernung des Gegners, Meter</translation>
    </message>
    <message>
        <source>How far ahead the opponent stands, from pelvis to pelvis</source>
        <translation>Wie weit vorn der Gegner steht, von Becken zu Becken</translation>
    </message>
    <message>
        <source>Away, m</source>
        <translation>Abstand, m</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>nach vorn</translation>
    </message>
    <message>
        <source>Target, metres %1</source>
        <translation>Ziel, Meter %1</translation>
    </message>
    <message>
        <source>Target, m</source>
        <translation>Ziel, m</translation>
    </message>
    <message>
        <source>How well it is hit</source>
        <translation>Wie gut es getroffen wird</translation>
    </message>
    <message>
        <source>The strikes are being aligned.</source>
        <translation>Die Techniken werden ausgerichtet.</translation>
    </message>
    <message>
        <source>A blend of whole examples reaches it.</source>
        <translation>Eine Mischung ganzer Beispiele erreicht es.</translation>
    </message>
    <message>
        <source>No blend of whole examples reaches it: parts of the body are blended and turned.</source>
        <translation>Keine Mischung ganzer Beispiele erreicht es: Körperteile werden gemischt und gedreht.</translation>
    </message>
    <message>
        <source>It is outside of the box that is reached.</source>
        <translation>Es liegt außerhalb des erreichbaren Quaders.</translation>
    </message>
    <message>
        <source>Hit, %1 cm off. %2 %3 examples.</source>
        <translation>Getroffen, %1 cm daneben. %2 %3 Beispiele.</translation>
    </message>
    <message>
        <source>Missed by %1 cm: the nearest that can be reached. %2 %3 examples.</source>
        <translation>Um %1 cm verfehlt: näher geht es nicht. %2 %3 Beispiele.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HitSession</name>
    <message>
        <source>Aim at the opponent</source>
        <translation>Auf den Gegner zielen</translation>
    </message>
    <message>
        <source>Aim at a place</source>
        <translation>Auf einen Ort zielen</translation>
    </message>
    <message>
        <source>Opponent %1 m away</source>
        <translation>Gegner in %1 m Abstand</translation>
    </message>
    <message>
        <source>Strike with %1</source>
        <translation>Technik mit %1</translation>
    </message>
    <message>
        <source>Aligning the strikes</source>
        <translation>Techniken werden ausgerichtet</translation>
    </message>
    <message>
        <source>Move the target</source>
        <translation>Ziel bewegen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ImportDialog</name>
    <message>
        <source>Open recordings</source>
        <translation>Aufnahmen öffnen</translation>
    </message>
    <message>
        <source>Not read. Choose the file again to read it.</source>
        <translation>Nicht gelesen. Wählen Sie die Datei noch einmal, um sie zu lesen.</translation>
    </message>
    <message>
        <source>Choose a recording</source>
        <translation>Wählen Sie eine Aufnahme</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Wird gelesen</translation>
    </message>
    <message>
        <source>Start, place and floor of %1 must be numbers, such as 0.25.</source>
        <translation>Start, Ort und Boden von %1 müssen Zahlen sein, etwa 0.25.</translation>
    </message>
    <message>
        <source>Choose a recording for fighter 1.</source>
        <translation>Wählen Sie eine Aufnahme für Kämpfer 1.</translation>
    </message>
    <message>
        <source>The rate must be a positive number of frames per second, such as 60.</source>
        <translation>Die Rate muss eine positive Zahl von Frames pro Sekunde sein, etwa 60.</translation>
    </message>
    <message>
        <source>Frames read begin:end, such as 120:900; either may be left out.</source>
        <translation>Gelesene Frames als Anfang:Ende, etwa 120:900; beides darf fehlen.</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>Wird untersucht</translation>
    </message>
    <message>
        <source>Roles, %1 missing</source>
        <translation>Rollen, %1 fehlen</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Check:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;Prüfen:&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>%1 (found)</source>
        <translation>%1 (gefunden)</translation>
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
        <translation>wie gefunden</translation>
    </message>
    <message>
        <source>%1:%2 of %3</source>
        <translation>%1:%2 von %3</translation>
    </message>
    <message>
        <source>Hz; header: %1</source>
        <translation>Hz; Kopfdaten: %1</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>begin:end</source>
        <translation>Anfang:Ende</translation>
    </message>
    <message>
        <source>Fighter %1</source>
        <translation>Kämpfer %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Path of the recording; the button beside it, or a drop, chooses one</source>
        <translation>Pfad der Aufnahme; der Knopf daneben oder Hineinziehen wählt eine</translation>
    </message>
    <message>
        <source>a .bvh or .amc file</source>
        <translation>eine .bvh- oder .amc-Datei</translation>
    </message>
    <message>
        <source>none: a single fighter</source>
        <translation>keine: ein einzelner Kämpfer</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>Skelett</translation>
    </message>
    <message>
        <source>Which skeleton of a file that holds several</source>
        <translation>Welches Skelett einer Datei mit mehreren</translation>
    </message>
    <message>
        <source>ASF skeleton</source>
        <translation>ASF-Skelett</translation>
    </message>
    <message>
        <source>the one beside it</source>
        <translation>das daneben liegende</translation>
    </message>
    <message>
        <source>The .asf file that belongs to the .amc</source>
        <translation>Die .asf-Datei, die zur .amc-Datei gehört</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>What one unit of the file is</source>
        <translation>Was eine Einheit der Datei ist</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Hochachse</translation>
    </message>
    <message>
        <source>The file&apos;s axis that points up</source>
        <translation>Die Achse der Datei, die nach oben zeigt</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Seconds on the take&apos;s clock at which its first frame stands</source>
        <translation>Sekunden auf der Uhr des Takes, bei denen sein erstes Frame steht</translation>
    </message>
    <message>
        <source>Place x</source>
        <translation>Ort x</translation>
    </message>
    <message>
        <source>Metres along x from where the file stands</source>
        <translation>Meter entlang x von dort, wo die Datei steht</translation>
    </message>
    <message>
        <source>Place z</source>
        <translation>Ort z</translation>
    </message>
    <message>
        <source>Metres along z from where the file stands</source>
        <translation>Meter entlang z von dort, wo die Datei steht</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Degrees about the vertical, about the file&apos;s origin</source>
        <translation>Grad um die Senkrechte, um den Ursprung der Datei</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Height of the floor in the file, metres</source>
        <translation>Höhe des Bodens in der Datei, Meter</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the recording of %1</source>
        <translation>Aufnahme von %1 wählen</translation>
    </message>
    <message>
        <source>BVH, or AMC with its ASF; others go through Blender</source>
        <translation>BVH, oder AMC mit seinem ASF; anderes über Blender</translation>
    </message>
    <message>
        <source>Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)</source>
        <translation>Aufnahmen (*.bvh *.BVH *.amc *.AMC);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>S&amp;wap</source>
        <translation>Ta&amp;uschen</translation>
    </message>
    <message>
        <source>Swap fighters</source>
        <translation>Kämpfer tauschen</translation>
    </message>
    <message>
        <source>Fighter 1 becomes fighter 2, with all that is said of them (Alt+W)</source>
        <translation>Kämpfer 1 wird Kämpfer 2, mit allen Angaben dazu (Alt+U)</translation>
    </message>
    <message>
        <source>Take name</source>
        <translation>Name des Takes</translation>
    </message>
    <message>
        <source>How the take is called in the project</source>
        <translation>Wie der Take im Projekt heißt</translation>
    </message>
    <message>
        <source>Rate in Hz</source>
        <translation>Rate in Hz</translation>
    </message>
    <message>
        <source>as the header</source>
        <translation>wie Kopfdaten</translation>
    </message>
    <message>
        <source>True frame rate, where the header is wrong: the preview shows it</source>
        <translation>Wahre Framerate, falls die Kopfdaten falsch sind: Die Vorschau zeigt es</translation>
    </message>
    <message>
        <source>Frames, begin:end</source>
        <translation>Frames, Anfang:Ende</translation>
    </message>
    <message>
        <source>Frames of the files; the end is the first frame left out. Empty: all, without a leading T-pose.</source>
        <translation>Frames der Dateien; das Ende ist das erste weggelassene Frame. Leer: alle, ohne T-Pose am Anfang.</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Take</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>ASF file</source>
        <translation>ASF-Datei</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Starts at, s</source>
        <translation>Beginnt bei, s</translation>
    </message>
    <message>
        <source>Place x, m</source>
        <translation>Ort x, m</translation>
    </message>
    <message>
        <source>Place z, m</source>
        <translation>Ort z, m</translation>
    </message>
    <message>
        <source>Turned, °</source>
        <translation>Gedreht, °</translation>
    </message>
    <message>
        <source>Floor, m</source>
        <translation>Boden, m</translation>
    </message>
    <message>
        <source>Add as a take to %1</source>
        <translation>Als Take zu %1 hinzufügen</translation>
    </message>
    <message>
        <source>Otherwise it becomes a project of its own</source>
        <translation>Sonst wird daraus ein eigenes Projekt</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>Abs&amp;pielen</translation>
    </message>
    <message>
        <source>Play or pause (Space in the preview, Alt+P)</source>
        <translation>Abspielen oder anhalten (Leertaste in der Vorschau, Alt+P)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>What was found in the recordings</source>
        <translation>Was in den Aufnahmen gefunden wurde</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open nothing (Esc)</source>
        <translation>Nichts öffnen (Esc)</translation>
    </message>
    <message>
        <source>Open bout</source>
        <translation>Kampf öffnen</translation>
    </message>
    <message>
        <source>Make a take of these recordings (Enter)</source>
        <translation>Aus diesen Aufnahmen einen Take machen (Eingabe)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ImportPreview</name>
    <message>
        <source>Preview of both fighters</source>
        <translation>Vorschau beider Kämpfer</translation>
    </message>
    <message>
        <source>From above, from the side, and their distance over time</source>
        <translation>Von oben, von der Seite und ihr Abstand über die Zeit</translation>
    </message>
    <message>
        <source>Space plays, ← → steps, a drag on the distance scrubs</source>
        <translation>Leertaste spielt ab, ← → gehen schrittweise, Ziehen auf dem Abstand spult</translation>
    </message>
    <message>
        <source>from above, grid %1 m</source>
        <translation>von oben, Raster %1 m</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>von der Seite</translation>
    </message>
    <message>
        <source>%1   distance %2 m</source>
        <translation>%1   Abstand %2 m</translation>
    </message>
    <message>
        <source>distance of the pelvises, m</source>
        <translation>Abstand der Becken, m</translation>
    </message>
    <message>
        <source>Both fighters move here once their recordings are read. Choose them above, or drop them here.</source>
        <translation>Beide Kämpfer bewegen sich hier, sobald ihre Aufnahmen gelesen sind. Wählen Sie sie oben, oder ziehen Sie sie hierher.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JobBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JobRunner</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JointBox</name>
    <message>
        <source>Joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>Joint to turn</source>
        <translation>Gelenk, das gedreht wird</translation>
    </message>
    <message>
        <source>Which joint has rings in the 3D view; J chooses the next one</source>
        <translation>Welches Gelenk in der 3D-Ansicht Ringe hat; J wählt das nächste</translation>
    </message>
    <message>
        <source>Turn about %1, degrees</source>
        <translation>Drehen um %1, Grad</translation>
    </message>
    <message>
        <source>About the parent&apos;s %1, degrees; turned about y first, then x, then z</source>
        <translation>Um %1 des Elterngelenks, Grad; gedreht wird erst um y, dann x, dann z</translation>
    </message>
    <message>
        <source>x y z, °</source>
        <translation>x, y, z, °</translation>
    </message>
    <message>
        <source>How much of the joint&apos;s limits that takes</source>
        <translation>Wie viel das von den Grenzen des Gelenks nimmt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Bent by %1° of %2°, twisted by %3° of %4° from rest.</source>
        <translation>Um %1° von %2° gebeugt, um %3° von %4° aus der Ruhe verdreht.</translation>
    </message>
    <message>
        <source>This joint has no limits.</source>
        <translation>Dieses Gelenk hat keine Grenzen.</translation>
    </message>
    <message>
        <source>A chosen joint has rings in the 3D view: drag one to turn it.</source>
        <translation>Ein gewähltes Gelenk hat in der 3D-Ansicht Ringe: Daran ziehen dreht es.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyBar</name>
    <message>
        <source>Time of the keys</source>
        <translation>Zeit der Schlüsselposen</translation>
    </message>
    <message>
        <source>the strike</source>
        <translation>die Technik</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Frame %1</translation>
    </message>
    <message>
        <source> · the motion</source>
        <translation> · die Bewegung</translation>
    </message>
    <message>
        <source> · the keys</source>
        <translation> · die Schlüsselposen</translation>
    </message>
    <message>
        <source> · beside it without adjustment</source>
        <translation> · daneben ohne Anpassung</translation>
    </message>
    <message>
        <source> · out of reach by %1 cm</source>
        <translation> · um %1 cm außer Reichweite</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyCommands</name>
    <message>
        <source>Ke&amp;yframe</source>
        <translation>P&amp;osen</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ein Frame zurück</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Ein Frame vor</translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation>Zehn Frames zurück</translation>
    </message>
    <message>
        <source>Ten frames on</source>
        <translation>Zehn Frames vor</translation>
    </message>
    <message>
        <source>To the first key</source>
        <translation>Zur ersten Schlüsselpose</translation>
    </message>
    <message>
        <source>To the last key</source>
        <translation>Zur letzten Schlüsselpose</translation>
    </message>
    <message>
        <source>Show the &amp;motion instead of the keys</source>
        <translation>&amp;Bewegung statt Schlüsselposen zeigen</translation>
    </message>
    <message>
        <source>Beside it the motion without a&amp;djustment</source>
        <translation>Daneben die Bewegung ohne An&amp;passung</translation>
    </message>
    <message>
        <source>Keys before and after as &amp;ghosts</source>
        <translation>Posen davor und danach als &amp;Geister</translation>
    </message>
    <message>
        <source>&amp;Hit a target</source>
        <translation>Ein &amp;Ziel treffen</translation>
    </message>
    <message>
        <source>&amp;Add a key here</source>
        <translation>Hier &amp;Schlüsselpose setzen</translation>
    </message>
    <message>
        <source>&amp;Remove the key</source>
        <translation>Schlüsselpose &amp;entfernen</translation>
    </message>
    <message>
        <source>Key before</source>
        <translation>Vorige Schlüsselpose</translation>
    </message>
    <message>
        <source>Key after</source>
        <translation>Nächste Schlüsselpose</translation>
    </message>
    <message>
        <source>Move the key earlier</source>
        <translation>Schlüsselpose früher</translation>
    </message>
    <message>
        <source>Move the key later</source>
        <translation>Schlüsselpose später</translation>
    </message>
    <message>
        <source>Move the key and later ones earlier</source>
        <translation>Diese und spätere Posen früher</translation>
    </message>
    <message>
        <source>Move the key and later ones later</source>
        <translation>Diese und spätere Posen später</translation>
    </message>
    <message>
        <source>Later keys closer together</source>
        <translation>Spätere Posen enger zusammen</translation>
    </message>
    <message>
        <source>Later keys farther apart</source>
        <translation>Spätere Posen weiter auseinander</translation>
    </message>
    <message>
        <source>&amp;Copy the key to the playhead, or behind the last</source>
        <translation>Schlüsselpose zum Abspielkopf &amp;kopieren, oder hinter die letzte</translation>
    </message>
    <message>
        <source>M&amp;irror the pose</source>
        <translation>Pose sp&amp;iegeln</translation>
    </message>
    <message>
        <source>&amp;Take the pose that the recording shows</source>
        <translation>Pose der Aufnahme über&amp;nehmen</translation>
    </message>
    <message>
        <source>Copy the pose from an&amp;y take or clip…</source>
        <translation>Pose aus einem Take oder &amp;Clip kopieren…</translation>
    </message>
    <message>
        <source>The handle &amp;stays where it is, or not</source>
        <translation>Griff bleibt, &amp;wo er ist, oder nicht</translation>
    </message>
    <message>
        <source>Next handle</source>
        <translation>Nächster Griff</translation>
    </message>
    <message>
        <source>Next &amp;joint to turn</source>
        <translation>Näc&amp;hstes Gelenk zum Drehen</translation>
    </message>
    <message>
        <source>Joint before</source>
        <translation>Gelenk davor</translation>
    </message>
    <message>
        <source>Handle up</source>
        <translation>Griff nach oben</translation>
    </message>
    <message>
        <source>Handle down</source>
        <translation>Griff nach unten</translation>
    </message>
    <message>
        <source>Handle toward −x</source>
        <translation>Griff in Richtung −x</translation>
    </message>
    <message>
        <source>Handle toward +x</source>
        <translation>Griff in Richtung +x</translation>
    </message>
    <message>
        <source>Handle toward −z</source>
        <translation>Griff in Richtung −z</translation>
    </message>
    <message>
        <source>Handle toward +z</source>
        <translation>Griff in Richtung +z</translation>
    </message>
    <message>
        <source>The body from anywhere again</source>
        <translation>Körper wieder von überall</translation>
    </message>
    <message>
        <source>Take the body from anywhere</source>
        <translation>Körper von überall nehmen</translation>
    </message>
    <message>
        <source>Remove all keys</source>
        <translation>Alle Schlüsselposen entfernen</translation>
    </message>
    <message>
        <source>Add clips of &amp;files…</source>
        <translation>Clips aus &amp;Dateien hinzufügen…</translation>
    </message>
    <message>
        <source>Add cl&amp;ips of a folder…</source>
        <translation>Clips eines &amp;Ordners hinzufügen…</translation>
    </message>
    <message>
        <source>R&amp;eplace a part of a take…</source>
        <translation>Teil eines Takes e&amp;rsetzen…</translation>
    </message>
    <message>
        <source>&amp;Keep as a take…</source>
        <translation>Als &amp;Take behalten…</translation>
    </message>
    <message>
        <source>E&amp;xport the motion…</source>
        <translation>Bewegung e&amp;xportieren…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyEditor</name>
    <message>
        <source>Remove keys</source>
        <translation>Tasten entfernen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>Alle Tasten zurücksetzen</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Befehle suchen</translation>
    </message>
    <message>
        <source>Shows the commands whose name, menu or key holds these letters.</source>
        <translation>Zeigt die Befehle, deren Name, Menü oder Taste diese Zeichen enthält.</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Choose a command, then press its key in the field below</source>
        <translation>Einen Befehl wählen, dann im Feld darunter seine Taste drücken</translation>
    </message>
    <message>
        <source>command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>The chosen command gets the key in the field.</source>
        <translation>Der gewählte Befehl bekommt die Taste aus dem Feld.</translation>
    </message>
    <message>
        <source>The chosen command is run from menus and the palette only.</source>
        <translation>Der gewählte Befehl ist nur noch über Menüs und die Palette erreichbar.</translation>
    </message>
    <message>
        <source>The chosen command gets back the keys that the studio brings.</source>
        <translation>Der gewählte Befehl bekommt die mitgelieferten Tasten zurück.</translation>
    </message>
    <message>
        <source>All commands get back the keys that the studio brings.</source>
        <translation>Alle Befehle bekommen die mitgelieferten Tasten zurück.</translation>
    </message>
    <message>
        <source>Your own; the studio brings: %1</source>
        <translation>Ihre eigene; mitgeliefert: %1</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Zuweisen</translation>
    </message>
    <message>
        <source>Choose a command to give it another key.</source>
        <translation>Wählen Sie einen Befehl, um ihm eine andere Taste zu geben.</translation>
    </message>
    <message>
        <source>Press the new key for “%1” in the field.</source>
        <translation>Drücken Sie die neue Taste für „%1“ im Feld.</translation>
    </message>
    <message>
        <source>%1 is its key already.</source>
        <translation>%1 ist schon seine Taste.</translation>
    </message>
    <message>
        <source>%1 is free.</source>
        <translation>%1 ist frei.</translation>
    </message>
    <message>
        <source>Take it over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>%1 is the key of %2. Taking it over leaves that command without it.</source>
        <translation>%1 ist die Taste von „%2“. Wird sie übernommen, hat dieser Befehl keine mehr.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyField</name>
    <message>
        <source>Press a key</source>
        <translation>Taste drücken</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Neue Taste</translation>
    </message>
    <message>
        <source>Press the key here, alone or with Ctrl, Shift, Alt; then Tab goes on, and Shift+Tab always goes back</source>
        <translation>Hier die Taste drücken, allein oder mit Strg, Umschalt, Alt; danach geht Tab weiter, Umschalt+Tab immer zurück</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyPanel</name>
    <message>
        <source>What appears here</source>
        <translation>Was hier erscheint</translation>
    </message>
    <message>
        <source>Key pose</source>
        <translation>Schlüsselpose</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Hit a target</source>
        <translation>Ein Ziel treffen</translation>
    </message>
    <message>
        <source>A strike of the takes and clips that follows a target, instead of keys</source>
        <translation>Eine Technik der Takes und Clips, die einem Ziel folgt, statt Schlüsselposen</translation>
    </message>
    <message>
        <source>Back to the keys</source>
        <translation>Zurück zu den Schlüsselposen</translation>
    </message>
    <message>
        <source>Sho&amp;w the key pose</source>
        <translation>Sch&amp;lüsselpose zeigen</translation>
    </message>
    <message>
        <source>Show the motio&amp;n</source>
        <translation>Beweg&amp;ung zeigen</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>Clips…</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>Behalten…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>A few key poses become a motion that is put together from the takes and clips: it appears here.</source>
        <translation>Aus wenigen Schlüsselposen wird eine Bewegung, zusammengesetzt aus den Takes und Clips: Sie erscheint hier.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeySession</name>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2 bis %3</translation>
    </message>
    <message>
        <source>Preparing the clips</source>
        <translation>Clips werden vorbereitet</translation>
    </message>
    <message>
        <source>Making the motion</source>
        <translation>Bewegung wird erzeugt</translation>
    </message>
    <message>
        <source>Add a key at frame %1</source>
        <translation>Schlüsselpose bei Frame %1 setzen</translation>
    </message>
    <message>
        <source>Take the pose of the recording</source>
        <translation>Pose der Aufnahme übernehmen</translation>
    </message>
    <message>
        <source>Remove the key at frame %1</source>
        <translation>Schlüsselpose bei Frame %1 entfernen</translation>
    </message>
    <message>
        <source>A key stands at frame %1 already.</source>
        <translation>Bei Frame %1 steht schon eine Schlüsselpose.</translation>
    </message>
    <message>
        <source>Move the key to frame %1</source>
        <translation>Schlüsselpose zu Frame %1 verschieben</translation>
    </message>
    <message>
        <source>Move the key and later ones to frame %1</source>
        <translation>Diese und spätere Posen auf Frame %1 verschieben</translation>
    </message>
    <message>
        <source>Later keys %1 times as far</source>
        <translation>Spätere Posen %1-mal so weit</translation>
    </message>
    <message>
        <source>Copy the key to frame %1</source>
        <translation>Schlüsselpose zu Frame %1 kopieren</translation>
    </message>
    <message>
        <source>Mirror the key</source>
        <translation>Schlüsselpose spiegeln</translation>
    </message>
    <message>
        <source>Change the way to the next key</source>
        <translation>Weg zur nächsten Schlüsselpose ändern</translation>
    </message>
    <message>
        <source>Remove all keys</source>
        <translation>Alle Schlüsselposen entfernen</translation>
    </message>
    <message>
        <source>Drag the %1</source>
        <translation>Griff ziehen: %1</translation>
    </message>
    <message>
        <source>Turn the %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Move the %1 a little</source>
        <translation>Griff etwas bewegen: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyStrip</name>
    <message>
        <source>Key poses over time</source>
        <translation>Schlüsselposen über die Zeit</translation>
    </message>
    <message>
        <source>The strike over time</source>
        <translation>Die Technik über die Zeit</translation>
    </message>
    <message>
        <source>The strikes are being aligned.</source>
        <translation>Die Techniken werden ausgerichtet.</translation>
    </message>
    <message>
        <source>No strike to bring to a target.</source>
        <translation>Keine Technik, die sich zum Ziel bringen lässt.</translation>
    </message>
    <message>
        <source>hit, %1</source>
        <translation>Treffer, %1</translation>
    </message>
    <message>
        <source>No key poses yet. Return makes the first one, of the pose that the take shows now.</source>
        <translation>Noch keine Schlüsselposen. Eingabe setzt die erste, mit der Pose, die der Take jetzt zeigt.</translation>
    </message>
    <message>
        <source>key at frame %1 · drag to move it</source>
        <translation>Schlüsselpose bei Frame %1 · ziehen verschiebt sie</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeysPage</name>
    <message>
        <source>Mouse on the timeline</source>
        <translation>Maus auf der Zeitleiste</translation>
    </message>
    <message>
        <source>click, double-click</source>
        <translation>Klick, Doppelklick</translation>
    </message>
    <message>
        <source>select a boundary; remove or restore it</source>
        <translation>Grenze auswählen; sie entfernen oder wiederherstellen</translation>
    </message>
    <message>
        <source>× over a boundary</source>
        <translation>× über einer Grenze</translation>
    </message>
    <message>
        <source>remove it at once</source>
        <translation>sie sofort entfernen</translation>
    </message>
    <message>
        <source>drag a boundary</source>
        <translation>Grenze ziehen</translation>
    </message>
    <message>
        <source>move it; Ctrl or Alt: without snapping; Esc: leave it</source>
        <translation>verschieben; Strg oder Alt: ohne Einrasten; Esc: lassen</translation>
    </message>
    <message>
        <source>drag elsewhere</source>
        <translation>anderswo ziehen</translation>
    </message>
    <message>
        <source>scrub</source>
        <translation>spulen</translation>
    </message>
    <message>
        <source>drag a loop end on the ruler</source>
        <translation>ein Ende der Schleife auf dem Lineal ziehen</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>click, double-click an action</source>
        <translation>Klick, Doppelklick auf Aktion</translation>
    </message>
    <message>
        <source>select it; show and loop it</source>
        <translation>auswählen; zeigen und wiederholen</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>what can be done there</source>
        <translation>was dort möglich ist</translation>
    </message>
    <message>
        <source>wheel, Shift+wheel, middle drag</source>
        <translation>Rad, Umschalt+Rad, Ziehen mit Mitteltaste</translation>
    </message>
    <message>
        <source>scroll</source>
        <translation>rollen</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Strg+Rad</translation>
    </message>
    <message>
        <source>zoom about the pointer</source>
        <translation>um den Zeiger zoomen</translation>
    </message>
    <message>
        <source>Mouse in the 3D view</source>
        <translation>Maus in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>ziehen</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>middle or Shift+drag</source>
        <translation>Mitteltaste oder Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>move</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>click a fighter</source>
        <translation>Klick auf einen Kämpfer</translation>
    </message>
    <message>
        <source>make it the active one</source>
        <translation>ihn aktivieren</translation>
    </message>
    <message>
        <source>measuring: click joints</source>
        <translation>beim Messen: Gelenke anklicken</translation>
    </message>
    <message>
        <source>distance; over a joint: its speed</source>
        <translation>Abstand; über einem Gelenk: seine Geschwindigkeit</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Search keys and commands</source>
        <translation>Tasten und Befehle suchen</translation>
    </message>
    <message>
        <source>Shows the lines that hold these letters</source>
        <translation>Zeigt die Zeilen, die diese Zeichen enthalten</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Drucken…</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Als PDF speichern…</translation>
    </message>
    <message>
        <source>Change keys…</source>
        <translation>Tasten ändern…</translation>
    </message>
    <message>
        <source>The keys of all workspaces, on paper. (Ctrl+P)</source>
        <translation>Die Tasten aller Arbeitsbereiche, auf Papier. (Strg+P)</translation>
    </message>
    <message>
        <source>The keys of all workspaces, as a file.</source>
        <translation>Die Tasten aller Arbeitsbereiche, als Datei.</translation>
    </message>
    <message>
        <source>Gives commands other keys, in the preferences.</source>
        <translation>Gibt Befehlen andere Tasten, in den Einstellungen.</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Diese Seite schließen (Esc)</translation>
    </message>
    <message>
        <source>No key and no command holds these letters.</source>
        <translation>Keine Taste und kein Befehl enthält diese Zeichen.</translation>
    </message>
    <message>
        <source>Nobody is here to choose a printer.</source>
        <translation>Niemand ist da, um einen Drucker zu wählen.</translation>
    </message>
    <message>
        <source>Print the sheet of keys</source>
        <translation>Tastenblatt drucken</translation>
    </message>
    <message>
        <source>%1 does not take the sheet.</source>
        <translation>%1 nimmt das Blatt nicht an.</translation>
    </message>
    <message>
        <source>Save the sheet of keys</source>
        <translation>Tastenblatt speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written there.</source>
        <translation>%1 kann dort nicht geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelExchange</name>
    <message>
        <source>Labels (*.csv *.json *.eaf);;All files (*)</source>
        <translation>Labels (*.csv *.json *.eaf);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>Labels übernehmen</translation>
    </message>
    <message>
        <source>Compare with another person&apos;s labels</source>
        <translation>Mit Labels einer anderen Person vergleichen</translation>
    </message>
    <message>
        <source>Use another vocabulary</source>
        <translation>Anderes Vokabular verwenden</translation>
    </message>
    <message>
        <source>Vocabularies (*.json)</source>
        <translation>Vokabulare (*.json)</translation>
    </message>
    <message>
        <source>Write labels</source>
        <translation>Labels schreiben</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json);;ELAN, the shown take (*.eaf)</source>
        <translation>Tabelle (*.csv);;JSON (*.json);;ELAN, der gezeigte Take (*.eaf)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>%1: %2 of %3 labels found their action.</source>
        <translation>%1: %2 von %3 Labels haben ihre Aktion gefunden.</translation>
    </message>
    <message>
        <source>Labels written to %1.</source>
        <translation>Labels nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>The vocabulary that the studio brings</source>
        <translation>Das mitgelieferte Vokabular</translation>
    </message>
    <message>
        <source>It has no word for these labels, which would be dropped (undo brings them back):</source>
        <translation>Es hat kein Wort für diese Labels; sie würden wegfallen (Rückgängig bringt sie zurück):</translation>
    </message>
    <message>
        <source>The vocabulary is %1 now.</source>
        <translation>Das Vokabular ist jetzt %1.</translation>
    </message>
    <message>
        <source>%1: %2, %3 aspects.</source>
        <translation>%1: %2, %3 Aspekte.</translation>
    </message>
    <message>
        <source>Use vocabulary</source>
        <translation>Vokabular verwenden</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelLanes</name>
    <message>
        <source>%1 · action %2</source>
        <translation>%1 · Aktion %2</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>Notiz: %1</translation>
    </message>
    <message>
        <source>the machine would say %1</source>
        <translation>die Maschine würde %1 sagen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelLearning</name>
    <message>
        <source>Comparing actions</source>
        <translation>Aktionen werden verglichen</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Wird gelernt</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Wird kalibriert</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelPalette</name>
    <message>
        <source>Classes and their keys</source>
        <translation>Klassen und ihre Tasten</translation>
    </message>
    <message>
        <source>For two strikes in one action: this, then a class of another lane</source>
        <translation>Für zwei Techniken in einer Aktion: erst dies, dann eine Klasse einer anderen Spur</translation>
    </message>
    <message>
        <source>
Right click: paint with it over actions of the timeline</source>
        <translation>
Rechtsklick: damit über Aktionen der Zeitleiste malen</translation>
    </message>
    <message>
        <source>first, then two classes: both</source>
        <translation>zuerst, dann zwei Klassen: beide</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelPanel</name>
    <message>
        <source>Go on after an answer</source>
        <translation>Nach Antwort weiter</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>Warteschlange</translation>
    </message>
    <message>
        <source>Current action</source>
        <translation>Aktuelle Aktion</translation>
    </message>
    <message>
        <source>Accept what is proposed</source>
        <translation>Den Vorschlag annehmen</translation>
    </message>
    <message>
        <source>Take the second best instead; of what a hand said, nothing any more</source>
        <translation>Stattdessen das Zweitbeste nehmen; bei von Hand Gesagtem: nichts mehr</translation>
    </message>
    <message>
        <source>Why rules say so</source>
        <translation>Warum Regeln das sagen</translation>
    </message>
    <message>
        <source>Most useful first</source>
        <translation>Nützlichste zuerst</translation>
    </message>
    <message>
        <source>Least sure first</source>
        <translation>Unsicherste zuerst</translation>
    </message>
    <message>
        <source>In order of time</source>
        <translation>In zeitlicher Folge</translation>
    </message>
    <message>
        <source>Order of the queue</source>
        <translation>Reihenfolge der Warteschlange</translation>
    </message>
    <message>
        <source>Most useful: where the machine is torn, spread over different-looking actions</source>
        <translation>Nützlichste: wo die Maschine schwankt, verteilt auf verschieden aussehende Aktionen</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Sure from %1 on: %2</source>
        <translation>Sicher ab %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>%n Aktion</numerusform>
            <numerusform>%n Aktionen</numerusform>
        </translation>
    </message>
    <message>
        <source>No action</source>
        <translation>Keine Aktion</translation>
    </message>
    <message>
        <source>Actions appear here once a recording is open and cut.</source>
        <translation>Aktionen erscheinen hier, sobald eine Aufnahme geöffnet und geschnitten ist.</translation>
    </message>
    <message>
        <source>%1 leads to the first question; or click an action.</source>
        <translation>%1 führt zur ersten Frage; oder klicken Sie eine Aktion an.</translation>
    </message>
    <message>
        <source>%1 actions chosen</source>
        <translation>%1 Aktionen ausgewählt</translation>
    </message>
    <message>
        <source>%1 · action %2 · %3</source>
        <translation>%1 · Aktion %2 · %3</translation>
    </message>
    <message>
        <source>%1 · by hand</source>
        <translation>%1 · von Hand</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>the only class so far</source>
        <translation>die bisher einzige Klasse</translation>
    </message>
    <message>
        <source>Nothing is proposed yet</source>
        <translation>Noch kein Vorschlag</translation>
    </message>
    <message>
        <source>Something else: a class key</source>
        <translation>Etwas anderes: eine Klassentaste</translation>
    </message>
    <message>
        <source>Say what it is by a class key</source>
        <translation>Mit einer Klassentaste sagen, was es ist</translation>
    </message>
    <message>
        <source>%1  %2  %3</source>
        <translation>%1  %2  %3</translation>
    </message>
    <message>
        <source>Queue %1</source>
        <translation>Warteschlange %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelReview</name>
    <message>
        <source>There is no action to label.</source>
        <translation>Es gibt keine Aktion zum Labeln.</translation>
    </message>
    <message>
        <source>No question is left. Accept what rules and machine say of the rest.</source>
        <translation>Keine Frage ist übrig. Nehmen Sie an, was Regeln und Maschine zum Rest sagen.</translation>
    </message>
    <message>
        <source>No question was shown before.</source>
        <translation>Davor wurde keine Frage gezeigt.</translation>
    </message>
    <message>
        <source>Said: %1. This is the next question.</source>
        <translation>Gesagt: %1. Hier ist die nächste Frage.</translation>
    </message>
    <message>
        <source>That is what a hand has said already.</source>
        <translation>Das wurde schon von Hand gesagt.</translation>
    </message>
    <message>
        <source>The machine proposes nothing yet: say what it is by a class key.</source>
        <translation>Die Maschine schlägt noch nichts vor: Sagen Sie mit einer Klassentaste, was es ist.</translation>
    </message>
    <message>
        <source>There is no second best: say what it is by a class key.</source>
        <translation>Es gibt kein Zweitbestes: Sagen Sie mit einer Klassentaste, was es ist.</translation>
    </message>
    <message>
        <source>%1 has no class %2.</source>
        <translation>%1 hat keine Klasse %2.</translation>
    </message>
    <message>
        <source>The next class key adds to the label.</source>
        <translation>Die nächste Klassentaste ergänzt das Label.</translation>
    </message>
    <message>
        <source>Accepted as soon as the machine knows how sure it is.</source>
        <translation>Wird angenommen, sobald die Maschine weiß, wie sicher sie ist.</translation>
    </message>
    <message>
        <source>Every action is labelled, all of them by hand.</source>
        <translation>Jede Aktion ist gelabelt, alle von Hand.</translation>
    </message>
    <message>
        <source>Every action is labelled; of these the machine was least sure. Return says that it is right.</source>
        <translation>Jede Aktion ist gelabelt; bei diesen war die Maschine am unsichersten. Die Eingabetaste bestätigt.</translation>
    </message>
    <message>
        <source>Said: %1. Now the class beside it.</source>
        <translation>Gesagt: %1. Nun die Klasse daneben.</translation>
    </message>
    <message numerus="yes">
        <source>Accepted: %n action(s). Ctrl+Z takes all of it back.</source>
        <translation>
            <numerusform>Angenommen: %n Aktion. Strg+Z nimmt alles zurück.</numerusform>
            <numerusform>Angenommen: %n Aktionen. Strg+Z nimmt alles zurück.</numerusform>
        </translation>
    </message>
    <message>
        <source>Accepted what rules say.</source>
        <translation>Angenommen, was die Regeln sagen.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelViews</name>
    <message>
        <source>Palette and questions</source>
        <translation>Palette und Fragen</translation>
    </message>
    <message>
        <source>Find actions by what is said of them</source>
        <translation>Aktionen nach dem finden, was über sie gesagt ist</translation>
    </message>
    <message>
        <source>Actions that look like the current one, side by side</source>
        <translation>Aktionen, die der aktuellen ähneln, nebeneinander</translation>
    </message>
    <message>
        <source>How well the machine knows the bout: confusion matrix and learning curve</source>
        <translation>Wie gut die Maschine den Kampf kennt: Konfusionsmatrix und Lernkurve</translation>
    </message>
    <message>
        <source>Thresholds of the rules for move and react</source>
        <translation>Schwellen der Regeln für Bewegung und Reaktion</translation>
    </message>
    <message>
        <source>Another person&apos;s labels beside these</source>
        <translation>Die Labels einer anderen Person neben diesen</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Find actions</source>
        <translation>Aktionen suchen</translation>
    </message>
    <message>
        <source>Similar actions</source>
        <translation>Ähnliche Aktionen</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>Two people</source>
        <translation>Zwei Personen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelWords</name>
    <message>
        <source>%1 open</source>
        <translation>%1 offen</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>ohne %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>accepted from a rule</source>
        <translation>von einer Regel angenommen</translation>
    </message>
    <message>
        <source>accepted from the machine, %1</source>
        <translation>von der Maschine angenommen, %1</translation>
    </message>
    <message>
        <source>proposed by a rule</source>
        <translation>von einer Regel vorgeschlagen</translation>
    </message>
    <message>
        <source>proposed by a rule, %1</source>
        <translation>von einer Regel vorgeschlagen, %1</translation>
    </message>
    <message>
        <source>proposed: the only one seen so far</source>
        <translation>vorgeschlagen: das bisher einzige</translation>
    </message>
    <message>
        <source>proposed by the machine, %1</source>
        <translation>von der Maschine vorgeschlagen, %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LaneSource</name>
    <message>
        <source>labels</source>
        <translation>Labels</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LearningPlot</name>
    <message>
        <source>Learning curve</source>
        <translation>Lernkurve</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>erwartet %1</translation>
    </message>
    <message>
        <source>as asked %1</source>
        <translation>wie gefragt %1</translation>
    </message>
    <message>
        <source>random %1</source>
        <translation>zufällig %1</translation>
    </message>
    <message>
        <source>%1 labels: %2</source>
        <translation>%1 Labels: %2</translation>
    </message>
    <message>
        <source>labels by hand</source>
        <translation>Labels von Hand</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>erwartet</translation>
    </message>
    <message>
        <source>as asked</source>
        <translation>wie gefragt</translation>
    </message>
    <message>
        <source>random</source>
        <translation>zufällig</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MadeMotion</name>
    <message>
        <source>Keep the motion as a take</source>
        <translation>Bewegung als Take behalten</translation>
    </message>
    <message>
        <source>Recordings (*.bvh)</source>
        <translation>Aufnahmen (*.bvh)</translation>
    </message>
    <message>
        <source>Keeping the motion</source>
        <translation>Bewegung wird behalten</translation>
    </message>
    <message>
        <source>Kept as take %1.</source>
        <translation>Als Take %1 behalten.</translation>
    </message>
    <message>
        <source>Export the motion</source>
        <translation>Bewegung exportieren</translation>
    </message>
    <message>
        <source>Motion (*.bvh);;glTF: skeleton and animation (*.glb)</source>
        <translation>Bewegung (*.bvh);;glTF: Skelett und Animation (*.glb)</translation>
    </message>
    <message>
        <source>Writing the motion</source>
        <translation>Bewegung wird geschrieben</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Add clips</source>
        <translation>Clips hinzufügen</translation>
    </message>
    <message>
        <source>Motion and projects (*.bvh *.amc *.kumite)</source>
        <translation>Bewegung und Projekte (*.bvh *.amc *.kumite)</translation>
    </message>
    <message>
        <source>Add all clips of a folder</source>
        <translation>Alle Clips eines Ordners hinzufügen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MainWindow</name>
    <message>
        <source>&amp;Segment</source>
        <translation>&amp;Schnitt</translation>
    </message>
    <message>
        <source>&amp;Remove or restore boundary</source>
        <translation>Grenze &amp;entfernen oder wiederherstellen</translation>
    </message>
    <message>
        <source>Split here: &amp;add a boundary</source>
        <translation>Hier teilen: &amp;Grenze hinzufügen</translation>
    </message>
    <message>
        <source>Join with the action &amp;before</source>
        <translation>Mit der Aktion &amp;davor verbinden</translation>
    </message>
    <message>
        <source>Join with the action af&amp;ter</source>
        <translation>Mit der Aktion danac&amp;h verbinden</translation>
    </message>
    <message>
        <source>&amp;Previous boundary</source>
        <translation>&amp;Vorige Grenze</translation>
    </message>
    <message>
        <source>&amp;Next boundary</source>
        <translation>&amp;Nächste Grenze</translation>
    </message>
    <message>
        <source>Move boundary one frame &amp;earlier</source>
        <translation>Grenze ein Frame &amp;früher</translation>
    </message>
    <message>
        <source>Move boundary one frame &amp;later</source>
        <translation>Grenze ein Frame &amp;später</translation>
    </message>
    <message>
        <source>Select the action before</source>
        <translation>Aktion davor auswählen</translation>
    </message>
    <message>
        <source>Select the action after</source>
        <translation>Aktion danach auswählen</translation>
    </message>
    <message>
        <source>Sho&amp;w and loop the action</source>
        <translation>Aktion zeigen und &amp;wiederholen</translation>
    </message>
    <message>
        <source>N&amp;ote on the action…</source>
        <translation>N&amp;otiz zur Aktion…</translation>
    </message>
    <message>
        <source>Ne&amp;xt suspect</source>
        <translation>Nä&amp;chster Verdachtsfall</translation>
    </message>
    <message>
        <source>Pre&amp;vious suspect</source>
        <translation>Vor&amp;iger Verdachtsfall</translation>
    </message>
    <message>
        <source>&amp;Keep: it is a boundary</source>
        <translation>&amp;Behalten: Es ist eine Grenze</translation>
    </message>
    <message>
        <source>Re&amp;move: it is spurious</source>
        <translation>En&amp;tfernen: Sie ist unecht</translation>
    </message>
    <message>
        <source>De&amp;cide anew</source>
        <translation>Ne&amp;u entscheiden</translation>
    </message>
    <message>
        <source>Compare with settings B</source>
        <translation>Mit Einstellungen B vergleichen</translation>
    </message>
    <message>
        <source>T&amp;imeline</source>
        <translation>&amp;Zeitleiste</translation>
    </message>
    <message>
        <source>&amp;Height of the centre of mass</source>
        <translation>&amp;Höhe des Schwerpunkts</translation>
    </message>
    <message>
        <source>Force without &amp;smoothing</source>
        <translation>Kraft &amp;ohne Glättung</translation>
    </message>
    <message>
        <source>Speeds of the h&amp;ands</source>
        <translation>Geschwindigkeit der Hän&amp;de</translation>
    </message>
    <message>
        <source>Speeds of the &amp;feet</source>
        <translation>Geschwindigkeit der &amp;Füße</translation>
    </message>
    <message>
        <source>Ruler in &amp;time and frames</source>
        <translation>Lineal in &amp;Zeit und Frames</translation>
    </message>
    <message>
        <source>Ruler in time</source>
        <translation>Lineal in Zeit</translation>
    </message>
    <message>
        <source>Ruler in frames</source>
        <translation>Lineal in Frames</translation>
    </message>
    <message>
        <source>Next &amp;unit of the ruler</source>
        <translation>Nächste &amp;Einheit des Lineals</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>&amp;Labels</translation>
    </message>
    <message>
        <source>&amp;Next question</source>
        <translation>&amp;Nächste Frage</translation>
    </message>
    <message>
        <source>&amp;Previous question</source>
        <translation>&amp;Vorige Frage</translation>
    </message>
    <message>
        <source>&amp;Accept what is proposed</source>
        <translation>Vorschlag &amp;annehmen</translation>
    </message>
    <message>
        <source>&amp;Reject: the second best instead</source>
        <translation>Ab&amp;lehnen: stattdessen das Zweitbeste</translation>
    </message>
    <message>
        <source>&amp;Take back what is said of the action</source>
        <translation>Aussage zur Aktion &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>Accept the &amp;sure rest</source>
        <translation>Den sicheren &amp;Rest annehmen</translation>
    </message>
    <message>
        <source>Less sure is sure eno&amp;ugh</source>
        <translation>&amp;Weniger Sicherheit genügt</translation>
    </message>
    <message>
        <source>On&amp;ly surer is sure enough</source>
        <translation>&amp;Mehr Sicherheit verlangen</translation>
    </message>
    <message>
        <source>Answers &amp;go on to the next question</source>
        <translation>Antworten &amp;führen zur nächsten Frage</translation>
    </message>
    <message>
        <source>Lane abo&amp;ve</source>
        <translation>Spur darü&amp;ber</translation>
    </message>
    <message>
        <source>Lane belo&amp;w</source>
        <translation>Spur &amp;darunter</translation>
    </message>
    <message>
        <source>Nothing of the lane&apos;s aspect</source>
        <translation>Nichts zum Aspekt der Spur</translation>
    </message>
    <message>
        <source>Class %1 of the lane</source>
        <translation>Klasse %1 der Spur</translation>
    </message>
    <message>
        <source>Next class &amp;besides: a composite</source>
        <translation>Nä&amp;chste Klasse dazu: zusammengesetzt</translation>
    </message>
    <message>
        <source>Choose the action before as well</source>
        <translation>Aktion davor mit auswählen</translation>
    </message>
    <message>
        <source>Choose the action after as well</source>
        <translation>Aktion danach mit auswählen</translation>
    </message>
    <message>
        <source>Quick label %1</source>
        <translation>Schnell-Label %1</translation>
    </message>
    <message>
        <source>Label: %1</source>
        <translation>Label: %1</translation>
    </message>
    <message>
        <source>Show pal&amp;ette and questions</source>
        <translation>&amp;Palette und Fragen zeigen</translation>
    </message>
    <message>
        <source>&amp;Find actions</source>
        <translation>Aktionen &amp;suchen</translation>
    </message>
    <message>
        <source>Show si&amp;milar actions</source>
        <translation>Ähnl&amp;iche Aktionen zeigen</translation>
    </message>
    <message>
        <source>Show &amp;quality</source>
        <translation>&amp;Qualität zeigen</translation>
    </message>
    <message>
        <source>Show &amp;rules</source>
        <translation>&amp;Regeln zeigen</translation>
    </message>
    <message>
        <source>Show &amp;two people&apos;s labels</source>
        <translation>Labels &amp;zweier Personen zeigen</translation>
    </message>
    <message>
        <source>Ne&amp;xt action found</source>
        <translation>&amp;Nächste gefundene Aktion</translation>
    </message>
    <message>
        <source>Pre&amp;vious action found</source>
        <translation>&amp;Vorige gefundene Aktion</translation>
    </message>
    <message>
        <source>Choose &amp;all that were found</source>
        <translation>&amp;Alle gefundenen auswählen</translation>
    </message>
    <message>
        <source>&amp;Give similar actions the same label</source>
        <translation>Ähnlichen Aktionen &amp;gleiches Label geben</translation>
    </message>
    <message>
        <source>Take t&amp;heirs</source>
        <translation>An&amp;deres nehmen</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>&amp;Meins behalten</translation>
    </message>
    <message>
        <source>Take theirs for all that are &amp;open</source>
        <translation>Anderes für alle &amp;offenen nehmen</translation>
    </message>
    <message>
        <source>Add what onl&amp;y they labelled</source>
        <translation>Nur dort Gelabeltes &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Next &amp;difference</source>
        <translation>Nächster &amp;Unterschied</translation>
    </message>
    <message>
        <source>Take &amp;over labels…</source>
        <translation>Labels ü&amp;bernehmen…</translation>
    </message>
    <message>
        <source>&amp;Write labels…</source>
        <translation>Labels schr&amp;eiben…</translation>
    </message>
    <message>
        <source>&amp;Compare with labels of…</source>
        <translation>Vergleichen mi&amp;t Labels von…</translation>
    </message>
    <message>
        <source>Use another voca&amp;bulary…</source>
        <translation>Anderes Vo&amp;kabular verwenden…</translation>
    </message>
    <message>
        <source>Use the built-&amp;in vocabulary</source>
        <translation>Eingebautes Vokabular ver&amp;wenden</translation>
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
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open the &amp;demo bout</source>
        <translation>&amp;Demo-Kampf öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recordings…</source>
        <translation>&amp;Aufnahmen öffnen…</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>&amp;Projekt öffnen…</translation>
    </message>
    <message>
        <source>Opened &amp;lately</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Versions…</source>
        <translation>&amp;Versionen…</translation>
    </message>
    <message>
        <source>&amp;Export actions…</source>
        <translation>Aktionen &amp;exportieren…</translation>
    </message>
    <message>
        <source>Export &amp;motion…</source>
        <translation>&amp;Bewegung exportieren…</translation>
    </message>
    <message>
        <source>&amp;Find recording…</source>
        <translation>Aufnahme su&amp;chen…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Bee&amp;nden</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Run a &amp;command by name…</source>
        <translation>&amp;Befehl nach Namen ausführen…</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>&amp;Wiedergabe</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Play &amp;backward, faster</source>
        <translation>&amp;Rückwärts abspielen, schneller</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Stopp</translation>
    </message>
    <message>
        <source>Play &amp;forward, faster</source>
        <translation>&amp;Vorwärts abspielen, schneller</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ein Frame zurück</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Ein Frame vor</translation>
    </message>
    <message>
        <source>Leap</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Loop begins here</source>
        <translation>Schleife beginnt hier</translation>
    </message>
    <message>
        <source>Loop ends here</source>
        <translation>Schleife endet hier</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>Sch&amp;leife</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Alles zeigen</translation>
    </message>
    <message>
        <source>Show the &amp;fighter and what is selected</source>
        <translation>&amp;Kämpfer und Auswahl zeigen</translation>
    </message>
    <message>
        <source>Hide &amp;panels</source>
        <translation>&amp;Bedienfelder ausblenden</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Theme as the system</source>
        <translation>Design wie das System</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>Helles Design</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>Dunkles Design</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>Größere Schrift</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>Kleinere Schrift</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Correct the boundaries that cut the bout into actions.</source>
        <translation>Die Grenzen berichtigen, die den Kampf in Aktionen schneiden.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Say what a few actions are; the machine says it of the rest.</source>
        <translation>Sagen, was einige Aktionen sind; die Maschine sagt es vom Rest.</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Graph</translation>
    </message>
    <message>
        <source>What each fighter tends to do next, and the moments behind it.</source>
        <translation>Wozu jeder Kämpfer als Nächstes neigt, und die Momente dahinter.</translation>
    </message>
    <message>
        <source>Label actions</source>
        <translation>Aktionen labeln</translation>
    </message>
    <message>
        <source>Go to the Label workspace</source>
        <translation>Zum Arbeitsbereich Labels gehen</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>Labels übernehmen</translation>
    </message>
    <message>
        <source>From a table of labels; of a made bout at once its truth</source>
        <translation>Aus einer Label-Tabelle; bei einem erzeugten Kampf gleich die Wahrheit</translation>
    </message>
    <message>
        <source>Bout</source>
        <translation>Kampf</translation>
    </message>
    <message>
        <source>Let both fight on from what was learnt, or fight yourself.</source>
        <translation>Beide aus dem Gelernten weiterkämpfen lassen, oder selbst kämpfen.</translation>
    </message>
    <message>
        <source>Clips of sequences</source>
        <translation>Clips der Sequenzen</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Sequenz</translation>
    </message>
    <message>
        <source>Play actions in any order, led over to each other.</source>
        <translation>Aktionen in beliebiger Folge spielen, ineinander übergeleitet.</translation>
    </message>
    <message>
        <source>Add clips…</source>
        <translation>Clips hinzufügen…</translation>
    </message>
    <message>
        <source>Of motion files or other projects</source>
        <translation>Aus Bewegungsdateien oder anderen Projekten</translation>
    </message>
    <message>
        <source>Keyframe</source>
        <translation>Posen</translation>
    </message>
    <message>
        <source>A few key poses become a motion made of the recorded ones.</source>
        <translation>Aus wenigen Schlüsselposen wird eine Bewegung aus den aufgenommenen.</translation>
    </message>
    <message>
        <source>%1 frames back</source>
        <translation>%1 Frames zurück</translation>
    </message>
    <message>
        <source>%1 frames on</source>
        <translation>%1 Frames vor</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>measure from or to it</source>
        <translation>von oder bis dort messen</translation>
    </message>
    <message>
        <source>other fighter</source>
        <translation>anderer Kämpfer</translation>
    </message>
    <message>
        <source>leave measuring</source>
        <translation>Messen beenden</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>anhalten</translation>
    </message>
    <message>
        <source>play</source>
        <translation>abspielen</translation>
    </message>
    <message>
        <source>next suspect</source>
        <translation>nächster Verdacht</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>entfernen</translation>
    </message>
    <message>
        <source>action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>next question</source>
        <translation>nächste Frage</translation>
    </message>
    <message>
        <source>accept</source>
        <translation>annehmen</translation>
    </message>
    <message>
        <source>second best</source>
        <translation>Zweitbestes</translation>
    </message>
    <message>
        <source>lane</source>
        <translation>Spur</translation>
    </message>
    <message>
        <source>… its classes</source>
        <translation>… ihre Klassen</translation>
    </message>
    <message>
        <source>fight</source>
        <translation>kämpfen</translation>
    </message>
    <message>
        <source>… lead the avatar</source>
        <translation>… den Avatar führen</translation>
    </message>
    <message>
        <source>go on otherwise</source>
        <translation>anders weiter</translation>
    </message>
    <message>
        <source>… play a block at once</source>
        <translation>… einen Block sofort spielen</translation>
    </message>
    <message>
        <source>back to the sequence</source>
        <translation>zurück zur Sequenz</translation>
    </message>
    <message>
        <source>find an action</source>
        <translation>Aktion suchen</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>hinzufügen</translation>
    </message>
    <message>
        <source>block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>draw its transition anew</source>
        <translation>Übergang neu ziehen</translation>
    </message>
    <message>
        <source>map of poses</source>
        <translation>Posenkarte</translation>
    </message>
    <message>
        <source>live</source>
        <translation>live</translation>
    </message>
    <message>
        <source>add a key here</source>
        <translation>Schlüsselpose setzen</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Schlüsselpose</translation>
    </message>
    <message>
        <source>take the recording&apos;s pose</source>
        <translation>Pose der Aufnahme</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>pin it</source>
        <translation>festhalten</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>spiegeln</translation>
    </message>
    <message>
        <source>back to the keys</source>
        <translation>zu den Schlüsselposen</translation>
    </message>
    <message>
        <source>hit a target</source>
        <translation>Ziel treffen</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>keep as a take</source>
        <translation>als Take behalten</translation>
    </message>
    <message>
        <source>next surprise</source>
        <translation>nächste Überraschung</translation>
    </message>
    <message>
        <source>play what is behind</source>
        <translation>zeigen, was dahintersteckt</translation>
    </message>
    <message>
        <source>matrix or graph</source>
        <translation>Matrix oder Graph</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>add</source>
        <translation>hinzufügen</translation>
    </message>
    <message>
        <source>any command</source>
        <translation>jeder Befehl</translation>
    </message>
    <message>
        <source>help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>1 finding</source>
        <translation>1 Befund</translation>
    </message>
    <message>
        <source>%1 findings</source>
        <translation>%1 Befunde</translation>
    </message>
    <message>
        <source>What was found in the recordings</source>
        <translation>Was in den Aufnahmen gefunden wurde</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>&amp;Take</translation>
    </message>
    <message>
        <source>&amp;Add recordings as a take…</source>
        <translation>&amp;Aufnahmen als Take hinzufügen…</translation>
    </message>
    <message>
        <source>&amp;Rename take</source>
        <translation>Take &amp;umbenennen</translation>
    </message>
    <message>
        <source>Re&amp;move take</source>
        <translation>Take &amp;entfernen</translation>
    </message>
    <message>
        <source>Move take &amp;up</source>
        <translation>Take nach &amp;oben</translation>
    </message>
    <message>
        <source>Move take &amp;down</source>
        <translation>Take nach u&amp;nten</translation>
    </message>
    <message>
        <source>Show the take &amp;before</source>
        <translation>&amp;Vorigen Take zeigen</translation>
    </message>
    <message>
        <source>Show the take a&amp;fter</source>
        <translation>Nächsten Take &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Other fighter active</source>
        <translation>An&amp;deren Kämpfer aktivieren</translation>
    </message>
    <message>
        <source>Fighter &amp;properties…</source>
        <translation>&amp;Kämpfereigenschaften…</translation>
    </message>
    <message>
        <source>&amp;Swap fighters</source>
        <translation>Kämpfer &amp;tauschen</translation>
    </message>
    <message>
        <source>F&amp;indings on the recordings</source>
        <translation>&amp;Befunde zu den Aufnahmen</translation>
    </message>
    <message>
        <source>Removed take %1. %2 brings it back.</source>
        <translation>Take %1 entfernt. %2 bringt ihn zurück.</translation>
    </message>
    <message>
        <source>leave the field or button</source>
        <translation>Feld oder Knopf verlassen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MatrixPage</name>
    <message>
        <source>log</source>
        <translation>log</translation>
    </message>
    <message>
        <source>by own label</source>
        <translation>nach eigenem Label</translation>
    </message>
    <message>
        <source>by opponent&apos;s label</source>
        <translation>nach Label des Gegners</translation>
    </message>
    <message>
        <source>by both labels</source>
        <translation>nach beiden Labels</translation>
    </message>
    <message>
        <source>What the rows know</source>
        <translation>Was die Zeilen wissen</translation>
    </message>
    <message>
        <source>What the rows know: what the fighter does, what the opponent does, or both. What is left out is summed over.</source>
        <translation>Was die Zeilen wissen: was der Kämpfer tut, was der Gegner tut, oder beides. Über das Weggelassene wird summiert.</translation>
    </message>
    <message>
        <source>by count</source>
        <translation>nach Anzahl</translation>
    </message>
    <message>
        <source>by name</source>
        <translation>nach Namen</translation>
    </message>
    <message>
        <source>by likeness</source>
        <translation>nach Ähnlichkeit</translation>
    </message>
    <message>
        <source>Order of rows and columns</source>
        <translation>Reihenfolge der Zeilen und Spalten</translation>
    </message>
    <message>
        <source>By likeness rows that lead to the same labels become neighbours; a line parts the groups.</source>
        <translation>Bei Ähnlichkeit werden Zeilen, die zu denselben Labels führen, Nachbarn; eine Linie trennt die Gruppen.</translation>
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
        <translation>wie gezählt</translation>
    </message>
    <message>
        <source>How probabilities are estimated</source>
        <translation>Wie Wahrscheinlichkeiten geschätzt werden</translation>
    </message>
    <message>
        <source>EQU7: P(next | own) · P(next | opponent). EQU6: over pairs of label elements. EQU5: counts of whole triples. All three with a prior, so that nothing is impossible; as counted: without.</source>
        <translation>EQU7: P(nächstes | eigenes) · P(nächstes | Gegner). EQU6: über Paare von Label-Elementen. EQU5: Anzahlen ganzer Tripel. Alle drei mit einer A-priori-Verteilung, damit nichts unmöglich ist; wie gezählt: ohne.</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>nebeneinander</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>How two are compared</source>
        <translation>Wie zwei verglichen werden</translation>
    </message>
    <message>
        <source>Colours over the logarithm: rare transitions become visible</source>
        <translation>Farben nach dem Logarithmus: Seltene Übergänge werden sichtbar</translation>
    </message>
    <message>
        <source>Matrix of transitions to compare with</source>
        <translation>Matrix der Übergänge zum Vergleich</translation>
    </message>
    <message>
        <source>P(next | own)</source>
        <translation>P(nächstes | eigenes)</translation>
    </message>
    <message>
        <source>P(next | opponent)</source>
        <translation>P(nächstes | Gegner)</translation>
    </message>
    <message>
        <source>P(next | own, opponent)</source>
        <translation>P(nächstes | eigenes, Gegner)</translation>
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
        <translation>Differenz %1</translation>
    </message>
    <message>
        <source>P %1</source>
        <translation>P %1</translation>
    </message>
    <message>
        <source>%1 → %2   ·   %3   ·   seen %4 of %5 times</source>
        <translation>%1 → %2   ·   %3   ·   %4 von %5 Mal gesehen</translation>
    </message>
    <message>
        <source>%1   ·   %2 transitions begin so</source>
        <translation>%1   ·   %2 Übergänge beginnen so</translation>
    </message>
    <message>
        <source>%1   ·   %2 transitions lead here</source>
        <translation>%1   ·   %2 Übergänge führen hierher</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MatrixView</name>
    <message>
        <source>Matrix of transitions</source>
        <translation>Matrix der Übergänge</translation>
    </message>
    <message>
        <source>A row is what goes on, a column what follows. Arrows lead from cell to cell; the moments behind the chosen one are listed beside it.</source>
        <translation>Eine Zeile ist, was gerade läuft, eine Spalte, was folgt. Pfeiltasten führen von Zelle zu Zelle; die Momente hinter der gewählten stehen daneben.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MessageStrip</name>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschehen ist</translation>
    </message>
    <message numerus="yes">
        <source> And %n more.</source>
        <translation>
            <numerusform> Und noch %n.</numerusform>
            <numerusform> Und noch %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::MotionBox</name>
    <message>
        <source>joints adjusted</source>
        <translation>Gelenke angepasst</translation>
    </message>
    <message>
        <source>What the motion is made of</source>
        <translation>Woraus die Bewegung besteht</translation>
    </message>
    <message>
        <source>whole body</source>
        <translation>ganzer Körper</translation>
    </message>
    <message>
        <source>What is looked for</source>
        <translation>Was gesucht wird</translation>
    </message>
    <message>
        <source>In what the places are like the keys: the whole body or one part</source>
        <translation>Worin die Stellen den Posen gleichen: im ganzen Körper oder in einem Teil</translation>
    </message>
    <message>
        <source>Similar in</source>
        <translation>Ähnlich in</translation>
    </message>
    <message>
        <source>The keys and places like them</source>
        <translation>Die Posen und ähnliche Stellen</translation>
    </message>
    <message>
        <source>First the keys, then what is most like them; a click takes it</source>
        <translation>Erst die Posen, dann das Ähnlichste; ein Klick nimmt es</translation>
    </message>
    <message>
        <source>Places that are like the keys</source>
        <translation>Stellen, die den Schlüsselposen ähneln</translation>
    </message>
    <message>
        <source>The places that are most like the keys, the best first; a click, or Return, takes the body or the part from there</source>
        <translation>Die Stellen, die den Posen am meisten gleichen, die beste zuerst; ein Klick oder die Eingabetaste nimmt Körper oder Teil von dort</translation>
    </message>
    <message>
        <source>what fits better</source>
        <translation>was besser passt</translation>
    </message>
    <message>
        <source>with the body</source>
        <translation>mit dem Körper</translation>
    </message>
    <message>
        <source>its own best</source>
        <translation>eigenes Bestes</translation>
    </message>
    <message>
        <source>as chosen above</source>
        <translation>wie oben gewählt</translation>
    </message>
    <message>
        <source>Where the %1 comes from</source>
        <translation>Herkunft: %1</translation>
    </message>
    <message>
        <source>Take a part from elsewhere</source>
        <translation>Einen Teil von anderswo nehmen</translation>
    </message>
    <message>
        <source>Where parts are joined the joints&apos; mean and spread become those of the keys (paper C, 4.2.2)</source>
        <translation>Wo Teile verbunden werden, erhalten Mittel und Streuung der Gelenke die Werte der Schlüsselposen (Artikel C, 4.2.2)</translation>
    </message>
    <message>
        <source>How far the motion is drawn to the keys</source>
        <translation>Wie weit die Bewegung zu den Schlüsselposen gezogen wird</translation>
    </message>
    <message>
        <source>Left: as it was found; right: through the keys&apos; poses</source>
        <translation>Links: wie gefunden; rechts: durch die Schlüsselposen</translation>
    </message>
    <message>
        <source>Meet keys</source>
        <translation>Posen treffen</translation>
    </message>
    <message>
        <source>Join parts otherwise</source>
        <translation>Teile anders verbinden</translation>
    </message>
    <message>
        <source>Draw the motion to the keys</source>
        <translation>Bewegung zu den Schlüsselposen ziehen</translation>
    </message>
    <message>
        <source>Two keys or more become a motion, put together from the takes and clips.</source>
        <translation>Zwei oder mehr Schlüsselposen werden zur Bewegung, zusammengesetzt aus den Takes und Clips.</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>Die Bewegung wird erzeugt.</translation>
    </message>
    <message>
        <source>Body: %1, %2 of %3 features differ, %4 cm from the keys.</source>
        <translation>Körper: %1, %2 von %3 Merkmalen abweichend, %4 cm von den Schlüsselposen.</translation>
    </message>
    <message>
        <source>%1 features differ, %2 cm from the keys</source>
        <translation>%1 Merkmale abweichend, %2 cm von den Schlüsselposen</translation>
    </message>
    <message>
        <source>%1, %2 features differ</source>
        <translation>%1, %2 Merkmale abweichend</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>die Posen</translation>
    </message>
    <message>
        <source>Take the %1 from elsewhere</source>
        <translation>%1 von anderswo nehmen</translation>
    </message>
    <message>
        <source>Take the body from elsewhere</source>
        <translation>Körper von anderswo nehmen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::NodePage</name>
    <message>
        <source>cross edges</source>
        <translation>Querkanten</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Fighter 1&apos;s graph before fighter 2&apos;s, cross edges between; drag turns</source>
        <translation>Der Graph von Kämpfer 1 vor dem von Kämpfer 2, dazwischen die Querkanten; Ziehen dreht</translation>
    </message>
    <message>
        <source>Also what a fighter does next given what the opponent is doing; those of what is selected show always</source>
        <translation>Auch, was ein Kämpfer als Nächstes tut, je nachdem, was der Gegner tut; die der Auswahl sind immer zu sehen</translation>
    </message>
    <message>
        <source>Of each side only what it does more often than the other, as wide as the difference</source>
        <translation>Von jeder Seite nur, was sie öfter tut als die andere, so breit wie die Differenz</translation>
    </message>
    <message>
        <source>Least probability of an edge</source>
        <translation>Kleinste Wahrscheinlichkeit einer Kante</translation>
    </message>
    <message>
        <source>Edges that are less probable are not drawn.</source>
        <translation>Weniger wahrscheinliche Kanten werden nicht gezeichnet.</translation>
    </message>
    <message>
        <source>Most edges from a node</source>
        <translation>Meiste Kanten eines Knotens</translation>
    </message>
    <message>
        <source>So many edges of each node are drawn, the likeliest ones.</source>
        <translation>So viele Kanten jedes Knotens werden gezeichnet, die wahrscheinlichsten.</translation>
    </message>
    <message>
        <source>ΔP ≥ 0.000</source>
        <translation>ΔP ≥ 0,000</translation>
    </message>
    <message>
        <source>12 a node</source>
        <translation>12 je Knoten</translation>
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
        <translation>%1 je Knoten</translation>
    </message>
    <message>
        <source>%1: %2   ·   %3 actions</source>
        <translation>%1: %2   ·   %3 Aktionen</translation>
    </message>
    <message>
        <source>%1: %2 → %3   ·   %4 %5   ·   seen %6 times</source>
        <translation>%1: %2 → %3   ·   %4 %5   ·   %6 Mal gesehen</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>more often by</source>
        <translation>öfter um</translation>
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
        <translation>Notiz zur Aktion</translation>
    </message>
    <message>
        <source>Return keeps the note, Esc leaves it as it was; no text removes it.</source>
        <translation>Eingabe behält die Notiz, Esc lässt sie, wie sie war; ohne Text wird sie entfernt.</translation>
    </message>
    <message>
        <source>Note on this action</source>
        <translation>Notiz zu dieser Aktion</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PartDialog</name>
    <message>
        <source>joints adjusted</source>
        <translation>Gelenke angepasst</translation>
    </message>
    <message>
        <source>Replace a part of a take</source>
        <translation>Teil eines Takes ersetzen</translation>
    </message>
    <message>
        <source>In</source>
        <translation>In</translation>
    </message>
    <message>
        <source>take that is changed</source>
        <translation>Take, der geändert wird</translation>
    </message>
    <message>
        <source>Part that is replaced</source>
        <translation>Teil, der ersetzt wird</translation>
    </message>
    <message>
        <source>Where the part hangs on the rest its joint keeps the take&apos;s mean and spread</source>
        <translation>Wo der Teil am übrigen Körper hängt, behält das Gelenk Mittel und Streuung des Takes</translation>
    </message>
    <message>
        <source>The</source>
        <translation>Ersetze</translation>
    </message>
    <message>
        <source>By that of</source>
        <translation>Durch den von</translation>
    </message>
    <message>
        <source>take or clip that lends the part</source>
        <translation>Take oder Clip, der den Teil leiht</translation>
    </message>
    <message>
        <source>The take, what lends the part, and the result</source>
        <translation>Der Take, der Geber des Teils und das Ergebnis</translation>
    </message>
    <message>
        <source>What becomes of it</source>
        <translation>Was daraus wird</translation>
    </message>
    <message>
        <source>Keep as a take…</source>
        <translation>Als Take behalten…</translation>
    </message>
    <message>
        <source>The %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>First frame of the %1</source>
        <translation>Erstes Frame: %1</translation>
    </message>
    <message>
        <source>Last frame of the %1</source>
        <translation>Letzter Frame: %1</translation>
    </message>
    <message>
        <source>%1, at %2 Hz</source>
        <translation>%1, mit %2 Hz</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>wie er ist</translation>
    </message>
    <message>
        <source>what lends the %1</source>
        <translation>was den Teil leiht: %1</translation>
    </message>
    <message>
        <source>the result</source>
        <translation>das Ergebnis</translation>
    </message>
    <message>
        <source>%1 of the take&apos;s %2 are changed, in the %3 only; all else stays.</source>
        <translation>%1 von %2 des Takes werden geändert, nur hier: %3; alles andere bleibt.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PartWords</name>
    <message>
        <source>left arm</source>
        <translation>linker Arm</translation>
    </message>
    <message>
        <source>right arm</source>
        <translation>rechter Arm</translation>
    </message>
    <message>
        <source>left leg</source>
        <translation>linkes Bein</translation>
    </message>
    <message>
        <source>right leg</source>
        <translation>rechtes Bein</translation>
    </message>
    <message>
        <source>trunk, head</source>
        <translation>Rumpf, Kopf</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PoseBox</name>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>linker Fuß</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>rechter Fuß</translation>
    </message>
    <message>
        <source>hips</source>
        <translation>Hüfte</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>even</source>
        <translation>gleichmäßig</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>from rest</source>
        <translation>aus der Ruhe</translation>
    </message>
    <message>
        <source>to rest</source>
        <translation>in die Ruhe</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>stays where it is</source>
        <translation>bleibt, wo er ist</translation>
    </message>
    <message>
        <source>and later keys</source>
        <translation>und spätere Posen</translation>
    </message>
    <message>
        <source>The chosen key</source>
        <translation>Die gewählte Schlüsselpose</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>What is drawn: drag it in the 3D view, or give its place below</source>
        <translation>Was gezogen wird: in der 3D-Ansicht ziehen oder unten den Ort angeben</translation>
    </message>
    <message>
        <source>While another handle is drawn this one stays; Ctrl and a click on it does the same</source>
        <translation>Während ein anderer Griff gezogen wird, bleibt dieser stehen; Strg und ein Klick auf ihn bewirkt dasselbe</translation>
    </message>
    <message>
        <source>Place, %1 in metres</source>
        <translation>Ort, %1 in Metern</translation>
    </message>
    <message>
        <source>%1, metres; y is up</source>
        <translation>%1, Meter; y ist oben</translation>
    </message>
    <message>
        <source>x y z, m</source>
        <translation>x y z, m</translation>
    </message>
    <message>
        <source>Way to the next key</source>
        <translation>Weg zur nächsten Schlüsselpose</translation>
    </message>
    <message>
        <source>How the way to the next key goes</source>
        <translation>Wie der Weg zur nächsten Schlüsselpose verläuft</translation>
    </message>
    <message>
        <source>Way on</source>
        <translation>Weg weiter</translation>
    </message>
    <message>
        <source>Frame of the key</source>
        <translation>Frame der Pose</translation>
    </message>
    <message>
        <source>Moves the key to that frame</source>
        <translation>Verschiebt die Pose auf dieses Frame</translation>
    </message>
    <message>
        <source>Later keys go as many frames along</source>
        <translation>Spätere Posen gehen ebenso viele Frames mit</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>Time from this key on, times</source>
        <translation>Zeit ab dieser Pose, mal</translation>
    </message>
    <message>
        <source>All later keys that many times as far from this one: 2 is half as fast</source>
        <translation>Alle späteren Posen so viel weiter von dieser entfernt: 2 ist halb so schnell</translation>
    </message>
    <message>
        <source>Time on</source>
        <translation>Zeit danach</translation>
    </message>
    <message>
        <source>Frame %1. Drag hands, feet, hips, chest or head in the 3D view.</source>
        <translation>Frame %1. Ziehen Sie Hände, Füße, Hüfte, Brust oder Kopf in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>Return makes a key.</source>
        <translation>Eingabe setzt eine Schlüsselpose.</translation>
    </message>
    <message>
        <source>Choose a key to change its pose.</source>
        <translation>Wählen Sie eine Schlüsselpose, um sie zu ändern.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PoseDialog</name>
    <message>
        <source>Copy a pose</source>
        <translation>Pose kopieren</translation>
    </message>
    <message>
        <source>Take or clip</source>
        <translation>Take oder Clip</translation>
    </message>
    <message>
        <source>Whose pose is copied: a fighter of a take, or a clip</source>
        <translation>Wessen Pose kopiert wird: die eines Kämpfers in einem Take oder eines Clips</translation>
    </message>
    <message>
        <source>The pose</source>
        <translation>Die Pose</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>Which moment; arrow keys go on by one frame</source>
        <translation>Welcher Zeitpunkt; Pfeiltasten gehen ein Frame weiter</translation>
    </message>
    <message>
        <source>Frame of the take or clip</source>
        <translation>Frame des Takes oder Clips</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Copy the pose</source>
        <translation>Pose kopieren</translation>
    </message>
    <message>
        <source>frame %1 at %2 Hz</source>
        <translation>Frame %1 bei %2 Hz</translation>
    </message>
    <message>
        <source>Copy the pose of %1</source>
        <translation>Pose von %1 kopieren</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Standard wiederherstellen</translation>
    </message>
    <message>
        <source>All values of the General page as the studio brings them.</source>
        <translation>Alle Werte der Seite „Allgemein“, wie mitgeliefert.</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Diese Seite schließen (Esc)</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Design</translation>
    </message>
    <message>
        <source>Colours of the whole window.</source>
        <translation>Farben des ganzen Fensters.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Of all texts, numbers and dates in the window; files do not know it. The window is made anew at once, with what is open in it.</source>
        <translation>Aller Texte, Zahlen und Daten im Fenster; Dateien kennen sie nicht. Das Fenster wird sofort neu gemacht, mit dem, was darin offen ist.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Text size, percent</source>
        <translation>Schriftgröße, Prozent</translation>
    </message>
    <message>
        <source>How large all text is; pages that it makes too large can be scrolled.</source>
        <translation>Wie groß alle Schrift ist; Seiten, die dadurch zu groß werden, lassen sich rollen.</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Reduce motion</source>
        <translation>Weniger Bewegung</translation>
    </message>
    <message>
        <source>Nothing begins to move by itself: questions and similar actions stand still until you play them.</source>
        <translation>Nichts bewegt sich von selbst: Fragen und ähnliche Aktionen stehen still, bis man sie abspielt.</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Playback speed of a bout that is opened, percent</source>
        <translation>Wiedergabetempo beim Öffnen eines Kampfs, Prozent</translation>
    </message>
    <message>
        <source>How fast a bout plays when it is opened. While it is open, - and + change it.</source>
        <translation>Wie schnell ein Kampf nach dem Öffnen abgespielt wird. Danach ändern - und + das Tempo.</translation>
    </message>
    <message>
        <source>Speed at opening</source>
        <translation>Tempo beim Öffnen</translation>
    </message>
    <message>
        <source>Play in a loop</source>
        <translation>In Schleife abspielen</translation>
    </message>
    <message>
        <source>Whether a bout loops when it is opened.</source>
        <translation>Ob ein Kampf nach dem Öffnen in Schleife läuft.</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> Frames</translation>
    </message>
    <message>
        <source>Frames of a leap</source>
        <translation>Frames eines Sprungs</translation>
    </message>
    <message>
        <source>How far Shift+← and Shift+→ go.</source>
        <translation>Wie weit Umschalt+← und Umschalt+→ gehen.</translation>
    </message>
    <message>
        <source>Shift+← → goes</source>
        <translation>Umschalt+← → geht</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Mouse sensitivity in the 3D view, percent</source>
        <translation>Mausempfindlichkeit in der 3D-Ansicht, Prozent</translation>
    </message>
    <message>
        <source>How fast a drag turns and the wheel zooms in the 3D view.</source>
        <translation>Wie schnell Ziehen dreht und das Rad zoomt, in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>Sensitivity in 3D</source>
        <translation>Empfindlichkeit in 3D</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Autosave interval in seconds</source>
        <translation>Abstand der automatischen Sicherung in Sekunden</translation>
    </message>
    <message>
        <source>After how long at most changes are kept for a recovery. The project file itself is written only when you save.</source>
        <translation>Nach wie langer Zeit spätestens Änderungen für eine Wiederherstellung gesichert werden. Die Projektdatei selbst wird nur geschrieben, wenn Sie speichern.</translation>
    </message>
    <message>
        <source>Autosave every</source>
        <translation>Automatisch sichern alle</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ProgressBox</name>
    <message>
        <source>Progress of labelling</source>
        <translation>Fortschritt beim Labeln</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>Was als Nächstes zu tun ist</translation>
    </message>
    <message>
        <source>Keep what machine and rules propose where they are at least so sure; one step of the history (Ctrl+Return)</source>
        <translation>Behalten, was Maschine und Regeln mindestens so sicher vorschlagen; ein Schritt des Verlaufs (Strg+Eingabe)</translation>
    </message>
    <message>
        <source>Labelled by hand, accepted, open</source>
        <translation>Von Hand gelabelt, angenommen, offen</translation>
    </message>
    <message>
        <source>How sure the machine must be of what is accepted: 0.90 is nine of ten right. Ctrl+Down and Ctrl+Up move it.</source>
        <translation>Wie sicher die Maschine bei dem sein muss, was angenommen wird: 0,90 heißt neun von zehn richtig. Strg+Ab und Strg+Auf ändern es.</translation>
    </message>
    <message>
        <source>Least probability of what is accepted</source>
        <translation>Kleinste Wahrscheinlichkeit des Angenommenen</translation>
    </message>
    <message>
        <source>Proposals that are at least so probable are accepted.</source>
        <translation>Mindestens so wahrscheinliche Vorschläge werden angenommen.</translation>
    </message>
    <message>
        <source>%1 actions: %2 labelled by hand (dark), %3 accepted (light), %4 open</source>
        <translation>%1 Aktionen: %2 von Hand gelabelt (dunkel), %3 angenommen (hell), %4 offen</translation>
    </message>
    <message>
        <source>%1 labelled</source>
        <translation>%1 gelabelt</translation>
    </message>
    <message>
        <source>, expected accuracy %1</source>
        <translation>, erwartete Genauigkeit %1</translation>
    </message>
    <message>
        <source>Accept rules</source>
        <translation>Regeln annehmen</translation>
    </message>
    <message>
        <source>Accept %1 sure</source>
        <translation>%1 annehmen</translation>
    </message>
    <message>
        <source>Accept the sure</source>
        <translation>Sichere annehmen</translation>
    </message>
    <message>
        <source>Every action is labelled. File &gt; Save keeps it; Label &gt; Write labels… makes a table.</source>
        <translation>Jede Aktion ist gelabelt. Datei &gt; Speichern behält es; Labels &gt; Labels schreiben… macht eine Tabelle.</translation>
    </message>
    <message>
        <source>No recording is cut into actions yet.</source>
        <translation>Noch ist keine Aufnahme in Aktionen geschnitten.</translation>
    </message>
    <message>
        <source>Label a few actions by hand; the machine proposes the others. N leads to the one that says most.</source>
        <translation>Labeln Sie einige Aktionen von Hand; die Maschine schlägt die anderen vor. N führt zu der, die am meisten aussagt.</translation>
    </message>
    <message>
        <source>Go on: N leads to the next one that says most.</source>
        <translation>Weiter: N führt zur nächsten, die am meisten aussagt.</translation>
    </message>
    <message>
        <source>What rules say is left to be accepted.</source>
        <translation>Was Regeln sagen, ist noch anzunehmen.</translation>
    </message>
    <message>
        <source>Nothing of %1 was labelled so far: if there is any, show the machine one.</source>
        <translation>Von %1 wurde bisher nichts gelabelt: Gibt es das, zeigen Sie der Maschine eines.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Accept %1 guesses</source>
        <translation>%1 Vermutungen</translation>
    </message>
    <message>
        <source>Every action has a label, but of ten that the machine gave only about %1 are right. N leads through those of which it was least sure; or undo the acceptance and answer more questions.</source>
        <translation>Jede Aktion hat ein Label, aber von zehn der Maschine stimmen nur etwa %1. N führt durch die unsichersten; oder die Annahme rückgängig machen und mehr Fragen beantworten.</translation>
    </message>
    <message numerus="yes">
        <source>%n minima are still suspect. Half actions are hard to label: correct them in Segment first, or go on with N.</source>
        <translation>
            <numerusform>%n Minimum ist noch verdächtig. Halbe Aktionen sind schwer zu labeln: erst im Schnitt verbessern, oder weiter mit N.</numerusform>
            <numerusform>%n Minima sind noch verdächtig. Halbe Aktionen sind schwer zu labeln: erst im Schnitt verbessern, oder weiter mit N.</numerusform>
        </translation>
    </message>
    <message>
        <source>How many of the machine&apos;s answers should be right where no hand has spoken</source>
        <translation>Wie viele Antworten der Maschine stimmen dürften, wo keine Hand etwas gesagt hat</translation>
    </message>
    <message>
        <source>More labels by hand will hardly help: accept the sure rest (%1), lower the bar for the others (%2), then look through the least sure (%3).</source>
        <translation>Mehr Labels von Hand helfen kaum noch: den sicheren Rest annehmen (%1), für die anderen die Schwelle senken (%2), dann die unsichersten durchsehen (%3).</translation>
    </message>
    <message>
        <source>Go on: the next ones tell the machine most.</source>
        <translation>Weiter: Die nächsten sagen der Maschine am meisten.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::QualityBox</name>
    <message>
        <source>Actions of the cell</source>
        <translation>Aktionen der Zelle</translation>
    </message>
    <message>
        <source>Aspect of the confusion matrix</source>
        <translation>Aspekt der Konfusionsmatrix</translation>
    </message>
    <message>
        <source>Whose classes the matrix and the list are about.</source>
        <translation>Um wessen Klassen es in Matrix und Liste geht.</translation>
    </message>
    <message>
        <source>What the cell says</source>
        <translation>Was die Zelle sagt</translation>
    </message>
    <message>
        <source>Share of actions whose learnt aspects are all right. Expected: cross-validation over the hand labels as the session went. As asked and random: the hand labels are dealt into folds; one is held out, and from the others the machine learns more and more labels, in the order in which the queue asks for them and in random orders. Both are judged on the same held-out labels. What was asked for is harder than the rest, so the bout as a whole fares better.</source>
        <translation>Anteil der Aktionen, deren gelernte Aspekte alle stimmen. Erwartet: Kreuzvalidierung über die Labels von Hand im Lauf der Sitzung. Wie gefragt und zufällig: Die Labels von Hand werden auf Gruppen verteilt; eine wird zurückgehalten, und aus den anderen lernt die Maschine immer mehr Labels, in der Reihenfolge der Warteschlange und in zufälligen Reihenfolgen. Beide werden an denselben zurückgehaltenen Labels gemessen. Gefragt wird nach Schwererem als dem Rest; der Kampf als Ganzes schneidet also besser ab.</translation>
    </message>
    <message>
        <source>Judging</source>
        <translation>Wird beurteilt</translation>
    </message>
    <message>
        <source>Comparing orders</source>
        <translation>Reihenfolgen werden verglichen</translation>
    </message>
    <message>
        <source>How often machine and rules say the same as your hand appears here, once some actions are labelled by hand.</source>
        <translation>Wie oft Maschine und Regeln dasselbe sagen wie Ihre Hand, erscheint hier, sobald einige Aktionen von Hand gelabelt sind.</translation>
    </message>
    <message>
        <source>No hand has said anything of this aspect.</source>
        <translation>Zu diesem Aspekt wurde nichts von Hand gesagt.</translation>
    </message>
    <message>
        <source>Rows by hand, columns %1. %2 of %3 right, F1 %4.</source>
        <translation>Zeilen von Hand, Spalten %1. %2 von %3 richtig, F1 %4.</translation>
    </message>
    <message>
        <source>by rule</source>
        <translation>per Regel</translation>
    </message>
    <message>
        <source>by machine, unseen</source>
        <translation>per Maschine, ungesehen</translation>
    </message>
    <message>
        <source>A click on a cell, or Enter, opens its actions.</source>
        <translation>Ein Klick auf eine Zelle oder Eingabe öffnet ihre Aktionen.</translation>
    </message>
    <message>
        <source>No action is in this cell.</source>
        <translation>Keine Aktion ist in dieser Zelle.</translation>
    </message>
    <message>
        <source>%1 labels as asked do what %2 in random order do.</source>
        <translation>%1 Labels wie gefragt leisten so viel wie %2 in zufälliger Folge.</translation>
    </message>
    <message>
        <source>With %1 hand labels the order of the questions is compared with a random one.</source>
        <translation>Ab %1 Labels von Hand wird die Reihenfolge der Fragen mit einer zufälligen verglichen.</translation>
    </message>
    <message>
        <source>More labels will hardly help.</source>
        <translation>Mehr Labels helfen kaum.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Questions</name>
    <message>
        <source>%1: nobody is here to choose a file.</source>
        <translation>%1: Niemand ist da, um eine Datei zu wählen.</translation>
    </message>
    <message>
        <source>%1 Nobody is here to answer: %2.</source>
        <translation>%1 Niemand ist da, um zu antworten: %2.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RecentButton</name>
    <message>
        <source>Open %1, %2</source>
        <translation>%1 öffnen, %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Recovery</name>
    <message>
        <source>Saving a copy</source>
        <translation>Kopie wird gesichert</translation>
    </message>
    <message>
        <source>Recovery copies cannot be written. %1</source>
        <translation>Sicherungskopien können nicht geschrieben werden. %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RecoveryDialog</name>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Wiederherstellung</translation>
    </message>
    <message>
        <source>Kumite ended unexpectedly. The edits that were not saved are kept here; recovered, they stand in the project as unsaved changes.</source>
        <translation>Kumite wurde unerwartet beendet. Die nicht gespeicherten Änderungen sind hier erhalten; wiederhergestellt stehen sie als ungespeicherte Änderungen im Projekt.</translation>
    </message>
    <message>
        <source>Projects that can be recovered</source>
        <translation>Wiederherstellbare Projekte</translation>
    </message>
    <message>
        <source>What was not saved; a double-click recovers it</source>
        <translation>Was nicht gespeichert wurde; ein Doppelklick stellt es wieder her</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Last edit</source>
        <translation>Letzte Änderung</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>nie gespeichert</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Delete the chosen edits for good (Del)</source>
        <translation>Die gewählten Änderungen endgültig löschen (Entf)</translation>
    </message>
    <message>
        <source>Open the chosen project with its unsaved edits (Enter)</source>
        <translation>Das gewählte Projekt mit den ungespeicherten Änderungen öffnen (Eingabe)</translation>
    </message>
    <message>
        <source>Keep them and ask again at the next start (Esc)</source>
        <translation>Behalten und beim nächsten Start wieder fragen (Esc)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Review</name>
    <message numerus="yes">
        <source>What you decided clears %n more.</source>
        <translation>
            <numerusform>Ihre Entscheidung entlastet %n weiteres.</numerusform>
            <numerusform>Ihre Entscheidung entlastet %n weitere.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n suspect(s) left.</source>
        <translation>
            <numerusform>%n Verdachtsfall übrig.</numerusform>
            <numerusform>%n Verdachtsfälle übrig.</numerusform>
        </translation>
    </message>
    <message>
        <source>Every minimum of this take is decided.</source>
        <translation>Jedes Minimum dieses Takes ist entschieden.</translation>
    </message>
    <message>
        <source>No suspect is left. N leads through the other minima.</source>
        <translation>Kein Verdachtsfall ist übrig. N führt durch die anderen Minima.</translation>
    </message>
    <message>
        <source>No boundary is selected. N leads to the most suspicious minimum.</source>
        <translation>Keine Grenze ist ausgewählt. N führt zum verdächtigsten Minimum.</translation>
    </message>
    <message>
        <source>No minimum is left to decide.</source>
        <translation>Kein Minimum ist mehr zu entscheiden.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RoleTable</name>
    <message>
        <source>read off the skeleton&apos;s shape</source>
        <translation>aus der Form des Skeletts gelesen</translation>
    </message>
    <message>
        <source>no human body found</source>
        <translation>kein menschlicher Körper gefunden</translation>
    </message>
    <message>
        <source>by %1 names</source>
        <translation>nach %1-Namen</translation>
    </message>
    <message>
        <source>Joints of the roles</source>
        <translation>Gelenke der Rollen</translation>
    </message>
    <message>
        <source>Which joint of the recording is which part of the body</source>
        <translation>Welches Gelenk der Aufnahme welcher Teil des Körpers ist</translation>
    </message>
    <message>
        <source>fighter 1</source>
        <translation>Kämpfer 1</translation>
    </message>
    <message>
        <source>fighter 2</source>
        <translation>Kämpfer 2</translation>
    </message>
    <message>
        <source>Fighter %1: %2 of %3 roles, %4.</source>
        <translation>Kämpfer %1: %2 von %3 Rollen, %4.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>set by hand</source>
        <translation>von Hand gesetzt</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RulesBox</name>
    <message>
        <source>Lands below</source>
        <translation>Setzt auf unter</translation>
    </message>
    <message>
        <source>Height below which a foot lands</source>
        <translation>Höhe, unter der ein Fuß aufsetzt</translation>
    </message>
    <message>
        <source>A foot stands once its toes are lower than this above their rest height …</source>
        <translation>Ein Fuß steht, sobald seine Zehen weniger als das über ihrer Ruhehöhe sind …</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>slower than</source>
        <translation>langsamer als</translation>
    </message>
    <message>
        <source>Speed below which a foot lands</source>
        <translation>Geschwindigkeit, unter der ein Fuß aufsetzt</translation>
    </message>
    <message>
        <source>… and slower than this.</source>
        <translation>… und langsamer als das.</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Lifts above</source>
        <translation>Hebt ab über</translation>
    </message>
    <message>
        <source>Height above which a foot lifts</source>
        <translation>Höhe, über der ein Fuß abhebt</translation>
    </message>
    <message>
        <source>It no longer stands once its toes are higher than this …</source>
        <translation>Er steht nicht mehr, sobald seine Zehen höher als das sind …</translation>
    </message>
    <message>
        <source>faster than</source>
        <translation>schneller als</translation>
    </message>
    <message>
        <source>Speed above which a foot lifts</source>
        <translation>Geschwindigkeit, über der ein Fuß abhebt</translation>
    </message>
    <message>
        <source>… or faster than this.</source>
        <translation>… oder schneller als das.</translation>
    </message>
    <message>
        <source>Stands for</source>
        <translation>Steht für</translation>
    </message>
    <message>
        <source>Shortest stance</source>
        <translation>Kürzester Stand</translation>
    </message>
    <message>
        <source>A stance that is shorter does not count.</source>
        <translation>Ein kürzerer Stand zählt nicht.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Closes at</source>
        <translation>Nähert sich mit</translation>
    </message>
    <message>
        <source>Speed at which an attack must close</source>
        <translation>Geschwindigkeit, mit der ein Angriff sich nähern muss</translation>
    </message>
    <message>
        <source>An attack counts for the react rule if its fist or foot closes on the trunk or head faster than this at some moment.</source>
        <translation>Ein Angriff zählt für die Reaktionsregel, wenn seine Faust oder sein Fuß sich irgendwann schneller als das dem Rumpf oder Kopf nähert.</translation>
    </message>
    <message>
        <source>Usual thresholds</source>
        <translation>Übliche Schwellen</translation>
    </message>
    <message>
        <source>Back to the thresholds that the studio brings</source>
        <translation>Zurück zu den mitgelieferten Schwellen</translation>
    </message>
    <message>
        <source>What the thresholds change</source>
        <translation>Was die Schwellen ändern</translation>
    </message>
    <message>
        <source>Why the rules say so</source>
        <translation>Warum die Regeln das sagen</translation>
    </message>
    <message>
        <source>%1: no action</source>
        <translation>%1: keine Aktion</translation>
    </message>
    <message>
        <source>%1: %2 of %3 actions</source>
        <translation>%1: %2 von %3 Aktionen</translation>
    </message>
    <message>
        <source>How many actions get another label stands here while a threshold is changed.</source>
        <translation>Wie viele Aktionen ein anderes Label bekommen, steht hier, während eine Schwelle geändert wird.</translation>
    </message>
    <message>
        <source>Changed: %1.</source>
        <translation>Geändert: %1.</translation>
    </message>
    <message>
        <source>React: %1</source>
        <translation>Reaktion: %1</translation>
    </message>
    <message>
        <source>Move: %1</source>
        <translation>Bewegung: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SegmentPanel</name>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Suspect minima</source>
        <translation>Verdächtige Minima</translation>
    </message>
    <message>
        <source>Minima of the force curves that cut actions appear here, the most suspicious first. Lower the prominence below to see more.</source>
        <translation>Minima der Kraftkurven, die Aktionen schneiden, erscheinen hier, die verdächtigsten zuerst. Senken Sie unten die Prominenz, um mehr zu sehen.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Detection</source>
        <translation>Erkennung</translation>
    </message>
    <message>
        <source>Why the minimum is suspected</source>
        <translation>Warum das Minimum verdächtig ist</translation>
    </message>
    <message>
        <source>It is a boundary: no suspect any more; goes on to the next</source>
        <translation>Es ist eine Grenze: nicht mehr verdächtig; weiter zum nächsten</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>A boundary that a hand has set.</source>
        <translation>Eine von Hand gesetzte Grenze.</translation>
    </message>
    <message>
        <source>No suspect is left. %1 leads through the others.</source>
        <translation>Kein Verdachtsfall ist übrig. %1 führt durch die anderen.</translation>
    </message>
    <message>
        <source>Bring the boundary back</source>
        <translation>Die Grenze zurückholen</translation>
    </message>
    <message>
        <source>It is spurious; goes on to the next</source>
        <translation>Sie ist unecht; weiter zum nächsten</translation>
    </message>
    <message>
        <source>%1 leads to the most suspicious minimum. Remove it where the body hardly dips: a kick down and up again is one action. Keep it where one ends and another begins.</source>
        <translation>%1 führt zum verdächtigsten Minimum. Entfernen Sie es, wo der Körper kaum absinkt: Ein Tritt runter und wieder hoch ist eine Aktion. Behalten Sie es, wo eine endet und eine andere beginnt.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceBar</name>
    <message>
        <source>Time of the sequence</source>
        <translation>Zeit der Sequenz</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>the chosen action, %1 s; Esc: back to the sequence</source>
        <translation>die gewählte Aktion, %1 s; Esc: zurück zur Sequenz</translation>
    </message>
    <message>
        <source>live: 1 … 9 play blocks at once</source>
        <translation>live: 1 … 9 spielen Blöcke sofort</translation>
    </message>
    <message>
        <source> · last %1, cost %2</source>
        <translation> · zuletzt %1, Kosten %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceCommands</name>
    <message>
        <source>Se&amp;quence</source>
        <translation>Se&amp;quenz</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ein Frame zurück</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Ein Frame vor</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>Play it &amp;over and over</source>
        <translation>&amp;Immer wieder abspielen</translation>
    </message>
    <message>
        <source>&amp;Live: keys play blocks at once</source>
        <translation>&amp;Live: Tasten spielen Blöcke sofort</translation>
    </message>
    <message>
        <source>Live: block %1</source>
        <translation>Live: Block %1</translation>
    </message>
    <message>
        <source>Back to the sequence</source>
        <translation>Zurück zur Sequenz</translation>
    </message>
    <message>
        <source>The playhead is not inside the chosen block.</source>
        <translation>Der Abspielkopf ist nicht im gewählten Block.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>%1 trimmen</translation>
    </message>
    <message>
        <source>&amp;Add the chosen action</source>
        <translation>Gewählte Aktion &amp;hinzufügen</translation>
    </message>
    <message>
        <source>S&amp;wap the block for the chosen action</source>
        <translation>&amp;Block gegen gewählte Aktion tauschen</translation>
    </message>
    <message>
        <source>&amp;Remove the block</source>
        <translation>Block &amp;entfernen</translation>
    </message>
    <message>
        <source>Block before</source>
        <translation>Voriger Block</translation>
    </message>
    <message>
        <source>Block after</source>
        <translation>Nächster Block</translation>
    </message>
    <message>
        <source>Move the block &amp;earlier</source>
        <translation>Block &amp;früher</translation>
    </message>
    <message>
        <source>Move the &amp;block later</source>
        <translation>Block &amp;später</translation>
    </message>
    <message>
        <source>Once &amp;more</source>
        <translation>Einmal &amp;mehr</translation>
    </message>
    <message>
        <source>Repeat the block</source>
        <translation>Block wiederholen</translation>
    </message>
    <message>
        <source>Once less</source>
        <translation>Einmal weniger</translation>
    </message>
    <message>
        <source>Repeat the block less</source>
        <translation>Block seltener wiederholen</translation>
    </message>
    <message>
        <source>Block begins at the playhead</source>
        <translation>Block beginnt am Abspielkopf</translation>
    </message>
    <message>
        <source>Block ends at the playhead</source>
        <translation>Block endet am Abspielkopf</translation>
    </message>
    <message>
        <source>The whole action again</source>
        <translation>Wieder die ganze Aktion</translation>
    </message>
    <message>
        <source>Trim nothing</source>
        <translation>Nichts trimmen</translation>
    </message>
    <message>
        <source>&amp;Draw the transition anew</source>
        <translation>Übergang &amp;neu ziehen</translation>
    </message>
    <message>
        <source>Draw all that are not locked anew</source>
        <translation>Alle nicht gesperrten neu ziehen</translation>
    </message>
    <message>
        <source>Loc&amp;k the transition, or let it go</source>
        <translation>Übergang s&amp;perren oder freigeben</translation>
    </message>
    <message>
        <source>Unlock the transition</source>
        <translation>Übergang freigeben</translation>
    </message>
    <message>
        <source>Lock the transition</source>
        <translation>Übergang sperren</translation>
    </message>
    <message>
        <source>Clear the sequence</source>
        <translation>Sequenz leeren</translation>
    </message>
    <message>
        <source>&amp;Find an action</source>
        <translation>Aktion su&amp;chen</translation>
    </message>
    <message>
        <source>Show all of it</source>
        <translation>Ganz zeigen</translation>
    </message>
    <message>
        <source>Map of po&amp;ses</source>
        <translation>Posen&amp;karte</translation>
    </message>
    <message>
        <source>Add &amp;clips of files…</source>
        <translation>Clips aus &amp;Dateien hinzufügen…</translation>
    </message>
    <message>
        <source>Add cl&amp;ips of a folder…</source>
        <translation>Clips eines &amp;Ordners hinzufügen…</translation>
    </message>
    <message>
        <source>Keep as a &amp;take…</source>
        <translation>Als &amp;Take behalten…</translation>
    </message>
    <message>
        <source>E&amp;xport the sequence…</source>
        <translation>Sequenz e&amp;xportieren…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequencePanel</name>
    <message>
        <source>What appears here</source>
        <translation>Was hier erscheint</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Aktionen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Aktionen suchen</translation>
    </message>
    <message>
        <source>Shows the actions in which every word appears: right kick</source>
        <translation>Zeigt die Aktionen, in denen jedes Wort vorkommt: Tritt rechts</translation>
    </message>
    <message>
        <source>Actions to choose from</source>
        <translation>Aktionen zur Auswahl</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>Clips…</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>Behalten…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Actions of the takes, and clips of other files, in any order, led over to each other: they appear here.</source>
        <translation>Aktionen der Takes und Clips anderer Dateien, in beliebiger Folge, ineinander übergeleitet: Sie erscheinen hier.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceSession</name>
    <message>
        <source>Preparing the clips</source>
        <translation>Clips werden vorbereitet</translation>
    </message>
    <message>
        <source>Making the motion</source>
        <translation>Bewegung wird erzeugt</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Swap for %1</source>
        <translation>Gegen %1 tauschen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Clear the sequence</source>
        <translation>Sequenz leeren</translation>
    </message>
    <message>
        <source>Draw the transition anew</source>
        <translation>Übergang neu ziehen</translation>
    </message>
    <message>
        <source>Draw all anew</source>
        <translation>Alle neu ziehen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceStrip</name>
    <message>
        <source>Blocks of the sequence</source>
        <translation>Blöcke der Sequenz</translation>
    </message>
    <message>
        <source>  (%1 of %2)</source>
        <translation>  (%1 von %2)</translation>
    </message>
    <message>
        <source>Actions in the order in which they shall be played. Choose one at the right and press Return to add it.</source>
        <translation>Aktionen in der Reihenfolge, in der sie gespielt werden sollen. Wählen Sie rechts eine, und drücken Sie Eingabe, um sie hinzuzufügen.</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>Die Bewegung wird erzeugt.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>%1 trimmen</translation>
    </message>
    <message>
        <source>Drag to trim</source>
        <translation>Ziehen zum Trimmen</translation>
    </message>
    <message>
        <source>transition to %1 · %2 to %3</source>
        <translation>Übergang zu %1 · %2 bis %3</translation>
    </message>
    <message>
        <source>%1 · %2 to %3</source>
        <translation>%1 · %2 bis %3</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Session</name>
    <message>
        <source>The edit that waited was dropped: another take is shown.</source>
        <translation>Die wartende Änderung wurde verworfen: Ein anderer Take wird gezeigt.</translation>
    </message>
    <message>
        <source>The edit waits until the force curves are computed.</source>
        <translation>Die Änderung wartet, bis die Kraftkurven berechnet sind.</translation>
    </message>
    <message>
        <source>No boundary of %1 lies within 0.1 s of the playhead.</source>
        <translation>Keine Grenze von %1 liegt näher als 0,1 s am Abspielkopf.</translation>
    </message>
    <message>
        <source>This is the first action: nothing comes before it.</source>
        <translation>Das ist die erste Aktion: Davor kommt nichts.</translation>
    </message>
    <message>
        <source>This is the last action: nothing comes after it.</source>
        <translation>Das ist die letzte Aktion: Danach kommt nichts.</translation>
    </message>
    <message>
        <source>A removed boundary does not move. Del restores it.</source>
        <translation>Eine entfernte Grenze lässt sich nicht verschieben. Entf stellt sie wieder her.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SettingsFields</name>
    <message>
        <source>Cutoff of the low-pass in Hz</source>
        <translation>Grenzfrequenz des Tiefpasses in Hz</translation>
    </message>
    <message>
        <source>Low-pass over the centre of mass: lower gives smoother curves and fewer minima.</source>
        <translation>Tiefpass über den Schwerpunkt: Niedriger gibt glattere Kurven und weniger Minima.</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>Least prominence in body weights</source>
        <translation>Kleinste Prominenz in Körpergewichten</translation>
    </message>
    <message>
        <source>A minimum must be at least this deep to be a boundary.</source>
        <translation>Ein Minimum muss mindestens so tief sein, um eine Grenze zu sein.</translation>
    </message>
    <message>
        <source> BW</source>
        <translation> BW</translation>
    </message>
    <message>
        <source>Cutoff</source>
        <translation>Grenzfreq.</translation>
    </message>
    <message>
        <source>Promin.</source>
        <translation>Promin.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>length of the force</source>
        <translation>Betrag der Kraft</translation>
    </message>
    <message>
        <source>vertical part</source>
        <translation>senkrechter Teil</translation>
    </message>
    <message>
        <source>Curve that is cut at its minima</source>
        <translation>Kurve, die an ihren Minima geschnitten wird</translation>
    </message>
    <message>
        <source>Which curve is cut at its minima: the length of the contact force or its vertical part.</source>
        <translation>Welche Kurve an ihren Minima geschnitten wird: der Betrag der Kontaktkraft oder ihr senkrechter Teil.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SimilarBox</name>
    <message>
        <source>this one, %1</source>
        <translation>diese, %1</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
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
        <translation>Beide</translation>
    </message>
    <message>
        <source>Nearest by the numbers from which the machine learns; ⇄: its mirror image is near, and it is seen from the other side. All begin and end together.</source>
        <translation>Die nächsten nach den Zahlen, aus denen die Maschine lernt; ⇄: Ihr Spiegelbild ist nah, und sie ist von der anderen Seite zu sehen. Alle beginnen und enden gemeinsam.</translation>
    </message>
    <message>
        <source>The chosen ones get the label of the first one, said by a hand, as one step of the history. A click or Space chooses, a double click or Enter goes there.</source>
        <translation>Die gewählten bekommen das Label der ersten, wie von Hand gesagt, als ein Schritt des Verlaufs. Ein Klick oder die Leertaste wählt, ein Doppelklick oder Eingabe geht dorthin.</translation>
    </message>
    <message>
        <source>Show both fighters: the opponent, too</source>
        <translation>Beide Kämpfer zeigen: auch den Gegner</translation>
    </message>
    <message>
        <source>Comparing actions</source>
        <translation>Aktionen werden verglichen</translation>
    </message>
    <message>
        <source>The actions most like the current one.</source>
        <translation>Die Aktionen, die der aktuellen am ähnlichsten sind.</translation>
    </message>
    <message>
        <source>The actions most like the current one appear here, once there is an action at the playhead.</source>
        <translation>Die Aktionen, die der aktuellen am ähnlichsten sind, erscheinen hier, sobald am Abspielkopf eine Aktion ist.</translation>
    </message>
    <message>
        <source>Same label for all</source>
        <translation>Gleiches Label für alle</translation>
    </message>
    <message>
        <source>Same label for %1</source>
        <translation>Gleiches Label für %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageCommands</name>
    <message>
        <source>Save a picture of the 3D view</source>
        <translation>Bild der 3D-Ansicht speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Picture of the 3D view</source>
        <translation>Bild der 3D-Ansicht</translation>
    </message>
    <message>
        <source>%1: the picture cannot be written there.</source>
        <translation>%1: Das Bild kann dort nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>3&amp;D view</source>
        <translation>&amp;3D-Ansicht</translation>
    </message>
    <message>
        <source>From the f&amp;ront</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>From the &amp;side</source>
        <translation>Von der &amp;Seite</translation>
    </message>
    <message>
        <source>From a&amp;bove</source>
        <translation>Von &amp;oben</translation>
    </message>
    <message>
        <source>Over the shoulder of fighter 1</source>
        <translation>Über die Schulter von Kämpfer 1</translation>
    </message>
    <message>
        <source>Over the shoulder of fighter 2</source>
        <translation>Über die Schulter von Kämpfer 2</translation>
    </message>
    <message>
        <source>&amp;Follow the fighters</source>
        <translation>Kämpfern &amp;folgen</translation>
    </message>
    <message>
        <source>Foot &amp;contacts</source>
        <translation>Fuß&amp;kontakte</translation>
    </message>
    <message>
        <source>&amp;Trails of hands and feet</source>
        <translation>&amp;Bahnen von Händen und Füßen</translation>
    </message>
    <message>
        <source>Centre of &amp;mass</source>
        <translation>Sch&amp;werpunkt</translation>
    </message>
    <message>
        <source>Contact f&amp;orce</source>
        <translation>Kon&amp;taktkraft</translation>
    </message>
    <message>
        <source>&amp;Ghosts</source>
        <translation>&amp;Geisterbilder</translation>
    </message>
    <message>
        <source>Longer trails</source>
        <translation>Längere Bahnen</translation>
    </message>
    <message>
        <source>Shorter trails</source>
        <translation>Kürzere Bahnen</translation>
    </message>
    <message>
        <source>&amp;Leave a ghost here</source>
        <translation>Hier ein Geisterbild &amp;hinterlassen</translation>
    </message>
    <message>
        <source>Remove all ghosts</source>
        <translation>Alle Geisterbilder entfernen</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Measure: next joint</source>
        <translation>Messen: nächstes Gelenk</translation>
    </message>
    <message>
        <source>Measure: joint before</source>
        <translation>Messen: voriges Gelenk</translation>
    </message>
    <message>
        <source>Measure from, then to this joint</source>
        <translation>Von, dann bis zu diesem Gelenk messen</translation>
    </message>
    <message>
        <source>Leave measuring</source>
        <translation>Messen beenden</translation>
    </message>
    <message>
        <source>Co&amp;py a picture</source>
        <translation>Bild ko&amp;pieren</translation>
    </message>
    <message>
        <source>Save a p&amp;icture…</source>
        <translation>Bild spei&amp;chern…</translation>
    </message>
    <message>
        <source>Click two joints; or %1 and %2 lead to a joint, %3 takes it</source>
        <translation>Klicken Sie zwei Gelenke an; oder %1 und %2 führen zu einem Gelenk, %3 nimmt es</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageTools</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Where the camera stands</source>
        <translation>Wo die Kamera steht</translation>
    </message>
    <message>
        <source>Shown in 3D</source>
        <translation>In 3D gezeigt</translation>
    </message>
    <message>
        <source>What the 3D view shows</source>
        <translation>Was die 3D-Ansicht zeigt</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Trails, frames</source>
        <translation>Bahnen, Frames</translation>
    </message>
    <message>
        <source>Frames of trail before the shown one</source>
        <translation>Frames der Bahn vor dem gezeigten</translation>
    </message>
    <message>
        <source>Frames of trail after the shown one</source>
        <translation>Frames der Bahn nach dem gezeigten</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageView</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>The fighters at the playhead: a drag turns, the wheel zooms</source>
        <translation>Die Kämpfer am Abspielkopf: Ziehen dreht, das Rad zoomt</translation>
    </message>
    <message>
        <source>before the action</source>
        <translation>vor der Aktion</translation>
    </message>
    <message>
        <source>after the action</source>
        <translation>nach der Aktion</translation>
    </message>
    <message>
        <source>grid 1 m</source>
        <translation>Raster 1 m</translation>
    </message>
    <message>
        <source>   ·   left limbs lighter</source>
        <translation>   ·   linke Gliedmaßen heller</translation>
    </message>
    <message>
        <source>   ·   arrow: contact force, 0.5 m per BW</source>
        <translation>   ·   Pfeil: Kontaktkraft, 0,5 m je BW</translation>
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
        <translation>%1 von %2 bis %3</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>No joint is chosen. %1</source>
        <translation>Kein Gelenk ist gewählt. %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StatisticsBox</name>
    <message>
        <source>actions</source>
        <translation>Aktionen</translation>
    </message>
    <message>
        <source>Actions that the stream is cut into</source>
        <translation>Aktionen, in die der Strom geschnitten ist</translation>
    </message>
    <message>
        <source>min/s</source>
        <translation>Min./s</translation>
    </message>
    <message>
        <source>Minima a second that cut by themselves</source>
        <translation>Minima pro Sekunde, die von selbst schneiden</translation>
    </message>
    <message>
        <source>corr.</source>
        <translation>korr.</translation>
    </message>
    <message>
        <source>Share of boundaries that a hand removed, moved or added</source>
        <translation>Anteil der Grenzen, die von Hand entfernt, verschoben oder hinzugefügt wurden</translation>
    </message>
    <message>
        <source>left</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>Suspects that nobody has decided yet. Every decision teaches what is suspect, so that others may be cleared, too</source>
        <translation>Verdachtsfälle, die noch niemand entschieden hat. Jede Entscheidung lehrt, was verdächtig ist, sodass auch andere entlastet werden können</translation>
    </message>
    <message>
        <source>take</source>
        <translation>Take</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SurpriseStrip</name>
    <message>
        <source>Surprise of the transitions</source>
        <translation>Überraschung der Übergänge</translation>
    </message>
    <message>
        <source>Both terms</source>
        <translation>Beide Terme</translation>
    </message>
    <message>
        <source>−log P(next | own, opponent, motion): seen how it moves, another label was likelier. Finds labels that are wrong.</source>
        <translation>−log P(nächstes | eigenes, Gegner, Bewegung): So wie es sich bewegt, war ein anderes Label wahrscheinlicher. Findet falsche Labels.</translation>
    </message>
    <message>
        <source>Label term alone</source>
        <translation>Nur Label-Term</translation>
    </message>
    <message>
        <source>−log P(next | own, opponent): a label that seldom follows. Finds rare decisions.</source>
        <translation>−log P(nächstes | eigenes, Gegner): ein Label, das selten folgt. Findet seltene Entscheidungen.</translation>
    </message>
    <message>
        <source>Geometry term alone</source>
        <translation>Nur Geometrie-Term</translation>
    </message>
    <message>
        <source>−log density of places, facing and poses under the label, from its mean: no probability. Finds odd poses and places.</source>
        <translation>−log Dichte von Orten, Ausrichtung und Posen unter dem Label, ab ihrem Mittel: keine Wahrscheinlichkeit. Findet seltsame Posen und Orte.</translation>
    </message>
    <message>
        <source>How unexpected each transition was to a model that had not seen it, in nats.
%1</source>
        <translation>Wie unerwartet jeder Übergang für ein Modell war, das ihn nicht gesehen hatte, in Nats.
%1</translation>
    </message>
    <message>
        <source>Which surprise is shown</source>
        <translation>Welche Überraschung gezeigt wird</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>Überraschung</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 → %4 while %5   ·   %6</source>
        <translation>%1 · %2 · %3 → %4, Gegner: %5   ·   %6</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SuspectsModel</name>
    <message>
        <source>, removed</source>
        <translation>, entfernt</translation>
    </message>
    <message>
        <source>, accepted</source>
        <translation>, angenommen</translation>
    </message>
    <message>
        <source>, set by hand</source>
        <translation>, von Hand gesetzt</translation>
    </message>
    <message>
        <source>%1, suspicion %2: %3</source>
        <translation>%1, Verdacht %2: %3</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>What speaks against the minimum, and how deep it is</source>
        <translation>Was gegen das Minimum spricht und wie tief es ist</translation>
    </message>
    <message>
        <source>How likely the minimum is spurious, learnt from what hands removed and accepted; ✓ accepted or set by hand, × removed</source>
        <translation>Wie wahrscheinlich das Minimum unecht ist, gelernt aus dem, was von Hand entfernt und angenommen wurde; ✓ angenommen oder von Hand gesetzt, × entfernt</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>why</source>
        <translation>warum</translation>
    </message>
    <message>
        <source>susp.</source>
        <translation>Verd.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TakesList</name>
    <message>
        <source>%1
Double-click or F2 renames, Alt+↑ ↓ or a drag moves it.</source>
        <translation>%1
Doppelklick oder F2 benennt um, Alt+↑ ↓ oder Ziehen verschiebt.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TimelineView</name>
    <message>
        <source>time, frame</source>
        <translation>Zeit, Frame</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>Release to move the boundary here, Esc to leave it, Ctrl or Alt to place it freely.</source>
        <translation>Loslassen verschiebt die Grenze hierher, Esc lässt sie, Strg oder Alt setzt sie frei.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Force curves of the fighters, the boundaries that cut them, and the actions between</source>
        <translation>Kraftkurven der Kämpfer, die Grenzen, die sie schneiden, und die Aktionen dazwischen</translation>
    </message>
    <message>
        <source>Preparing curves</source>
        <translation>Kurven werden vorbereitet</translation>
    </message>
    <message>
        <source>%1 · frame %2</source>
        <translation>%1 · Frame %2</translation>
    </message>
    <message>
        <source>%1 · %2 · frame %3</source>
        <translation>%1 · %2 · Frame %3</translation>
    </message>
    <message>
        <source> · action %1</source>
        <translation> · Aktion %1</translation>
    </message>
    <message>
        <source> · note: %1</source>
        <translation> · Notiz: %1</translation>
    </message>
    <message>
        <source> · removed boundary</source>
        <translation> · entfernte Grenze</translation>
    </message>
    <message>
        <source> · accepted boundary</source>
        <translation> · angenommene Grenze</translation>
    </message>
    <message>
        <source> · moved boundary</source>
        <translation> · verschobene Grenze</translation>
    </message>
    <message>
        <source> · added boundary</source>
        <translation> · hinzugefügte Grenze</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Tour</name>
    <message>
        <source>&amp;Tour on the demo bout</source>
        <translation>&amp;Rundgang durch den Demo-Kampf</translation>
    </message>
    <message>
        <source>Tour: next step</source>
        <translation>Rundgang: nächster Schritt</translation>
    </message>
    <message>
        <source>Tour: step before</source>
        <translation>Rundgang: voriger Schritt</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Rundgang verlassen</translation>
    </message>
    <message>
        <source>Correct a suspect</source>
        <translation>Einen Verdachtsfall berichtigen</translation>
    </message>
    <message>
        <source>Label an action</source>
        <translation>Eine Aktion labeln</translation>
    </message>
    <message>
        <source>%1 leads to the action that says most; it loops. Say what it is: %2 is a left punch forward, %3 a right one; the palette shows the other keys.</source>
        <translation>%1 führt zur Aktion, die am meisten aussagt; sie läuft in Schleife. Sagen Sie, was sie ist: %2 ist ein linker Schlag nach vorn, %3 ein rechter; die Palette zeigt die anderen Tasten.</translation>
    </message>
    <message>
        <source>Let the machine say the rest</source>
        <translation>Die Maschine den Rest sagen lassen</translation>
    </message>
    <message>
        <source>A machine learns from your labels. One is few: here a third of the bout can be labelled for you. Then %1 accepts all that the machine is sure of; %2 takes it back.</source>
        <translation>Eine Maschine lernt aus Ihren Labels. Eines ist wenig: Hier lässt sich ein Drittel des Kampfs für Sie labeln. Dann nimmt %1 alles an, worin die Maschine sicher ist; %2 nimmt es zurück.</translation>
    </message>
    <message>
        <source>Label a third for me</source>
        <translation>Ein Drittel für mich labeln</translation>
    </message>
    <message>
        <source>See what follows what</source>
        <translation>Sehen, was worauf folgt</translation>
    </message>
    <message>
        <source>A row is what goes on, a column what comes next. Click a cell: the moments behind it are listed, a click plays one. %1 leads to the most surprising moment.</source>
        <translation>Eine Zeile ist, was gerade läuft, eine Spalte, was als Nächstes kommt. Klicken Sie eine Zelle an: Die Momente dahinter werden aufgelistet, ein Klick spielt einen ab. %1 führt zum überraschendsten Moment.</translation>
    </message>
    <message>
        <source>Let them fight on</source>
        <translation>Sie weiterkämpfen lassen</translation>
    </message>
    <message>
        <source>%1 starts a bout that was never fought, made from what was learnt. Every choice stands at the right; a click takes another one. Back with %2, on otherwise with %3.</source>
        <translation>%1 startet einen Kampf, der nie stattfand, aus dem Gelernten erzeugt. Jede Wahl steht rechts; ein Klick nimmt eine andere. Zurück mit %2, anders weiter mit %3.</translation>
    </message>
    <message>
        <source>The minima of the force cut the bout into actions; a few are wrong. %1 leads to the likeliest, plays it and says why; %2 stops. %3 keeps it, %4 removes it.</source>
        <translation>Die Minima der Kraft schneiden den Kampf in Aktionen; einige sind falsch. %1 führt zum verdächtigsten, spielt es ab und sagt, warum; %2 hält an. %3 behält es, %4 entfernt es.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TourBox</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ Fertig</translation>
    </message>
    <message>
        <source>This step is done</source>
        <translation>Dieser Schritt ist fertig</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
    <message>
        <source>Tour, step %1</source>
        <translation>Rundgang, Schritt %1</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Abschließen</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TraceBox</name>
    <message>
        <source>Behind it</source>
        <translation>Dahinter</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>Was ausgewählt ist</translation>
    </message>
    <message>
        <source>Transitions behind it</source>
        <translation>Übergänge dahinter</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>Überraschung</translation>
    </message>
    <message>
        <source>Choose a cell, a node, an edge or a row above: the moments behind it appear here, and a click plays them.</source>
        <translation>Wählen Sie oben eine Zelle, einen Knoten, eine Kante oder eine Zeile: Die Momente dahinter erscheinen hier, und ein Klick spielt sie ab.</translation>
    </message>
    <message>
        <source>%1. Never seen.</source>
        <translation>%1. Nie gesehen.</translation>
    </message>
    <message>
        <source>%1. Seen once.</source>
        <translation>%1. Einmal gesehen.</translation>
    </message>
    <message>
        <source>%1. Seen %2 times.</source>
        <translation>%1. %2 Mal gesehen.</translation>
    </message>
    <message>
        <source>%1. Never seen so; these share the own label.</source>
        <translation>%1. So nie gesehen; diese haben dasselbe eigene Label.</translation>
    </message>
    <message>
        <source>%1. Never seen so; these share the opponent&apos;s label.</source>
        <translation>%1. So nie gesehen; diese haben dasselbe Label des Gegners.</translation>
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
Ein Klick spielt es ab</translation>
    </message>
    <message>
        <source>Surprise (%1), nats: how unexpected it was to a model that had not seen it</source>
        <translation>Überraschung (%1), Nats: wie unerwartet es für ein Modell war, das es nicht gesehen hatte</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>own → next</source>
        <translation>eigenes → nächstes</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>Überraschung</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TrackPainter</name>
    <message>
        <source>The recording of %1 is missing. File ▸ Find recording… points to it.</source>
        <translation>Die Aufnahme von %1 fehlt. Datei ▸ Aufnahme suchen… zeigt, wo sie ist.</translation>
    </message>
    <message>
        <source>No contact force: this skeleton has no body that is known here. S adds boundaries by hand.</source>
        <translation>Keine Kontaktkraft: Dieses Skelett hat keinen hier bekannten Körper. S fügt Grenzen von Hand hinzu.</translation>
    </message>
    <message>
        <source>force, BW</source>
        <translation>Kraft, BW</translation>
    </message>
    <message>
        <source>unsmoothed</source>
        <translation>ungeglättet</translation>
    </message>
    <message>
        <source>COM, m</source>
        <translation>Schwerpunkt, m</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>hands, m/s</source>
        <translation>Hände, m/s</translation>
    </message>
    <message>
        <source>feet, m/s</source>
        <translation>Füße, m/s</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TransitionBox</name>
    <message>
        <source>Transition</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>The transition</source>
        <translation>Der Übergang</translation>
    </message>
    <message>
        <source>Ways that the transition can go</source>
        <translation>Wege, die der Übergang nehmen kann</translation>
    </message>
    <message>
        <source>A click, or Return, takes another way</source>
        <translation>Ein Klick oder Eingabe nimmt einen anderen Weg</translation>
    </message>
    <message>
        <source>Choose a block, or the transition before it.</source>
        <translation>Wählen Sie einen Block oder den Übergang davor.</translation>
    </message>
    <message>
        <source>The first block begins where it was recorded.</source>
        <translation>Der erste Block beginnt, wo er aufgenommen wurde.</translation>
    </message>
    <message>
        <source>There is no transition.</source>
        <translation>Es gibt keinen Übergang.</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>Die Bewegung wird erzeugt.</translation>
    </message>
    <message>
        <source>straight from pose to pose</source>
        <translation>gerade von Pose zu Pose</translation>
    </message>
    <message>
        <source>on a curve</source>
        <translation>auf einer Kurve</translation>
    </message>
    <message>
        <source>along recorded clips past %1 poses</source>
        <translation>entlang aufgenommener Clips über %1 Posen</translation>
    </message>
    <message>
        <source>between poses that are alike</source>
        <translation>zwischen Posen, die sich ähneln</translation>
    </message>
    <message>
        <source>To %1: %2 s, %3%4</source>
        <translation>Zu %1: %2 s, %3%4</translation>
    </message>
    <message>
        <source>. Locked.</source>
        <translation>. Gesperrt.</translation>
    </message>
    <message>
        <source>drawn by cost</source>
        <translation>nach Kosten gezogen</translation>
    </message>
    <message>
        <source>path %1 · they meet as they are</source>
        <translation>Weg %1 · sie treffen sich, wie sie sind</translation>
    </message>
    <message>
        <source>path %1 · cost %2 · clips: %3</source>
        <translation>Weg %1 · Kosten %2 · Clips: %3</translation>
    </message>
    <message>
        <source>curve (Bézier)</source>
        <translation>Kurve (Bézier)</translation>
    </message>
    <message>
        <source>straight, for comparison</source>
        <translation>gerade, zum Vergleich</translation>
    </message>
    <message>
        <source>Take another transition</source>
        <translation>Anderen Übergang nehmen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TransportBar</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Frame %1</translation>
    </message>
    <message>
        <source>Playback speed: - slower, + faster</source>
        <translation>Wiedergabetempo: - langsamer, + schneller</translation>
    </message>
    <message>
        <source>Rows ▾</source>
        <translation>Zeilen ▾</translation>
    </message>
    <message>
        <source>Rows of the timeline</source>
        <translation>Zeilen der Zeitleiste</translation>
    </message>
    <message>
        <source>What the timeline shows: curves, speeds, units of the ruler</source>
        <translation>Was die Zeitleiste zeigt: Kurven, Geschwindigkeiten, Einheiten des Lineals</translation>
    </message>
    <message>
        <source>selected: boundary of %1 at %2</source>
        <translation>ausgewählt: Grenze von %1 bei %2</translation>
    </message>
    <message>
        <source>selected: action of %1, %2 to %3</source>
        <translation>ausgewählt: Aktion von %1, %2 bis %3</translation>
    </message>
    <message>
        <source>active: %1</source>
        <translation>aktiv: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::UnmatchedBox</name>
    <message>
        <source>Put boundary</source>
        <translation>Grenze setzen</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Corrections without a minimum</source>
        <translation>Korrekturen ohne Minimum</translation>
    </message>
    <message>
        <source>With the present settings these corrections mean nothing any more.</source>
        <translation>Mit den jetzigen Einstellungen bewirken diese Korrekturen nichts mehr.</translation>
    </message>
    <message>
        <source>Put a boundary by hand where the correction had one</source>
        <translation>Dort von Hand eine Grenze setzen, wo die Korrektur eine hatte</translation>
    </message>
    <message>
        <source>Drop the correction from the project</source>
        <translation>Die Korrektur aus dem Projekt streichen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::VersionsDialog</name>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Kopie öffnen</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>Versions, the newest first</source>
        <translation>Versionen, die neuesten zuerst</translation>
    </message>
    <message>
        <source>States that were saved over; a double-click restores one</source>
        <translation>Überschriebene Stände; ein Doppelklick stellt einen wieder her</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Takes</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Korrekturen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Open the chosen version as a project without a file</source>
        <translation>Die gewählte Version als Projekt ohne Datei öffnen</translation>
    </message>
    <message>
        <source>Make the chosen version the open project; undo takes it back (Enter)</source>
        <translation>Die gewählte Version zum offenen Projekt machen; Rückgängig nimmt es zurück (Eingabe)</translation>
    </message>
    <message>
        <source>Leave everything as it is (Esc)</source>
        <translation>Alles lassen, wie es ist (Esc)</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Wird gesucht…</translation>
    </message>
    <message>
        <source>Reading versions</source>
        <translation>Versionen werden gelesen</translation>
    </message>
    <message>
        <source>No earlier version yet. Every save keeps what the file held before; the last ten are listed here.</source>
        <translation>Noch keine frühere Version. Jedes Speichern behält, was die Datei davor enthielt; die letzten zehn stehen hier.</translation>
    </message>
    <message>
        <source>What the project file held before each of the last saves. Restoring is an edit: undo takes it back, and the file changes only when you save.</source>
        <translation>Was die Projektdatei vor jedem der letzten Speichervorgänge enthielt. Wiederherstellen ist eine Änderung: Rückgängig nimmt sie zurück, und die Datei ändert sich erst, wenn Sie speichern.</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WelcomePage</name>
    <message>
        <source>Cut a recorded bout into actions: both fighters in 3D over the force that they exert against the ground. Its minima are the boundaries; you correct the few that are wrong. Then say what a few actions are, and the machine says it of the rest.</source>
        <translation>Einen aufgenommenen Kampf in Aktionen schneiden: beide Kämpfer in 3D über der Kraft, die sie auf den Boden ausüben. Ihre Minima sind die Grenzen; Sie berichtigen die wenigen falschen. Sagen Sie dann, was einige Aktionen sind, und die Maschine sagt es vom Rest.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Or drop recordings (BVH, or AMC with its ASF) or a project on this window.</source>
        <translation>Oder ziehen Sie Aufnahmen (BVH, oder AMC mit seinem ASF) oder ein Projekt in dieses Fenster.</translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Projects and recordings that you open appear here, with the day and the folder.</source>
        <translation>Projekte und Aufnahmen, die Sie öffnen, erscheinen hier, mit Tag und Ordner.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WelcomePicture</name>
    <message>
        <source>Two fighters over the curves of their contact force, which is cut into actions at its minima</source>
        <translation>Zwei Kämpfer über den Kurven ihrer Kontaktkraft, die an ihren Minima in Aktionen geschnitten ist</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>actions</source>
        <translation>Aktionen</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WhatIfBox</name>
    <message>
        <source>at playhead</source>
        <translation>am Abspielkopf</translation>
    </message>
    <message>
        <source>Both labels are those of the moment that is shown</source>
        <translation>Beide Labels sind die des gezeigten Moments</translation>
    </message>
    <message>
        <source>own</source>
        <translation>eigenes</translation>
    </message>
    <message>
        <source>What the fighter does now</source>
        <translation>Was der Kämpfer jetzt tut</translation>
    </message>
    <message>
        <source>opponent</source>
        <translation>Gegner</translation>
    </message>
    <message>
        <source>What the opponent does now</source>
        <translation>Was der Gegner jetzt tut</translation>
    </message>
    <message>
        <source>What comes next</source>
        <translation>Was als Nächstes kommt</translation>
    </message>
    <message>
        <source>What next?</source>
        <translation>Was dann?</translation>
    </message>
    <message>
        <source>What %1 may do next, the likeliest first</source>
        <translation>Was %1 als Nächstes tun könnte, das Wahrscheinlichste zuerst</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>beliebig</translation>
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
        <translation>Label %1</translation>
    </message>
    <message>
        <source>geom. %1</source>
        <translation>Geom. %1</translation>
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
        <translation>%1: P %2, Label-Term %3</translation>
    </message>
    <message>
        <source>, geometry term %1</source>
        <translation>, Geometrie-Term %1</translation>
    </message>
    <message>
        <source>
Seen %1 times with both labels, %2 with the own, %3 with the opponent&apos;s</source>
        <translation>
%1 Mal mit beiden Labels gesehen, %2 Mal mit dem eigenen, %3 Mal mit dem des Gegners</translation>
    </message>
    <message>
        <source>
This is what came next</source>
        <translation>
Das kam als Nächstes</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Words</name>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>prominence %1</source>
        <translation>Prominenz %1</translation>
    </message>
    <message>
        <source>slow left kick, %1</source>
        <translation>langsamer Tritt links, %1</translation>
    </message>
    <message>
        <source>slow right kick, %1</source>
        <translation>langsamer Tritt rechts, %1</translation>
    </message>
    <message>
        <source>left foot moves at %1 m/s, %2</source>
        <translation>linker Fuß bewegt sich mit %1 m/s, %2</translation>
    </message>
    <message>
        <source>right foot moves at %1 m/s, %2</source>
        <translation>rechter Fuß bewegt sich mit %1 m/s, %2</translation>
    </message>
    <message>
        <source>shallow, %1</source>
        <translation>flach, %1</translation>
    </message>
    <message>
        <source>%1 s from the next minimum, %2</source>
        <translation>%1 s vom nächsten Minimum, %2</translation>
    </message>
    <message>
        <source>hardly dips (to %1), %2</source>
        <translation>senkt sich kaum (auf %1), %2</translation>
    </message>
    <message>
        <source>nothing unusual, %1</source>
        <translation>nichts Ungewöhnliches, %1</translation>
    </message>
    <message>
        <source>left kick</source>
        <translation>Tritt links</translation>
    </message>
    <message>
        <source>right kick</source>
        <translation>Tritt rechts</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>linker Fuß</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>rechter Fuß</translation>
    </message>
    <message>
        <source>shallow</source>
        <translation>flach</translation>
    </message>
    <message>
        <source>crowded</source>
        <translation>gedrängt</translation>
    </message>
    <message>
        <source>hardly dips</source>
        <translation>senkt sich kaum</translation>
    </message>
    <message>
        <source>%1, suspicion %2</source>
        <translation>%1, Verdacht %2</translation>
    </message>
    <message>
        <source>removal at %1</source>
        <translation>Entfernung bei %1</translation>
    </message>
    <message>
        <source>addition at %1</source>
        <translation>Hinzufügung bei %1</translation>
    </message>
    <message>
        <source>move from %1 to %2</source>
        <translation>Verschiebung von %1 nach %2</translation>
    </message>
    <message>
        <source>acceptance at %1</source>
        <translation>Annahme bei %1</translation>
    </message>
    <message>
        <source>fighter %1</source>
        <translation>Kämpfer %1</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>heute %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>gestern %1</translation>
    </message>
    <message>
        <source>Computer %1, process %2, since %3.</source>
        <translation>Computer %1, Prozess %2, seit %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s)</source>
        <translation>
            <numerusform>%n Änderung</numerusform>
            <numerusform>%n Änderungen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::WorkspaceBar</name>
    <message>
        <source>Workspaces</source>
        <translation>Arbeitsbereiche</translation>
    </message>
    <message>
        <source>%1 workspace</source>
        <translation>Arbeitsbereich %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Workspaces</name>
    <message>
        <source>%1 workspace</source>
        <translation>Arbeitsbereich %1</translation>
    </message>
</context>
</TS>
