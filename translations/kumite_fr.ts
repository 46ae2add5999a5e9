<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Core</name>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>Reprendre des étiquettes</translation>
    </message>
    <message>
        <source>Take over labels of %1</source>
        <translation>Reprendre les étiquettes de %1</translation>
    </message>
    <message>
        <source>Remove boundary %1</source>
        <translation>Supprimer la limite %1</translation>
    </message>
    <message>
        <source>Restore boundary %1</source>
        <translation>Rétablir la limite %1</translation>
    </message>
    <message>
        <source>Add boundary %1</source>
        <translation>Ajouter la limite %1</translation>
    </message>
    <message>
        <source>Move boundary %1</source>
        <translation>Déplacer la limite %1</translation>
    </message>
    <message>
        <source>Accept boundary %1</source>
        <translation>Accepter la limite %1</translation>
    </message>
    <message>
        <source>Change segmentation settings</source>
        <translation>Changer les réglages de segmentation</translation>
    </message>
    <message>
        <source>Change body model to %1</source>
        <translation>Changer de modèle corporel&#xa0;: %1</translation>
    </message>
    <message>
        <source>Restore the version of %1</source>
        <translation>Restaurer la version de %1</translation>
    </message>
    <message>
        <source>Add clips</source>
        <translation>Ajouter des clips</translation>
    </message>
    <message>
        <source>Remove clips</source>
        <translation>Supprimer des clips</translation>
    </message>
    <message>
        <source>Add take %1</source>
        <translation>Ajouter la prise %1</translation>
    </message>
    <message>
        <source>Remove take %1</source>
        <translation>Supprimer la prise %1</translation>
    </message>
    <message>
        <source>Rename take to %1</source>
        <translation>Renommer la prise en %1</translation>
    </message>
    <message>
        <source>Move take %1 to place %2</source>
        <translation>Déplacer la prise %1 à la place %2</translation>
    </message>
    <message>
        <source>Swap fighters</source>
        <translation>Échanger les combattants</translation>
    </message>
    <message>
        <source>Change time offset, fighter %1</source>
        <translation>Changer le décalage temporel, combattant %1</translation>
    </message>
    <message>
        <source>Change floor, fighter %1</source>
        <translation>Changer le sol, combattant %1</translation>
    </message>
    <message>
        <source>Change role %1, fighter %2</source>
        <translation>Changer le rôle %1, combattant %2</translation>
    </message>
    <message>
        <source>Relink recording, fighter %1</source>
        <translation>Relier l’enregistrement, combattant %1</translation>
    </message>
    <message>
        <source>Keep bout as take %1</source>
        <translation>Garder le combat comme prise %1</translation>
    </message>
    <message>
        <source>Keep motion as take %1</source>
        <translation>Garder le mouvement comme prise %1</translation>
    </message>
    <message>
        <source>Label action %1, fighter %2: %3</source>
        <translation>Étiqueter l’action %1, combattant %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Label action %1, fighter %2</source>
        <translation>Étiqueter l’action %1, combattant %2</translation>
    </message>
    <message>
        <source>Label %1 actions, fighter %2: %3</source>
        <translation>Étiqueter %1 actions, combattant %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Label %1 actions, fighter %2</source>
        <translation>Étiqueter %1 actions, combattant %2</translation>
    </message>
    <message>
        <source>Label %1 actions: %2</source>
        <translation>Étiqueter %1 actions&#xa0;: %2</translation>
    </message>
    <message>
        <source>Label %1 actions</source>
        <translation>Étiqueter %1 actions</translation>
    </message>
    <message>
        <source>Clear label, action %1, fighter %2</source>
        <translation>Effacer l’étiquette, action %1, combattant %2</translation>
    </message>
    <message>
        <source>Clear label, %1 actions, fighter %2</source>
        <translation>Effacer l’étiquette, %1 actions, combattant %2</translation>
    </message>
    <message>
        <source>Accept labels</source>
        <translation>Accepter les étiquettes</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>Importer des étiquettes</translation>
    </message>
    <message>
        <source>Merge labels</source>
        <translation>Fusionner les étiquettes</translation>
    </message>
    <message>
        <source>Change vocabulary to %1</source>
        <translation>Changer de vocabulaire&#xa0;: %1</translation>
    </message>
    <message>
        <source>Change rules</source>
        <translation>Changer les règles</translation>
    </message>
    <message>
        <source>Change learning settings</source>
        <translation>Changer les réglages d’apprentissage</translation>
    </message>
    <message>
        <source>Keep model</source>
        <translation>Garder le modèle</translation>
    </message>
    <message>
        <source>Remove note %1</source>
        <translation>Supprimer la note %1</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>Note %1</translation>
    </message>
    <message>
        <source>Accept what rules say</source>
        <translation>Accepter ce que disent les règles</translation>
    </message>
    <message>
        <source>Accept 1 label</source>
        <translation>Accepter 1 étiquette</translation>
    </message>
    <message>
        <source>Accept %1 labels</source>
        <translation>Accepter %1 étiquettes</translation>
    </message>
    <message>
        <source>at %1, fighter %2</source>
        <translation>à %1, combattant %2</translation>
    </message>
    <message>
        <source>A model of two fighters needs a take with two of them.</source>
        <translation>Un modèle de deux combattants demande une prise qui en a deux.</translation>
    </message>
    <message>
        <source>No action is labelled yet: label some by hand and let the machine do the rest, or import labels.</source>
        <translation>Aucune action n’est encore étiquetée : étiquetez-en quelques-unes à la main et laissez faire le reste à la machine, ou importez des étiquettes.</translation>
    </message>
    <message>
        <source>No transition has the labels of all its three actions: label more of both fighters.</source>
        <translation>Aucune transition n’a les étiquettes de ses trois actions : étiquetez-en davantage des deux combattants.</translation>
    </message>
    <message>
        <source>cannot be read: %1.</source>
        <translation>lecture impossible&#xa0;: %1.</translation>
    </message>
    <message>
        <source>cannot read: %1.</source>
        <translation>lecture impossible&#xa0;: %1.</translation>
    </message>
    <message>
        <source>cannot write: %1.</source>
        <translation>écriture impossible&#xa0;: %1.</translation>
    </message>
    <message>
        <source>cannot make this folder: %1.</source>
        <translation>impossible de créer ce dossier&#xa0;: %1.</translation>
    </message>
    <message>
        <source>is a folder, expected a file.</source>
        <translation>est un dossier, un fichier était attendu.</translation>
    </message>
    <message>
        <source>is no regular file; save it as one first.</source>
        <translation>n’est pas un fichier ordinaire&#xa0;; mettez-en d’abord le contenu dans un fichier.</translation>
    </message>
    <message>
        <source>is a folder, expected a file to write.</source>
        <translation>est un dossier, un fichier à écrire était attendu.</translation>
    </message>
    <message>
        <source>is what is read here; write to another file.</source>
        <translation>est justement ce qui est lu ici&#xa0;; écrivez dans un autre fichier.</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>ce fichier n’existe pas.</translation>
    </message>
    <message>
        <source>Every motion has too few frames for %1 key poses.</source>
        <translation>Tous les mouvements ont trop peu d’images pour %1 poses clés.</translation>
    </message>
    <message>
        <source>There is no frame of %1 to write.</source>
        <translation>Il n’y a aucune image de %1 à écrire.</translation>
    </message>
    <message>
        <source>The file holds %1 skeletons: %2. The first is read unless --root names another.</source>
        <translation>Le fichier contient %1 squelettes&#xa0;: %2. Le premier est lu, sauf si --root en nomme un autre.</translation>
    </message>
    <message>
        <source>found several skeletons beside it (%1), expected one (name it with --asf)</source>
        <translation>plusieurs squelettes à côté (%1), un seul était attendu (nommez-le avec --asf)</translation>
    </message>
    <message>
        <source>found %1, expected %2</source>
        <translation>trouvé&#xa0;: %1&#xa0;; attendu&#xa0;: %2</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>la fin du fichier</translation>
    </message>
    <message>
        <source>only the %1 channels that CHANNELS announces</source>
        <translation>seulement les %1 canaux qu’annonce CHANNELS</translation>
    </message>
    <message>
        <source>A split by takes needs two takes or more with labelled transitions.</source>
        <translation>Une répartition par prises demande au moins deux prises dont des transitions sont étiquetées.</translation>
    </message>
    <message>
        <source>There are too few labelled transitions to set some apart.</source>
        <translation>Il y a trop peu de transitions étiquetées pour en mettre de côté.</translation>
    </message>
    <message>
        <source>For labelling, these joints take their parents&apos; place: %1.</source>
        <translation>Pour l’étiquetage, ces articulations prennent la place de leur parent&#xa0;: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no aspect of the vocabulary %2.</source>
        <translation>«&#xa0;%1&#xa0;» ne nomme aucun aspect du vocabulaire %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no qualifier of %2.</source>
        <translation>«&#xa0;%1&#xa0;» ne nomme aucun qualificatif de %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names an aspect twice.</source>
        <translation>«&#xa0;%1&#xa0;» nomme deux fois un même aspect.</translation>
    </message>
    <message>
        <source>After %1 a confidence is expected, such as 0.6 or 60 %.</source>
        <translation>Après %1, une confiance est attendue, comme 0.6 ou 60&#xa0;%.</translation>
    </message>
    <message>
        <source>After %1 a confidence is expected, such as 0.6 or 60 %, not %2.</source>
        <translation>Après %1, une confiance est attendue, comme 0.6 ou 60&#xa0;%, et non %2.</translation>
    </message>
    <message>
        <source>Say whether the confidence is &quot;below %1&quot; or &quot;above %1&quot;.</source>
        <translation>Dites si la confiance est inférieure («&#xa0;below %1&#xa0;») ou supérieure («&#xa0;above %1&#xa0;»).</translation>
    </message>
    <message>
        <source>After %1 a time is expected, such as %2.</source>
        <translation>Après %1, un temps est attendu, comme %2.</translation>
    </message>
    <message>
        <source>After %1 a time is expected, such as %2, not %3.</source>
        <translation>Après %1, un temps est attendu, comme %2, et non %3.</translation>
    </message>
    <message>
        <source>After %1 two times are expected, such as 0:30 to 1:00.</source>
        <translation>Après %1, deux temps sont attendus, comme 0:30 to 1:00.</translation>
    </message>
    <message>
        <source>After %1 1 or 2 is expected.</source>
        <translation>Après %1, 1 ou 2 est attendu.</translation>
    </message>
    <message>
        <source>After %1 1 or 2 is expected, not %2.</source>
        <translation>Après %1, 1 ou 2 est attendu, et non %2.</translation>
    </message>
    <message>
        <source>There is no take %1; the takes are %2.</source>
        <translation>Il n’y a pas de prise %1&#xa0;; les prises sont %2.</translation>
    </message>
    <message>
        <source>Say which take; the takes are %1.</source>
        <translation>Dites quelle prise&#xa0;; les prises sont %1.</translation>
    </message>
    <message>
        <source>No aspect has a &quot;strike&quot;: %1 will never find anything to react to.</source>
        <translation>Aucun aspect n’a de «&#xa0;strike&#xa0;»&#xa0;: %1 ne trouvera jamais rien à quoi réagir.</translation>
    </message>
    <message>
        <source>The key %1 stands for both %2 and %3.</source>
        <translation>La touche %1 désigne à la fois %2 et %3.</translation>
    </message>
    <message>
        <source>In %1 the key %2 stands for both %3 and %4.</source>
        <translation>Dans %1, la touche %2 désigne à la fois %3 et %4.</translation>
    </message>
    <message>
        <source>The target has no %1: their turns go to the joints below them.</source>
        <translation>Il manque à la cible&#xa0;: %1. Leurs rotations passent aux articulations en dessous.</translation>
    </message>
    <message>
        <source>The source has no %1: they keep their rest relative to their parent.</source>
        <translation>Il manque à la source&#xa0;: %1. Ces articulations gardent leur pose de repos par rapport à leur parent.</translation>
    </message>
    <message>
        <source>No joint was found for: %1.</source>
        <translation>Aucune articulation trouvée pour&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Joint %1 does not stand behind its parent.</source>
        <translation>L’articulation %1 ne vient pas après son parent.</translation>
    </message>
    <message>
        <source>The channels of joint %1 do not follow the ones before.</source>
        <translation>Les canaux de l’articulation %1 ne font pas suite aux précédents.</translation>
    </message>
    <message>
        <source>The End Site %1 has channels.</source>
        <translation>Le End Site %1 a des canaux.</translation>
    </message>
    <message>
        <source>The offset of joint %1 is not a finite number.</source>
        <translation>Le décalage de l’articulation %1 n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>Frame 0 is a rest pose, not motion; takes leave it out.</source>
        <translation>L’image 0 est une pose de repos, pas un mouvement&#xa0;; les prises l’omettent.</translation>
    </message>
    <message>
        <source>Frames 0 to %1 are a rest pose, not motion; takes leave them out.</source>
        <translation>Les images 0 à %1 sont une pose de repos, pas un mouvement&#xa0;; les prises les omettent.</translation>
    </message>
    <message>
        <source>Fighter %1 has no boundary near frame %2.</source>
        <translation>Le combattant %1 n’a aucune limite près de l’image %2.</translation>
    </message>
    <message>
        <source>Fighter %1 has no boundary near frame %2; the nearest is at %3.</source>
        <translation>Le combattant %1 n’a aucune limite près de l’image %2&#xa0;; la plus proche est à l’image %3.</translation>
    </message>
    <message>
        <source>the recording is missing; its boundaries cannot be edited.</source>
        <translation>l’enregistrement manque&#xa0;; ses limites ne peuvent pas être modifiées.</translation>
    </message>
    <message>
        <source>A time offset must be a number.</source>
        <translation>Un décalage temporel doit être un nombre.</translation>
    </message>
    <message>
        <source>A placement must be a number.</source>
        <translation>Une place doit être donnée en nombres.</translation>
    </message>
    <message>
        <source>The floor&apos;s height must be a number.</source>
        <translation>La hauteur du sol doit être un nombre.</translation>
    </message>
    <message>
        <source>There is a take named &quot;%1&quot; already.</source>
        <translation>Il y a déjà une prise nommée «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>%1 has another skeleton: it is not the recording that is missing.</source>
        <translation>%1 a un autre squelette&#xa0;: ce n’est pas l’enregistrement qui manque.</translation>
    </message>
    <message>
        <source>the suffix says what to write, expected .bvh, .glb, .npz, .csv, .json or .eaf.</source>
        <translation>l’extension dit quoi écrire&#xa0;: .bvh, .glb, .npz, .csv, .json ou .eaf.</translation>
    </message>
    <message>
        <source>the recording is missing; the take cannot be written without it.</source>
        <translation>l’enregistrement manque&#xa0;; la prise ne peut pas être écrite sans lui.</translation>
    </message>
    <message>
        <source>a graph is written as .csv, .json or .graphml.</source>
        <translation>un graphe s’écrit en .csv, .json ou .graphml.</translation>
    </message>
    <message>
        <source>there is no joint named &quot;%1&quot;; there is: %2.</source>
        <translation>aucune articulation ne se nomme «&#xa0;%1&#xa0;»&#xa0;; il y a&#xa0;: %2.</translation>
    </message>
    <message>
        <source>the name holds bytes that are no UTF-8 text; rename the file or folder.</source>
        <translation>le nom contient des octets qui ne sont pas du texte UTF-8&#xa0;; renommez le fichier ou le dossier.</translation>
    </message>
    <message>
        <source>the key pose of clip &quot;%1&quot; is not in the project</source>
        <translation>la pose clé du clip «&#xa0;%1&#xa0;» n’est pas dans le projet</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no source.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une source.</translation>
    </message>
    <message>
        <source>labels are written as .csv, .json or .eaf.</source>
        <translation>les étiquettes s’écrivent en .csv, .json ou .eaf.</translation>
    </message>
    <message>
        <source>labels are read from .csv, .json and .eaf files.</source>
        <translation>les étiquettes se lisent dans des fichiers .csv, .json et .eaf.</translation>
    </message>
    <message>
        <source>the project has no take &quot;%1&quot;.</source>
        <translation>le projet n’a pas de prise «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>the take has no such fighter.</source>
        <translation>la prise n’a pas ce combattant.</translation>
    </message>
    <message>
        <source>no action there.</source>
        <translation>aucune action à cet endroit.</translation>
    </message>
    <message>
        <source>its action takes the label of %1.</source>
        <translation>son action reçoit l’étiquette de %1.</translation>
    </message>
    <message>
        <source>no joint has the role pelvis, so its actions cannot be compared.</source>
        <translation>aucune articulation n’a le rôle de bassin, ses actions ne peuvent donc pas être comparées.</translation>
    </message>
    <message>
        <source>the recording is missing; its actions cannot be labelled.</source>
        <translation>l’enregistrement manque&#xa0;; ses actions ne peuvent pas être étiquetées.</translation>
    </message>
    <message>
        <source>has no body with two legs; it is left out.</source>
        <translation>n’a pas de corps à deux jambes&#xa0;; il est laissé de côté.</translation>
    </message>
    <message>
        <source>%1 It is left out.</source>
        <translation>%1 Il est laissé de côté.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: expected frames as A:B after the @.</source>
        <translation>«&#xa0;%1&#xa0;»&#xa0;: après le @, des images sont attendues sous la forme A:B.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: these frames are not in it; it has %2 to %3.</source>
        <translation>«&#xa0;%1&#xa0;»&#xa0;: ces images n’y sont pas&#xa0;; il y a les images %2 à %3.</translation>
    </message>
    <message>
        <source>No action of the library is labelled &quot;%1&quot;.</source>
        <translation>Aucune action de la bibliothèque n’est étiquetée «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>No action of the library is labelled &quot;%1&quot; of that player.</source>
        <translation>Aucune action de ce combattant n’est étiquetée «&#xa0;%1&#xa0;» dans la bibliothèque.</translation>
    </message>
    <message>
        <source>None of these clips is of that player.</source>
        <translation>Aucun de ces clips n’est de ce combattant.</translation>
    </message>
    <message>
        <source>joint &quot;%1&quot; is gone; the role %2 has no joint now.</source>
        <translation>l’articulation «&#xa0;%1&#xa0;» a disparu&#xa0;; le rôle %2 n’a plus d’articulation.</translation>
    </message>
    <message>
        <source>%1 The recording is left out; its corrections are kept.</source>
        <translation>%1 L’enregistrement est laissé de côté&#xa0;; ses corrections sont gardées.</translation>
    </message>
    <message>
        <source>the recording is missing; put it back or relink it. Its corrections are kept.</source>
        <translation>l’enregistrement manque&#xa0;; remettez-le en place ou reliez-le. Ses corrections sont gardées.</translation>
    </message>
    <message>
        <source>the recording has changed since it became part of the project; check the boundaries, then relink it to accept the change.</source>
        <translation>l’enregistrement a changé depuis son entrée dans le projet&#xa0;; vérifiez les limites, puis reliez-le pour accepter le changement.</translation>
    </message>
    <message>
        <source>the recording is missing; the take cannot be shown without it.</source>
        <translation>l’enregistrement manque&#xa0;; la prise ne peut pas être affichée sans lui.</translation>
    </message>
    <message>
        <source>There is no take named &quot;%1&quot;; the project has none.</source>
        <translation>Aucune prise ne se nomme «&#xa0;%1&#xa0;»&#xa0;; le projet n’en a aucune.</translation>
    </message>
    <message>
        <source>There is no take named &quot;%1&quot;; there is: %2.</source>
        <translation>Aucune prise ne se nomme «&#xa0;%1&#xa0;»&#xa0;; il y a&#xa0;: %2.</translation>
    </message>
    <message>
        <source>no contact force without a body; no joint has the role %1.</source>
        <translation>pas de force de contact sans corps&#xa0;; aucune articulation n’a le rôle %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; of fighter %2 is no correction without a minimum.</source>
        <translation>«&#xa0;%1&#xa0;» du combattant %2 n’est pas une correction sans minimum.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; leaves no boundary that could be added.</source>
        <translation>«&#xa0;%1&#xa0;» ne laisse aucune limite à ajouter.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be reached: the nearest target that can is %2.</source>
        <translation>«&#xa0;%1&#xa0;» est hors d’atteinte&#xa0;: la cible la plus proche qu’on puisse atteindre est %2.</translation>
    </message>
    <message>
        <source>What was saved before could not be kept. %1</source>
        <translation>L’état enregistré précédemment n’a pas pu être gardé. %1</translation>
    </message>
    <message>
        <source>holds %1 frames only; the take ends there for this fighter.</source>
        <translation>ne contient que %1 images&#xa0;; la prise s’arrête là pour ce combattant.</translation>
    </message>
    <message>
        <source>holds %1 frames now, the take begins at frame %2; the recording is left out.</source>
        <translation>contient maintenant %1 images, or la prise commence à l’image %2&#xa0;; l’enregistrement est laissé de côté.</translation>
    </message>
    <message>
        <source>holds %1 frames now; the take ends there.</source>
        <translation>contient maintenant %1 images&#xa0;; la prise s’arrête là.</translation>
    </message>
    <message>
        <source>a cutoff of %1 Hz smooths nothing at %2 frames a second; choose one below %3 Hz.</source>
        <translation>une coupure de %1&#xa0;Hz ne lisse rien à %2 images par seconde&#xa0;; choisissez-la en dessous de %3&#xa0;Hz.</translation>
    </message>
    <message>
        <source>the annotation &quot;%1&quot; has no time and is left out.</source>
        <translation>l’annotation «&#xa0;%1&#xa0;» n’a pas de temps et est laissée de côté.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no action that can be asked for; there are %2, what they strike with, and ASPECT:QUALIFIER.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une action qu’on puisse demander&#xa0;; on peut demander %2, leur genre de frappe, ou ASPECT:QUALIFIER.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing.</source>
        <translation>«&#xa0;%1&#xa0;» manque.</translation>
    </message>
    <message>
        <source>expected a list.</source>
        <translation>une liste est attendue.</translation>
    </message>
    <message>
        <source>expected an object.</source>
        <translation>un objet est attendu.</translation>
    </message>
    <message>
        <source>expected a whole number.</source>
        <translation>un nombre entier est attendu.</translation>
    </message>
    <message>
        <source>expected a number.</source>
        <translation>un nombre est attendu.</translation>
    </message>
    <message>
        <source>expected a finite number.</source>
        <translation>un nombre fini est attendu.</translation>
    </message>
    <message>
        <source>expected a number above 0.</source>
        <translation>un nombre supérieur à 0 est attendu.</translation>
    </message>
    <message>
        <source>expected true or false.</source>
        <translation>true ou false est attendu.</translation>
    </message>
    <message>
        <source>expected text.</source>
        <translation>un texte est attendu.</translation>
    </message>
    <message>
        <source>expected 0 or more.</source>
        <translation>un nombre supérieur ou égal à 0 est attendu.</translation>
    </message>
    <message>
        <source>expected [begin, end] with 0 &lt;= begin &lt; end.</source>
        <translation>[début, fin] est attendu, avec 0 &lt;= début &lt; fin.</translation>
    </message>
    <message>
        <source>expected an object with &quot;key_poses&quot;: 1, &quot;rate&quot; and &quot;keys&quot;.</source>
        <translation>un objet avec &quot;key_poses&quot;: 1, &quot;rate&quot; et &quot;keys&quot; est attendu.</translation>
    </message>
    <message>
        <source>expected a colour like #3a86d8.</source>
        <translation>une couleur comme #3a86d8 est attendue.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no joint role.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un rôle d’articulation.</translation>
    </message>
    <message>
        <source>is no joint role.</source>
        <translation>n’est pas un rôle d’articulation.</translation>
    </message>
    <message>
        <source>is no vocabulary: it has no &quot;vocabulary&quot; version.</source>
        <translation>n’est pas un vocabulaire&#xa0;: il n’a pas de version &quot;vocabulary&quot;.</translation>
    </message>
    <message>
        <source>is the id of two qualifiers.</source>
        <translation>est l’identifiant de deux qualificatifs.</translation>
    </message>
    <message>
        <source>is the id of two aspects.</source>
        <translation>est l’identifiant de deux aspects.</translation>
    </message>
    <message>
        <source>is the name of two takes.</source>
        <translation>est le nom de deux prises.</translation>
    </message>
    <message>
        <source>a take has one or two fighters.</source>
        <translation>une prise a un ou deux combattants.</translation>
    </message>
    <message>
        <source>a vocabulary has one aspect or more.</source>
        <translation>un vocabulaire a au moins un aspect.</translation>
    </message>
    <message>
        <source>an aspect has two qualifiers or more.</source>
        <translation>un aspect a au moins deux qualificatifs.</translation>
    </message>
    <message>
        <source>is none of the qualifiers.</source>
        <translation>n’est aucun des qualificatifs.</translation>
    </message>
    <message>
        <source>there is no aspect &quot;%1&quot;.</source>
        <translation>il n’y a pas d’aspect «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>The system&apos;s OpenSSL library cannot compute SHA-256.</source>
        <translation>La bibliothèque OpenSSL du système ne sait pas calculer SHA-256.</translation>
    </message>
    <message>
        <source>A demo bout lasts from 1 second to 24 hours; %1 seconds were asked for.</source>
        <translation>Un combat de démonstration dure de 1 seconde à 24 heures&#xa0;; %1 secondes ont été demandées.</translation>
    </message>
    <message>
        <source>A demo bout has 24 to 240 frames a second; %1 were asked for.</source>
        <translation>Un combat de démonstration a de 24 à 240 images par seconde&#xa0;; %1 ont été demandées.</translation>
    </message>
    <message>
        <source>There is no key pose to make a motion of.</source>
        <translation>Il n’y a pas de pose clé dont faire un mouvement.</translation>
    </message>
    <message>
        <source>The library holds no motion.</source>
        <translation>La bibliothèque ne contient aucun mouvement.</translation>
    </message>
    <message>
        <source>There is no key at frame %1.</source>
        <translation>Il n’y a pas de clé à l’image %1.</translation>
    </message>
    <message>
        <source>Frame %1 is not behind the key before.</source>
        <translation>L’image %1 ne vient pas après la clé précédente.</translation>
    </message>
    <message>
        <source>Keys can be brought nearer or farther by a factor above 0 only.</source>
        <translation>Les clés ne peuvent être rapprochées ou éloignées que d’un facteur supérieur à 0.</translation>
    </message>
    <message>
        <source>Keys cannot be brought that far.</source>
        <translation>Les clés ne peuvent pas être déplacées aussi loin.</translation>
    </message>
    <message>
        <source>Key poses need a skeleton.</source>
        <translation>Les poses clés demandent un squelette.</translation>
    </message>
    <message>
        <source>Key poses need a rate above 0.</source>
        <translation>Les poses clés demandent une cadence supérieure à 0.</translation>
    </message>
    <message>
        <source>The key at frame %1 is a pose of another skeleton.</source>
        <translation>La clé à l’image %1 est une pose d’un autre squelette.</translation>
    </message>
    <message>
        <source>The key at frame %1 comes after one at frame %2.</source>
        <translation>La clé à l’image %1 vient après une clé à l’image %2.</translation>
    </message>
    <message>
        <source>Frames %1:%2 are not in the take, which has %3.</source>
        <translation>Les images %1:%2 ne sont pas dans la prise, qui en a %3.</translation>
    </message>
    <message>
        <source>The part comes from another skeleton.</source>
        <translation>La partie vient d’un autre squelette.</translation>
    </message>
    <message>
        <source>Frames %1 to %2 are not in the source, which has %3.</source>
        <translation>Les images %1 à %2 ne sont pas dans la source, qui en a %3.</translation>
    </message>
    <message>
        <source>There is no key pose to look for.</source>
        <translation>Il n’y a pas de pose clé à chercher.</translation>
    </message>
    <message>
        <source>At most 1000 key poses can be looked for.</source>
        <translation>On peut chercher 1000 poses clés au plus.</translation>
    </message>
    <message>
        <source>Every key pose needs its features and its frame.</source>
        <translation>Chaque pose clé a besoin de ses traits et de son image.</translation>
    </message>
    <message>
        <source>Key poses must stand in the order of their frames, one per frame.</source>
        <translation>Les poses clés doivent suivre l’ordre de leurs images, une par image.</translation>
    </message>
    <message>
        <source>Two examples of the strike cannot be aligned in time.</source>
        <translation>Deux exemples de la frappe ne peuvent pas être alignés dans le temps.</translation>
    </message>
    <message>
        <source>There is no example of the strike to blend.</source>
        <translation>Il n’y a aucun exemple de la frappe à mélanger.</translation>
    </message>
    <message>
        <source>The skeleton has no %1: its roles tell nothing that could hit.</source>
        <translation>Il manque au squelette&#xa0;: %1. Ses rôles n’indiquent rien qui puisse frapper.</translation>
    </message>
    <message>
        <source>Strike &quot;%1&quot; is of another skeleton.</source>
        <translation>La frappe «&#xa0;%1&#xa0;» est d’un autre squelette.</translation>
    </message>
    <message>
        <source>Feature poses must come in pairs, one of the query and one of the clip.</source>
        <translation>Les poses à comparer vont par paires, l’une de la requête, l’autre du clip.</translation>
    </message>
    <message>
        <source>Feature poses must follow each other in time.</source>
        <translation>Les poses à comparer doivent se suivre dans le temps.</translation>
    </message>
    <message>
        <source>An AMC file does not say its frame rate: 120 Hz is assumed; give another with --rate.</source>
        <translation>Un fichier AMC ne dit pas sa cadence&#xa0;: 120&#xa0;Hz est supposé&#xa0;; donnez-en une autre avec --rate.</translation>
    </message>
    <message>
        <source>Frame %1, the last, is cut: it is dropped.</source>
        <translation>L’image %1, la dernière, est tronquée&#xa0;: elle est abandonnée.</translation>
    </message>
    <message>
        <source>Frame %1 does not follow the one before it by number: the frames are taken one after the other.</source>
        <translation>Le numéro de l’image %1 ne suit pas celui de la précédente&#xa0;: les images sont prises l’une après l’autre.</translation>
    </message>
    <message>
        <source>found %1 numbers, expected %2 for bone %3 in frame %4</source>
        <translation>%1 nombres au lieu de %2 pour l’os %3 à l’image %4</translation>
    </message>
    <message>
        <source>found no line for bone %1 in frame %2, expected one for each bone with a dof</source>
        <translation>aucune ligne pour l’os %1 à l’image %2&#xa0;; il en faut une pour chaque os qui a un dof</translation>
    </message>
    <message>
        <source>found %1, expected a unit of length greater than zero</source>
        <translation>trouvé&#xa0;: %1&#xa0;; attendu&#xa0;: une unité de longueur supérieure à zéro</translation>
    </message>
    <message>
        <source>found a bone without name, expected one</source>
        <translation>un os n’a pas de nom, il lui en faut un</translation>
    </message>
    <message>
        <source>found a second bone %1, expected one</source>
        <translation>un deuxième os %1, un seul était attendu</translation>
    </message>
    <message>
        <source>found bone %1 a second time, expected one parent for each</source>
        <translation>l’os %1 apparaît une deuxième fois&#xa0;; chacun n’a qu’un parent</translation>
    </message>
    <message>
        <source>found bone %1 that does not hang on the root, expected it in :hierarchy</source>
        <translation>l’os %1 n’est pas rattaché à la racine&#xa0;; il devrait l’être dans :hierarchy</translation>
    </message>
    <message>
        <source>found a skeleton without any dof, expected an order for the root</source>
        <translation>le squelette n’a aucun dof&#xa0;; order était attendu pour la racine</translation>
    </message>
    <message>
        <source>Bone %1 changes its length: that is not used.</source>
        <translation>L’os %1 change de longueur&#xa0;: ce n’est pas pris en compte.</translation>
    </message>
    <message>
        <source>found more joints than a skeleton can have, expected %1 at most</source>
        <translation>trop d’articulations pour un squelette, %1 au plus</translation>
    </message>
    <message>
        <source>%1 has no OFFSET: taken as 0 0 0.</source>
        <translation>%1 n’a pas d’OFFSET&#xa0;: 0 0 0 est supposé.</translation>
    </message>
    <message>
        <source>%1 has channels or children: read as a joint.</source>
        <translation>%1 a des canaux ou des enfants&#xa0;: lu comme une articulation.</translation>
    </message>
    <message>
        <source>found a second %1, expected one in joint %2</source>
        <translation>un deuxième %1 dans l’articulation %2, un seul était attendu</translation>
    </message>
    <message>
        <source>found a skeleton without any channel, expected CHANNELS</source>
        <translation>le squelette n’a aucun canal, CHANNELS était attendu</translation>
    </message>
    <message>
        <source>found %1 numbers after Frame Time, expected at least one frame of %2 numbers</source>
        <translation>%1 nombres après Frame Time&#xa0;; il faut au moins une image de %2 nombres</translation>
    </message>
    <message>
        <source>found more frames than can be counted, expected fewer</source>
        <translation>plus d’images qu’on n’en peut compter, il en faut moins</translation>
    </message>
    <message>
        <source>A .glb file cannot hold more than 4 GB: export a shorter range.</source>
        <translation>Un fichier .glb ne peut pas dépasser 4&#xa0;Go&#xa0;: exportez une plage plus courte.</translation>
    </message>
    <message>
        <source>There is no figure to write.</source>
        <translation>Il n’y a pas de figure à écrire.</translation>
    </message>
    <message>
        <source>A glTF skeleton cannot have more than 65 535 joints.</source>
        <translation>Un squelette glTF ne peut pas avoir plus de 65 535 articulations.</translation>
    </message>
    <message>
        <source>is not valid JSON here.</source>
        <translation>n’est pas du JSON valide ici.</translation>
    </message>
    <message>
        <source>holds a number that is too large.</source>
        <translation>contient un nombre trop grand.</translation>
    </message>
    <message>
        <source>A .npz file cannot hold more than 4 GB: export a shorter range.</source>
        <translation>Un fichier .npz ne peut pas dépasser 4&#xa0;Go&#xa0;: exportez une plage plus courte.</translation>
    </message>
    <message>
        <source>found no skeleton beside it, expected an .asf file (name it with --asf)</source>
        <translation>aucun squelette à côté, un fichier .asf était attendu (nommez-le avec --asf)</translation>
    </message>
    <message>
        <source>found an ASF skeleton, which holds no motion, expected the .amc file that belongs to it.</source>
        <translation>c’est un squelette ASF, qui ne contient pas de mouvement&#xa0;; le fichier .amc qui va avec était attendu.</translation>
    </message>
    <message>
        <source>The recording holds no skeleton.</source>
        <translation>L’enregistrement ne contient pas de squelette.</translation>
    </message>
    <message>
        <source>found UTF-16 text, expected plain text (save the file as UTF-8)</source>
        <translation>c’est du texte UTF-16, du texte simple était attendu (enregistrez le fichier en UTF-8)</translation>
    </message>
    <message>
        <source>has a quote that is not closed.</source>
        <translation>a un guillemet qui n’est pas fermé.</translation>
    </message>
    <message>
        <source>No joint has the role pelvis: actions cannot be compared.</source>
        <translation>Aucune articulation n’a le rôle de bassin&#xa0;: les actions ne peuvent pas être comparées.</translation>
    </message>
    <message>
        <source>Nothing stands before &quot;or&quot;.</source>
        <translation>Il n’y a rien avant «&#xa0;or&#xa0;».</translation>
    </message>
    <message>
        <source>Nothing stands after &quot;or&quot;.</source>
        <translation>Il n’y a rien après «&#xa0;or&#xa0;».</translation>
    </message>
    <message>
        <source>Something is missing after &quot;not&quot;.</source>
        <translation>Il manque quelque chose après «&#xa0;not&#xa0;».</translation>
    </message>
    <message>
        <source>Points to be aligned must come in pairs.</source>
        <translation>Les points à aligner vont par paires.</translation>
    </message>
    <message>
        <source>Points to be aligned need a weight above zero.</source>
        <translation>Les points à aligner ont besoin d’un poids supérieur à zéro.</translation>
    </message>
    <message>
        <source>A rate must be a positive number of frames a second.</source>
        <translation>Une cadence doit être un nombre positif d’images par seconde.</translation>
    </message>
    <message>
        <source>Foot locking needs a frame to show.</source>
        <translation>Le verrouillage des pieds demande une image à montrer.</translation>
    </message>
    <message>
        <source>Foot locking needs to know of every frame which feet stand.</source>
        <translation>Le verrouillage des pieds doit savoir, pour chaque image, quels pieds sont posés.</translation>
    </message>
    <message>
        <source>A clip without frames cannot be joined.</source>
        <translation>Un clip sans images ne peut pas être raccordé.</translation>
    </message>
    <message>
        <source>Clips can be joined only at one rate and on one skeleton.</source>
        <translation>Des clips ne se raccordent qu’à la même cadence et sur le même squelette.</translation>
    </message>
    <message>
        <source>A motion needs a skeleton.</source>
        <translation>Un mouvement demande un squelette.</translation>
    </message>
    <message>
        <source>A motion&apos;s frame time must be a positive number of seconds.</source>
        <translation>La durée d’image d’un mouvement doit être un nombre positif de secondes.</translation>
    </message>
    <message>
        <source>A motion&apos;s channel values do not fill its frames.</source>
        <translation>Les valeurs de canaux d’un mouvement ne remplissent pas ses images.</translation>
    </message>
    <message>
        <source>A channel value is not a finite number.</source>
        <translation>Une valeur de canal n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>A clip&apos;s rig does not have the joints of its motion.</source>
        <translation>Le rig d’un clip n’a pas les articulations de son mouvement.</translation>
    </message>
    <message>
        <source>A clip of %1 joints cannot be written with the %2 joints of another skeleton: retarget it first.</source>
        <translation>Un clip de %1 articulations ne peut pas être écrit avec les %2 articulations d’un autre squelette&#xa0;: faites d’abord un retargeting.</translation>
    </message>
    <message>
        <source>Ways are scaled by %1 for the legs&apos; lengths.</source>
        <translation>Les trajets sont mis à l’échelle (× %1) d’après la longueur des jambes.</translation>
    </message>
    <message>
        <source>%1 moves by up to %2 cm of its own, which is not kept: %3 carries the body.</source>
        <translation>%1 a un déplacement propre, jusqu’à %2&#xa0;cm, qui n’est pas gardé&#xa0;: c’est %3 qui porte le corps.</translation>
    </message>
    <message>
        <source>The bone to %1 changes by up to %2 cm; its mean is kept.</source>
        <translation>La longueur de l’os menant à %1 varie, jusqu’à %2&#xa0;cm&#xa0;; sa moyenne est gardée.</translation>
    </message>
    <message>
        <source>No neck: the chest (%1) stands in for it.</source>
        <translation>Pas de cou&#xa0;: la poitrine (%1) le remplace.</translation>
    </message>
    <message>
        <source>The joint names say nothing; the roles were read off the skeleton&apos;s shape. Check left and right.</source>
        <translation>Les noms des articulations ne disent rien&#xa0;; les rôles ont été lus d’après la forme du squelette. Vérifiez gauche et droite.</translation>
    </message>
    <message>
        <source>This skeleton is not a human body that is known here: it is shown and measured, but the contact force needs joint roles. Name them by hand if it is one.</source>
        <translation>Ce squelette n’est pas un corps humain connu ici&#xa0;: il est affiché et mesuré, mais la force de contact a besoin de rôles d’articulations. Si c’en est un, donnez-les à la main.</translation>
    </message>
    <message>
        <source>A skeleton needs at least one joint.</source>
        <translation>Un squelette a besoin d’au moins une articulation.</translation>
    </message>
    <message>
        <source>A skeleton&apos;s channel count does not add up.</source>
        <translation>Le nombre de canaux du squelette ne tombe pas juste.</translation>
    </message>
    <message>
        <source>The body lies along the x axis; y was taken for up. Say which axis is up.</source>
        <translation>Le corps est allongé le long de l’axe x&#xa0;; y a été pris pour le haut. Dites quel axe est vertical.</translation>
    </message>
    <message>
        <source>Without legs the unit cannot be found; centimetres are assumed.</source>
        <translation>Sans jambes, l’unité est introuvable&#xa0;; le centimètre est supposé.</translation>
    </message>
    <message>
        <source>The labels belong to another segmentation.</source>
        <translation>Les étiquettes appartiennent à une autre segmentation.</translation>
    </message>
    <message>
        <source>The differences belong to another segmentation or vocabulary.</source>
        <translation>Les différences appartiennent à une autre segmentation ou à un autre vocabulaire.</translation>
    </message>
    <message>
        <source>Fighter %1 has no removed boundary near frame %2.</source>
        <translation>Le combattant %1 n’a aucune limite supprimée près de l’image %2.</translation>
    </message>
    <message>
        <source>Fighter %1 has another boundary at frame %2; move that one first.</source>
        <translation>Le combattant %1 a une autre limite à l’image %2&#xa0;; déplacez d’abord celle-là.</translation>
    </message>
    <message>
        <source>Frame %1 is not inside the take, whose last frame is %2: a boundary cannot stand there.</source>
        <translation>L’image %1 n’est pas dans la prise, dont la dernière image est %2&#xa0;: une limite ne peut pas s’y trouver.</translation>
    </message>
    <message>
        <source>The boundary can move between its neighbours only: frames %1 to %2.</source>
        <translation>La limite ne peut se déplacer qu’entre ses voisines&#xa0;: images %1 à %2.</translation>
    </message>
    <message>
        <source>The boundary at frame %1 is an end of the take, which stays.</source>
        <translation>La limite à l’image %1 est un bout de la prise, qui reste.</translation>
    </message>
    <message>
        <source>Take %1, player %2: its skeleton has other joints than that of the first take, so it is left out of bouts.</source>
        <translation>Prise %1, combattant %2&#xa0;: son squelette a d’autres articulations que celui de la première prise, il est donc exclu des combats.</translation>
    </message>
    <message>
        <source>No action of player %1 begins in frames %2 to %3 of take %4.</source>
        <translation>Aucune action du combattant %1 ne commence dans les images %2 à %3 de la prise %4.</translation>
    </message>
    <message>
        <source>Player %1 does not attack in frames %2 to %3 of take %4.</source>
        <translation>Le combattant %1 n’attaque pas dans les images %2 à %3 de la prise %4.</translation>
    </message>
    <message>
        <source>Player %1 never attacks.</source>
        <translation>Le combattant %1 n’attaque jamais.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2.</source>
        <translation>Le dossier %1 ne peut pas être créé&#xa0;: %2.</translation>
    </message>
    <message>
        <source>The cutoff must be a positive number of Hz.</source>
        <translation>La coupure doit être un nombre positif de Hz.</translation>
    </message>
    <message>
        <source>The prominence must be a number of body weights, 0 or more.</source>
        <translation>La proéminence doit être un nombre de poids du corps, supérieur ou égal à 0.</translation>
    </message>
    <message>
        <source>A take needs a name.</source>
        <translation>Une prise doit avoir un nom.</translation>
    </message>
    <message>
        <source>A take has one or two fighters.</source>
        <translation>Une prise a un ou deux combattants.</translation>
    </message>
    <message>
        <source>There is no such place in the list of takes.</source>
        <translation>Cette place n’existe pas dans la liste des prises.</translation>
    </message>
    <message>
        <source>There is one fighter only: nothing to swap.</source>
        <translation>Il n’y a qu’un combattant&#xa0;: rien à échanger.</translation>
    </message>
    <message>
        <source>The skeleton has no such joint.</source>
        <translation>Le squelette n’a pas cette articulation.</translation>
    </message>
    <message>
        <source>%1 holds %2 frames, but the take reaches to frame %3: it is not the recording that is missing.</source>
        <translation>%1 contient %2 images, mais la prise va jusqu’à l’image %3&#xa0;: ce n’est pas l’enregistrement qui manque.</translation>
    </message>
    <message>
        <source>The placement cannot be written: neither the root nor a joint right below it has all position and rotation channels.</source>
        <translation>La place ne peut pas être écrite&#xa0;: ni la racine ni une articulation juste en dessous n’a tous les canaux de position et de rotation.</translation>
    </message>
    <message>
        <source>A take is made of one or two recordings.</source>
        <translation>Une prise est faite d’un ou deux enregistrements.</translation>
    </message>
    <message>
        <source>The take&apos;s name holds bytes that are no UTF-8 text.</source>
        <translation>Le nom de la prise contient des octets qui ne sont pas du texte UTF-8.</translation>
    </message>
    <message>
        <source>A frame rate lies between 1 and 10000 Hz.</source>
        <translation>Une cadence est comprise entre 1 et 10000&#xa0;Hz.</translation>
    </message>
    <message>
        <source>The recordings run at %1 and %2 Hz; each keeps its own rate.</source>
        <translation>Les enregistrements sont à %1 et %2&#xa0;Hz&#xa0;; chacun garde sa cadence.</translation>
    </message>
    <message>
        <source>Take %1, player %2: no pelvis or no centre of mass is known, so its actions are left out.</source>
        <translation>Prise %1, combattant %2&#xa0;: pas de bassin ou de centre de masse connu, ses actions sont donc laissées de côté.</translation>
    </message>
    <message>
        <source>Player %1: %2 of %3 actions have no label and are left out, with every transition that touches them.</source>
        <translation>Combattant %1&#xa0;: %2 actions sur %3 n’ont pas d’étiquette et sont laissées de côté, avec toutes les transitions qui y touchent.</translation>
    </message>
    <message>
        <source>No take of two has a recording of player %1 with the skeleton of the bout: it was removed since the bout was begun.</source>
        <translation>Aucune prise à deux n’a d’enregistrement du combattant %1 avec le squelette du combat&#xa0;: il a été supprimé depuis le début du combat.</translation>
    </message>
    <message>
        <source>An .eaf file holds one take: say which.</source>
        <translation>Un fichier .eaf contient une seule prise&#xa0;: dites laquelle.</translation>
    </message>
    <message>
        <source>is empty.</source>
        <translation>est vide.</translation>
    </message>
    <message>
        <source>has no column %1; a label table needs begin_s, end_s and label.</source>
        <translation>n’a pas de colonne %1&#xa0;; un tableau d’étiquettes demande begin_s, end_s et label.</translation>
    </message>
    <message>
        <source>holds no labels: it has neither &quot;kumite_labels&quot; nor &quot;players&quot;.</source>
        <translation>ne contient pas d’étiquettes&#xa0;: il n’a ni &quot;kumite_labels&quot; ni &quot;players&quot;.</translation>
    </message>
    <message>
        <source>There is no action %1; the fighter has %2.</source>
        <translation>Il n’y a pas d’action %1&#xa0;; le combattant en a %2.</translation>
    </message>
    <message>
        <source>The vocabulary has no aspect %1.</source>
        <translation>Le vocabulaire n’a pas d’aspect %1.</translation>
    </message>
    <message>
        <source>%1 has no qualifier %2.</source>
        <translation>%1 n’a pas de qualificatif %2.</translation>
    </message>
    <message>
        <source>The label belongs to another vocabulary.</source>
        <translation>L’étiquette appartient à un autre vocabulaire.</translation>
    </message>
    <message>
        <source>The thresholds of the rules must be numbers, 0 or more.</source>
        <translation>Les seuils des règles doivent être des nombres supérieurs ou égaux à 0.</translation>
    </message>
    <message>
        <source>A cross-validation has two folds or more.</source>
        <translation>Une validation croisée a au moins deux plis.</translation>
    </message>
    <message>
        <source>A library&apos;s rate lies between %1 and %2 Hz.</source>
        <translation>La cadence d’une bibliothèque est comprise entre %1 et %2&#xa0;Hz.</translation>
    </message>
    <message>
        <source>The library is empty: no source holds the motion of a body.</source>
        <translation>La bibliothèque est vide&#xa0;: aucune source ne contient le mouvement d’un corps.</translation>
    </message>
    <message>
        <source>The library has no clip &quot;%1&quot;; it has %2.</source>
        <translation>La bibliothèque n’a pas de clip «&#xa0;%1&#xa0;»&#xa0;; elle a %2.</translation>
    </message>
    <message>
        <source>None of these clips shows a hand or a foot that strikes.</source>
        <translation>Aucun de ces clips ne montre une main ou un pied qui frappe.</translation>
    </message>
    <message>
        <source>No strike of the %1 was found in &quot;%2&quot;.</source>
        <translation>Aucune frappe de ce membre (%1) n’a été trouvée dans «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>%1 was not where the project says; the same recording was found at %2.</source>
        <translation>%1 n’était pas là où le dit le projet&#xa0;; le même enregistrement a été trouvé ici&#xa0;: %2.</translation>
    </message>
    <message>
        <source>%1 is there already: choose another name.</source>
        <translation>%1 existe déjà&#xa0;: choisissez un autre nom.</translation>
    </message>
    <message>
        <source>is a recording; make a project of it with kumite new.</source>
        <translation>est un enregistrement&#xa0;; faites-en un projet avec kumite new.</translation>
    </message>
    <message>
        <source>is not a Kumite project: it has no &quot;kumite&quot; version.</source>
        <translation>n’est pas un projet Kumite&#xa0;: il n’a pas de version &quot;kumite&quot;.</translation>
    </message>
    <message>
        <source>was written by a newer Kumite (file version %1, this one reads up to %2); open it with that one.</source>
        <translation>a été écrit par un Kumite plus récent (version de fichier %1, celui-ci lit jusqu’à %2)&#xa0;; ouvrez-le avec ce dernier.</translation>
    </message>
    <message>
        <source>No motion from key poses of %1: %2</source>
        <translation>Pas de mouvement à partir de poses clés de %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>There is no clip to rate.</source>
        <translation>Il n’y a pas de clip à évaluer.</translation>
    </message>
    <message>
        <source>Frame %1 is not inside the take: a boundary cannot stand there.</source>
        <translation>L’image %1 n’est pas dans la prise&#xa0;: une limite ne peut pas s’y trouver.</translation>
    </message>
    <message>
        <source>Fighter %1 has another boundary at frame %2; forget this one.</source>
        <translation>Le combattant %1 a une autre limite à l’image %2&#xa0;; oubliez celle-ci.</translation>
    </message>
    <message>
        <source>Fighter %1 has no action at frame %2.</source>
        <translation>Le combattant %1 n’a pas d’action à l’image %2.</translation>
    </message>
    <message>
        <source>The budget is a share of all actions, above 0 and at most 1.</source>
        <translation>Le budget est une part de toutes les actions, supérieure à 0 et au plus égale à 1.</translation>
    </message>
    <message>
        <source>Player %1 has no labelled action that follows another labelled one: label more of it.</source>
        <translation>Le combattant %1 n’a aucune action étiquetée qui en suive une autre étiquetée&#xa0;: étiquetez-en davantage.</translation>
    </message>
    <message>
        <source>The captured attack holds no action.</source>
        <translation>L’attaque capturée ne contient aucune action.</translation>
    </message>
    <message>
        <source>No take of two shows player %1.</source>
        <translation>Aucune prise à deux ne montre le combattant %1.</translation>
    </message>
    <message>
        <source>The captured attack cannot be shown: its take is missing.</source>
        <translation>L’attaque capturée ne peut pas être montrée&#xa0;: sa prise manque.</translation>
    </message>
    <message>
        <source>Player %1 shows nothing but attacks outside of the captured one.</source>
        <translation>Hors de l’attaque capturée, le combattant %1 ne montre que des attaques.</translation>
    </message>
    <message>
        <source>No recorded moment shows both fighters labelled.</source>
        <translation>Aucun moment enregistré ne montre les deux combattants étiquetés.</translation>
    </message>
    <message>
        <source>Only a bout with an avatar can be steered.</source>
        <translation>Seul un combat avec un avatar peut être guidé.</translation>
    </message>
    <message>
        <source>The library was made without an avatar&apos;s model.</source>
        <translation>La bibliothèque a été faite sans modèle d’avatar.</translation>
    </message>
    <message>
        <source>Player %1 never shows &quot;%2&quot; after another labelled action.</source>
        <translation>Le combattant %1 ne montre jamais «&#xa0;%2&#xa0;» après une autre action étiquetée.</translation>
    </message>
    <message>
        <source>A weight is 0 (never) or a positive factor.</source>
        <translation>Un poids vaut 0 (jamais) ou un facteur positif.</translation>
    </message>
    <message>
        <source>A temperature is 0 or positive.</source>
        <translation>Une température est nulle ou positive.</translation>
    </message>
    <message>
        <source>No action of the avatar is followed by half a second of its take.</source>
        <translation>Aucune action de l’avatar n’est suivie d’une demi-seconde de sa prise.</translation>
    </message>
    <message>
        <source>The action has no frame.</source>
        <translation>L’action n’a aucune image.</translation>
    </message>
    <message>
        <source>The threshold of pose clusters must be a positive number.</source>
        <translation>Le seuil des groupes de poses doit être un nombre positif.</translation>
    </message>
    <message>
        <source>The block &quot;%1&quot; has no motion.</source>
        <translation>Le bloc «&#xa0;%1&#xa0;» n’a pas de mouvement.</translation>
    </message>
    <message>
        <source>Frames %1:%2 cannot be taken from &quot;%3&quot;, which has %4.</source>
        <translation>Les images %1:%2 ne peuvent pas être prises dans «&#xa0;%3&#xa0;», qui en a %4.</translation>
    </message>
    <message>
        <source>The block &quot;%1&quot; has no frame.</source>
        <translation>Le bloc «&#xa0;%1&#xa0;» n’a aucune image.</translation>
    </message>
    <message>
        <source>The sequence has no block.</source>
        <translation>La séquence n’a aucun bloc.</translation>
    </message>
    <message>
        <source>There is no path in the graph between these two actions; choose a curve, or clips played backward.</source>
        <translation>Le graphe n’a pas de chemin entre ces deux actions&#xa0;; choisissez une courbe, ou des clips lus à l’envers.</translation>
    </message>
    <message>
        <source>There are %1 candidate paths, counted from 0: no path %2.</source>
        <translation>Il y a %1 chemins possibles, comptés à partir de 0&#xa0;: pas de chemin %2.</translation>
    </message>
    <message>
        <source>A transition needs motion on both sides.</source>
        <translation>Une transition demande du mouvement des deux côtés.</translation>
    </message>
    <message>
        <source>%1 (%2–%3 s, fighter %4): %5</source>
        <translation>%1 (%2–%3&#xa0;s, combattant %4)&#xa0;: %5</translation>
    </message>
    <message>
        <source>at least one whole frame</source>
        <translation>au moins une image entière</translation>
    </message>
    <message>
        <source>the number of a frame</source>
        <translation>le numéro d’une image</translation>
    </message>
    <message>
        <source>a bone of the skeleton that has a dof, or the number of the frame after %1</source>
        <translation>un os du squelette qui a un dof, ou le numéro de l’image qui suit %1</translation>
    </message>
    <message>
        <source>each bone once in frame %1</source>
        <translation>chaque os une seule fois à l’image %1</translation>
    </message>
    <message>
        <source>a number for bone %1 in frame %2</source>
        <translation>un nombre pour l’os %1 à l’image %2</translation>
    </message>
    <message>
        <source>only %1 numbers for bone %2 in frame %3</source>
        <translation>seulement %1 nombres pour l’os %2 à l’image %3</translation>
    </message>
    <message>
        <source>a section of an ASF file, such as :units or :bonedata</source>
        <translation>une section de fichier ASF, comme :units ou :bonedata</translation>
    </message>
    <message>
        <source>the section :root</source>
        <translation>la section :root</translation>
    </message>
    <message>
        <source>the section :hierarchy</source>
        <translation>la section :hierarchy</translation>
    </message>
    <message>
        <source>deg or rad</source>
        <translation>deg ou rad</translation>
    </message>
    <message>
        <source>order, axis, position or orientation</source>
        <translation>order, axis, position ou orientation</translation>
    </message>
    <message>
        <source>10000 bones at most</source>
        <translation>10000 os au plus</translation>
    </message>
    <message>
        <source>end, behind the last line of a bone</source>
        <translation>end, après la dernière ligne d’un os</translation>
    </message>
    <message>
        <source>the name of a bone of :bonedata, or end</source>
        <translation>le nom d’un os de :bonedata, ou end</translation>
    </message>
    <message>
        <source>an order of rotations, such as XYZ</source>
        <translation>un ordre de rotations, comme XYZ</translation>
    </message>
    <message>
        <source>each degree of freedom once</source>
        <translation>chaque degré de liberté une seule fois</translation>
    </message>
    <message>
        <source>OFFSET, CHANNELS, JOINT, End Site or } in joint %1</source>
        <translation>OFFSET, CHANNELS, JOINT, End Site ou } dans l’articulation %1</translation>
    </message>
    <message>
        <source>the number of channels, 0 to 6</source>
        <translation>le nombre de canaux, de 0 à 6</translation>
    </message>
    <message>
        <source>each channel once in a joint</source>
        <translation>chaque canal une seule fois par articulation</translation>
    </message>
    <message>
        <source>channel %1 of %2: Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation</source>
        <translation>canal %1 sur %2&#xa0;: Xposition, Yposition, Zposition, Xrotation, Yrotation ou Zrotation</translation>
    </message>
    <message>
        <source>a finite number with a decimal point</source>
        <translation>un nombre fini avec un point décimal</translation>
    </message>
    <message>
        <source>no action of the opponent at that time</source>
        <translation>aucune action de l’adversaire à ce moment</translation>
    </message>
    <message>
        <source>the opponent&apos;s action is no attack</source>
        <translation>l’action de l’adversaire n’est pas une attaque</translation>
    </message>
    <message>
        <source>stands left</source>
        <translation>appui gauche</translation>
    </message>
    <message>
        <source>stands right</source>
        <translation>appui droit</translation>
    </message>
    <message>
        <source>in the air</source>
        <translation>en suspension</translation>
    </message>
    <message>
        <source>opponent&apos;s %1, closing only %2 m/s</source>
        <translation>attaque adverse (%1), approche à %2&#xa0;m/s seulement</translation>
    </message>
    <message>
        <source>opponent&apos;s %1, closing %2 m/s</source>
        <translation>attaque adverse (%1), approche à %2&#xa0;m/s</translation>
    </message>
    <message>
        <source>%1 at the beginning, %2 at the end</source>
        <translation>%1 au début, %2 à la fin</translation>
    </message>
    <message>
        <source>There is no root %1; the recording has %2.</source>
        <translation>Il n’y a pas de racine %1 ; l’enregistrement a %2.</translation>
    </message>
    <message>
        <source>The body stands on its head most of the time: is up right?</source>
        <translation>Le corps est la plupart du temps la tête en bas : l’axe vertical est-il juste ?</translation>
    </message>
    <message>
        <source>The legs would be %1 m long: is the unit (%2) right?</source>
        <translation>Les jambes auraient %1 m de long : l’unité (%2) est-elle juste ?</translation>
    </message>
    <message>
        <source>Relative to the legs the target&apos;s arms are %1 % longer: hands do not reach the same places.</source>
        <translation>Par rapport aux jambes, les bras de la cible sont plus longs de %1&#xa0;%&#xa0;: les mains n’atteignent pas les mêmes endroits.</translation>
    </message>
    <message>
        <source>Relative to the legs the target&apos;s arms are %1 % shorter: hands do not reach the same places.</source>
        <translation>Par rapport aux jambes, les bras de la cible sont plus courts de %1&#xa0;%&#xa0;: les mains n’atteignent pas les mêmes endroits.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>frames %1:%2 cannot be taken from a recording of %3 frames.</source>
        <translation>les images %1:%2 n’existent pas dans un enregistrement de %3 images.</translation>
    </message>
    <message>
        <source>found %1 data, expected BVH or ASF/AMC: import it into Blender and export it as Motion Capture (.bvh).</source>
        <translation>trouvé : données %1 ; attendu : BVH ou ASF/AMC. Importez le fichier dans Blender et exportez-le en Motion Capture (.bvh).</translation>
    </message>
    <message>
        <source>the opponent&apos;s action is not labelled yet</source>
        <translation>l’action de l’adversaire n’est pas encore étiquetée</translation>
    </message>
</context>
<context>
    <name>KeysSheet</name>
    <message>
        <source>Kumite: keys and mouse</source>
        <translation>Kumite&#xa0;: touches et souris</translation>
    </message>
</context>
<context>
    <name>Role</name>
    <message>
        <source>pelvis</source>
        <translation>bassin</translation>
    </message>
    <message>
        <source>spine</source>
        <translation>colonne</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>poitrine</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>cou</translation>
    </message>
    <message>
        <source>head</source>
        <translation>tête</translation>
    </message>
    <message>
        <source>left clavicle</source>
        <translation>clavicule gauche</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>épaule gauche</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>coude gauche</translation>
    </message>
    <message>
        <source>left wrist</source>
        <translation>poignet gauche</translation>
    </message>
    <message>
        <source>left hip</source>
        <translation>hanche gauche</translation>
    </message>
    <message>
        <source>left knee</source>
        <translation>genou gauche</translation>
    </message>
    <message>
        <source>left ankle</source>
        <translation>cheville gauche</translation>
    </message>
    <message>
        <source>left toe</source>
        <translation>orteils gauches</translation>
    </message>
    <message>
        <source>right clavicle</source>
        <translation>clavicule droite</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>épaule droite</translation>
    </message>
    <message>
        <source>right elbow</source>
        <translation>coude droit</translation>
    </message>
    <message>
        <source>right wrist</source>
        <translation>poignet droit</translation>
    </message>
    <message>
        <source>right hip</source>
        <translation>hanche droite</translation>
    </message>
    <message>
        <source>right knee</source>
        <translation>genou droit</translation>
    </message>
    <message>
        <source>right ankle</source>
        <translation>cheville droite</translation>
    </message>
    <message>
        <source>right toe</source>
        <translation>orteils droits</translation>
    </message>
</context>
<context>
    <name>ShortLabel</name>
    <message>
        <source>fwd</source>
        <translation>av</translation>
    </message>
    <message>
        <source>bwd</source>
        <translation>ar</translation>
    </message>
    <message>
        <source>bwdfwd</source>
        <translation>ar-av</translation>
    </message>
    <message>
        <source>fwdbwd</source>
        <translation>av-ar</translation>
    </message>
    <message>
        <source>up</source>
        <translation>↑</translation>
    </message>
    <message>
        <source>down</source>
        <translation>↓</translation>
    </message>
    <message>
        <source>downup</source>
        <translation>↓↑</translation>
    </message>
    <message>
        <source>kick</source>
        <translation>pied</translation>
    </message>
    <message>
        <source>punch</source>
        <translation>poing</translation>
    </message>
    <message>
        <source>L-L</source>
        <translation>G-G</translation>
    </message>
    <message>
        <source>L-R</source>
        <translation>G-D</translation>
    </message>
    <message>
        <source>L-F</source>
        <translation>G-S</translation>
    </message>
    <message>
        <source>R-L</source>
        <translation>D-G</translation>
    </message>
    <message>
        <source>R-R</source>
        <translation>D-D</translation>
    </message>
    <message>
        <source>R-F</source>
        <translation>D-S</translation>
    </message>
    <message>
        <source>F-L</source>
        <translation>S-G</translation>
    </message>
    <message>
        <source>F-R</source>
        <translation>S-D</translation>
    </message>
    <message>
        <source>F-F</source>
        <translation>S-S</translation>
    </message>
</context>
<context>
    <name>Vocabulary</name>
    <message>
        <source>Left punch</source>
        <translation>Coup de poing gauche</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>back</source>
        <translation>arrière</translation>
    </message>
    <message>
        <source>back and forward</source>
        <translation>arrière puis avant</translation>
    </message>
    <message>
        <source>forward and back</source>
        <translation>avant puis arrière</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Right punch</source>
        <translation>Coup de poing droit</translation>
    </message>
    <message>
        <source>Left kick</source>
        <translation>Coup de pied gauche</translation>
    </message>
    <message>
        <source>up</source>
        <translation>montée</translation>
    </message>
    <message>
        <source>down</source>
        <translation>descente</translation>
    </message>
    <message>
        <source>down and up</source>
        <translation>descente puis montée</translation>
    </message>
    <message>
        <source>Right kick</source>
        <translation>Coup de pied droit</translation>
    </message>
    <message>
        <source>Jump</source>
        <translation>Saut</translation>
    </message>
    <message>
        <source>React</source>
        <translation>Réaction</translation>
    </message>
    <message>
        <source>to a kick</source>
        <translation>à un coup de pied</translation>
    </message>
    <message>
        <source>to a punch</source>
        <translation>à un coup de poing</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>left to left</source>
        <translation>gauche vers gauche</translation>
    </message>
    <message>
        <source>left to right</source>
        <translation>gauche vers droite</translation>
    </message>
    <message>
        <source>left to flight</source>
        <translation>gauche vers suspension</translation>
    </message>
    <message>
        <source>right to left</source>
        <translation>droite vers gauche</translation>
    </message>
    <message>
        <source>right to right</source>
        <translation>droite vers droite</translation>
    </message>
    <message>
        <source>right to flight</source>
        <translation>droite vers suspension</translation>
    </message>
    <message>
        <source>flight to left</source>
        <translation>suspension vers gauche</translation>
    </message>
    <message>
        <source>flight to right</source>
        <translation>suspension vers droite</translation>
    </message>
    <message>
        <source>flight to flight</source>
        <translation>suspension vers suspension</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Key: %1</source>
        <translation>Touche&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>kumite</name>
    <message>
        <source>Male means (de Leva 1996)</source>
        <translation>Moyennes hommes (de Leva 1996)</translation>
    </message>
    <message>
        <source>Female means (de Leva 1996)</source>
        <translation>Moyennes femmes (de Leva 1996)</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>aujourd’hui %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>hier %1</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>minimum</translation>
    </message>
    <message>
        <source>foot contact</source>
        <translation>contact du pied</translation>
    </message>
    <message>
        <source>boundary of the other</source>
        <translation>limite de l’autre</translation>
    </message>
    <message>
        <source>playhead</source>
        <translation>tête de lecture</translation>
    </message>
</context>
<context>
    <name>kumite::studio</name>
    <message>
        <source>example, sample, tutorial, try</source>
        <translation>exemple, échantillon, tutoriel, essayer, démo</translation>
    </message>
    <message>
        <source>import, load, bvh, amc, asf, mocap, motion capture, new project</source>
        <translation>importer, charger, bvh, amc, asf, mocap, capture de mouvement, nouveau projet</translation>
    </message>
    <message>
        <source>load, kumite file</source>
        <translation>charger, fichier kumite</translation>
    </message>
    <message>
        <source>store, write</source>
        <translation>sauvegarder, stocker, écrire</translation>
    </message>
    <message>
        <source>copy, rename project, duplicate</source>
        <translation>copier, renommer le projet, dupliquer</translation>
    </message>
    <message>
        <source>backup, restore, earlier, revert, snapshot</source>
        <translation>sauvegarde, restaurer, antérieur, revenir, instantané</translation>
    </message>
    <message>
        <source>csv, json, table, spreadsheet, results, segmentation</source>
        <translation>csv, json, tableau, tableur, résultats, segmentation</translation>
    </message>
    <message>
        <source>bvh, skeleton, animation, blender, mocap</source>
        <translation>bvh, squelette, animation, blender, mocap</translation>
    </message>
    <message>
        <source>missing, relink, locate, moved</source>
        <translation>manquant, relier, localiser, déplacé</translation>
    </message>
    <message>
        <source>exit, close, leave</source>
        <translation>sortir, fermer, partir</translation>
    </message>
    <message>
        <source>back, revert, oops</source>
        <translation>retour, revenir, oups, défaire</translation>
    </message>
    <message>
        <source>again, repeat</source>
        <translation>encore, répéter, refaire</translation>
    </message>
    <message>
        <source>settings, options, configuration, shortcuts, autosave</source>
        <translation>réglages, options, configuration, raccourcis, sauvegarde automatique</translation>
    </message>
    <message>
        <source>import, new, load, clip, session</source>
        <translation>importer, nouveau, charger, clip, session</translation>
    </message>
    <message>
        <source>name, title</source>
        <translation>nom, titre</translation>
    </message>
    <message>
        <source>delete, close, clip</source>
        <translation>effacer, fermer, clip</translation>
    </message>
    <message>
        <source>previous clip, switch</source>
        <translation>clip précédent, changer</translation>
    </message>
    <message>
        <source>next clip, switch</source>
        <translation>clip suivant, changer</translation>
    </message>
    <message>
        <source>switch, opponent, toggle, player</source>
        <translation>changer, adversaire, basculer, joueur</translation>
    </message>
    <message>
        <source>joints, roles, skeleton, rate, offset, sync, floor, body model, mass</source>
        <translation>articulations, rôles, squelette, cadence, décalage, synchro, sol, modèle corporel, masse</translation>
    </message>
    <message>
        <source>exchange, colours, player</source>
        <translation>permuter, couleurs, joueur</translation>
    </message>
    <message>
        <source>warnings, problems, errors, log, report</source>
        <translation>avertissements, problèmes, erreurs, journal, rapport</translation>
    </message>
    <message>
        <source>delete, erase, clear, undelete, merge, cut</source>
        <translation>effacer, enlever, vider, restaurer, fusionner, coupe</translation>
    </message>
    <message>
        <source>split, cut, insert, new, razor, slice, mark, here</source>
        <translation>diviser, couper, insérer, nouveau, rasoir, trancher, marquer, ici</translation>
    </message>
    <message>
        <source>merge left, combine, previous</source>
        <translation>fusionner à gauche, combiner, précédent</translation>
    </message>
    <message>
        <source>merge right, combine, next</source>
        <translation>fusionner à droite, combiner, suivant</translation>
    </message>
    <message>
        <source>nudge left, shift</source>
        <translation>pousser à gauche, décaler</translation>
    </message>
    <message>
        <source>nudge right, shift</source>
        <translation>pousser à droite, décaler</translation>
    </message>
    <message>
        <source>repeat, zoom to action, segment</source>
        <translation>répéter, zoomer sur l’action, segment</translation>
    </message>
    <message>
        <source>comment, annotate, remark, text, label</source>
        <translation>commentaire, annoter, remarque, texte, étiquette</translation>
    </message>
    <message>
        <source>review, suspicious, error, uncertain, queue</source>
        <translation>revoir, douteux, erreur, incertain, file</translation>
    </message>
    <message>
        <source>review, suspicious</source>
        <translation>revoir, douteux</translation>
    </message>
    <message>
        <source>accept, approve, confirm, ok, yes, good</source>
        <translation>approuver, confirmer, ok, oui, bon</translation>
    </message>
    <message>
        <source>reject, delete, dismiss, discard, no, false, wrong</source>
        <translation>refuser, supprimer, écarter, jeter, non, faux</translation>
    </message>
    <message>
        <source>reset, reopen, undecided, withdraw</source>
        <translation>réinitialiser, rouvrir, indécis, retirer</translation>
    </message>
    <message>
        <source>difference, a/b, versus, parameters</source>
        <translation>différence, a/b, versus, paramètres</translation>
    </message>
    <message>
        <source>raw, unfiltered, noise</source>
        <translation>brut, non filtré, bruit</translation>
    </message>
    <message>
        <source>com, cog, gravity</source>
        <translation>cdm, cdg, gravité</translation>
    </message>
    <message>
        <source>velocity, wrist, punch</source>
        <translation>vitesse, poignet, poing</translation>
    </message>
    <message>
        <source>velocity, ankle, kick</source>
        <translation>vitesse, cheville, pied</translation>
    </message>
    <message>
        <source>seconds, frames, timecode</source>
        <translation>secondes, images, timecode</translation>
    </message>
    <message>
        <source>start, stop, run</source>
        <translation>démarrer, arrêter, lancer</translation>
    </message>
    <message>
        <source>pause, halt</source>
        <translation>pause, arrêt</translation>
    </message>
    <message>
        <source>rewind, shuttle</source>
        <translation>rembobiner, navette</translation>
    </message>
    <message>
        <source>fast forward, shuttle</source>
        <translation>avance rapide, navette</translation>
    </message>
    <message>
        <source>previous frame, step</source>
        <translation>image précédente, pas</translation>
    </message>
    <message>
        <source>next frame, step</source>
        <translation>image suivante, pas</translation>
    </message>
    <message>
        <source>beginning, first frame, rewind</source>
        <translation>début, première image, rembobiner</translation>
    </message>
    <message>
        <source>last frame</source>
        <translation>dernière image</translation>
    </message>
    <message>
        <source>slow motion, speed, rate</source>
        <translation>ralenti, vitesse, cadence</translation>
    </message>
    <message>
        <source>speed up, rate</source>
        <translation>accélérer, cadence</translation>
    </message>
    <message>
        <source>repeat, cycle</source>
        <translation>répéter, cycle</translation>
    </message>
    <message>
        <source>in point, mark in, start, range</source>
        <translation>point d’entrée, marque d’entrée, début, plage</translation>
    </message>
    <message>
        <source>out point, mark out, end, range</source>
        <translation>point de sortie, marque de sortie, fin, plage</translation>
    </message>
    <message>
        <source>fit, frame all, zoom out, home, reset view</source>
        <translation>ajuster, tout cadrer, dézoomer, accueil, réinitialiser la vue</translation>
    </message>
    <message>
        <source>frame selected, zoom in, focus, centre</source>
        <translation>cadrer la sélection, zoomer, focus, centrer</translation>
    </message>
    <message>
        <source>sidebar, show panels, focus mode</source>
        <translation>barre latérale, afficher les panneaux, mode concentration</translation>
    </message>
    <message>
        <source>maximise, maximize</source>
        <translation>agrandir, maximiser</translation>
    </message>
    <message>
        <source>font size, zoom, bigger, accessibility, scale</source>
        <translation>taille du texte, zoom, plus grand, accessibilité, échelle</translation>
    </message>
    <message>
        <source>font size, zoom, scale</source>
        <translation>taille du texte, zoom, échelle</translation>
    </message>
    <message>
        <source>dark mode, light mode, colours, auto</source>
        <translation>mode sombre, mode clair, couleurs, auto</translation>
    </message>
    <message>
        <source>light mode, bright, white, day, colours</source>
        <translation>mode clair, lumineux, blanc, jour, couleurs</translation>
    </message>
    <message>
        <source>dark mode, black, night, colours</source>
        <translation>mode sombre, noir, nuit, couleurs</translation>
    </message>
    <message>
        <source>camera, front view</source>
        <translation>caméra, vue de face</translation>
    </message>
    <message>
        <source>camera, side view, left, right, profile</source>
        <translation>caméra, vue de côté, gauche, droite, profil</translation>
    </message>
    <message>
        <source>camera, top view, bird</source>
        <translation>caméra, vue de dessus, oiseau</translation>
    </message>
    <message>
        <source>camera, behind, third person</source>
        <translation>caméra, derrière, troisième personne</translation>
    </message>
    <message>
        <source>camera, track</source>
        <translation>caméra, suivi</translation>
    </message>
    <message>
        <source>footsteps, feet, ground</source>
        <translation>pas, pieds, sol, appuis</translation>
    </message>
    <message>
        <source>trajectory, path, motion trail</source>
        <translation>trajectoire, chemin, traînée de mouvement</translation>
    </message>
    <message>
        <source>com, cog, center, gravity</source>
        <translation>cdm, cdg, centre, gravité</translation>
    </message>
    <message>
        <source>arrow, vector, ground reaction</source>
        <translation>flèche, vecteur, réaction du sol</translation>
    </message>
    <message>
        <source>onion skin</source>
        <translation>pelure d’oignon</translation>
    </message>
    <message>
        <source>onion skin, pose, stamp</source>
        <translation>pelure d’oignon, pose, tampon</translation>
    </message>
    <message>
        <source>delete ghosts, onion skin</source>
        <translation>supprimer les fantômes, pelure d’oignon</translation>
    </message>
    <message>
        <source>distance, ruler, speed, tape</source>
        <translation>distance, règle, vitesse, mètre ruban</translation>
    </message>
    <message>
        <source>screenshot, clipboard, image</source>
        <translation>capture d’écran, presse-papiers, image</translation>
    </message>
    <message>
        <source>screenshot, render, image, png, export picture, capture</source>
        <translation>capture d’écran, rendu, image, png, exporter une image, photo</translation>
    </message>
    <message>
        <source>start, stop, preview</source>
        <translation>démarrer, arrêter, aperçu</translation>
    </message>
    <message>
        <source>jump back, skip</source>
        <translation>sauter en arrière, passer</translation>
    </message>
    <message>
        <source>jump forward, skip</source>
        <translation>sauter en avant, passer</translation>
    </message>
    <message>
        <source>preview, result, assembled, synthesised, before, after</source>
        <translation>aperçu, résultat, assemblé, synthétisé, avant, après</translation>
    </message>
    <message>
        <source>punch, kick, strike, aim, reach, target tool</source>
        <translation>coup de poing, coup de pied, frappe, viser, atteindre, outil cible</translation>
    </message>
    <message>
        <source>insert key, new pose, keyframe, set key</source>
        <translation>insérer une clé, nouvelle pose, image clé, poser une clé</translation>
    </message>
    <message>
        <source>delete key, erase</source>
        <translation>effacer la clé, enlever</translation>
    </message>
    <message>
        <source>previous keyframe, jump</source>
        <translation>image clé précédente, sauter</translation>
    </message>
    <message>
        <source>next keyframe, jump</source>
        <translation>image clé suivante, sauter</translation>
    </message>
    <message>
        <source>nudge left, time, shift</source>
        <translation>pousser à gauche, temps, décaler</translation>
    </message>
    <message>
        <source>nudge right, time, shift</source>
        <translation>pousser à droite, temps, décaler</translation>
    </message>
    <message>
        <source>duplicate key, clone, paste</source>
        <translation>dupliquer la clé, cloner, coller</translation>
    </message>
    <message>
        <source>flip, left, right, symmetry, reverse</source>
        <translation>retourner, gauche, droite, symétrie, inverser</translation>
    </message>
    <message>
        <source>grab, capture, snapshot, recording</source>
        <translation>saisir, capturer, instantané, enregistrement</translation>
    </message>
    <message>
        <source>paste pose, browse, frame, library, import pose</source>
        <translation>coller une pose, parcourir, image, bibliothèque, importer une pose</translation>
    </message>
    <message>
        <source>rotate, gizmo, ring, fk, angle, elbow, knee</source>
        <translation>tourner, gizmo, anneau, fk, angle, coude, genou</translation>
    </message>
    <message>
        <source>rotate, gizmo, ring, fk, angle</source>
        <translation>tourner, gizmo, anneau, fk, angle</translation>
    </message>
    <message>
        <source>ripple, shift, time, slide left</source>
        <translation>décaler, temps, glisser à gauche</translation>
    </message>
    <message>
        <source>ripple, shift, time, slide right</source>
        <translation>décaler, temps, glisser à droite</translation>
    </message>
    <message>
        <source>retime, faster, speed up, compress, scale time</source>
        <translation>rythme, plus vite, accélérer, comprimer, échelle de temps</translation>
    </message>
    <message>
        <source>retime, slower, slow down, stretch, scale time</source>
        <translation>rythme, plus lent, ralentir, étirer, échelle de temps</translation>
    </message>
    <message>
        <source>before, after, compare, side by side, a/b, unadjusted</source>
        <translation>avant, après, comparer, côte à côte, a/b, sans ajustement</translation>
    </message>
    <message>
        <source>onion skin, onion skinning, ghost</source>
        <translation>pelure d’oignon, fantôme</translation>
    </message>
    <message>
        <source>partial edit, swap arm, splice, layer, fix, retake</source>
        <translation>édition partielle, remplacer un bras, raccord, calque, corriger</translation>
    </message>
    <message>
        <source>tab, panel, joint, handle</source>
        <translation>onglet, volet, articulation, poignée</translation>
    </message>
    <message>
        <source>tab, panel, find similar, retrieval, sources, parts</source>
        <translation>onglet, volet, trouver du semblable, recherche, sources, parties</translation>
    </message>
    <message>
        <source>lock, fix, nail, constraint, hold foot</source>
        <translation>verrouiller, fixer, clouer, contrainte, tenir le pied</translation>
    </message>
    <message>
        <source>effector, hand, foot, ik, select</source>
        <translation>effecteur, main, pied, ik, cinématique inverse, choisir</translation>
    </message>
    <message>
        <source>raise, nudge, ik</source>
        <translation>lever, pousser, ik</translation>
    </message>
    <message>
        <source>lower, nudge, ik</source>
        <translation>baisser, pousser, ik</translation>
    </message>
    <message>
        <source>nudge, ik, left</source>
        <translation>pousser, ik, gauche</translation>
    </message>
    <message>
        <source>nudge, ik, right</source>
        <translation>pousser, ik, droite</translation>
    </message>
    <message>
        <source>nudge, ik, back</source>
        <translation>pousser, ik, arrière</translation>
    </message>
    <message>
        <source>nudge, ik, forward</source>
        <translation>pousser, ik, avant</translation>
    </message>
    <message>
        <source>source, automatic, best match, reset</source>
        <translation>source, automatique, meilleure correspondance, réinitialiser</translation>
    </message>
    <message>
        <source>delete all, reset, start over</source>
        <translation>tout effacer, réinitialiser, recommencer</translation>
    </message>
    <message>
        <source>import, library, load, bvh</source>
        <translation>importer, bibliothèque, charger, bvh</translation>
    </message>
    <message>
        <source>import, library, directory, bvh</source>
        <translation>importer, bibliothèque, répertoire, bvh</translation>
    </message>
    <message>
        <source>save, bake, new take</source>
        <translation>enregistrer, figer, nouvelle prise</translation>
    </message>
    <message>
        <source>save, bvh, gltf, glb, animation</source>
        <translation>enregistrer, bvh, gltf, glb, animation</translation>
    </message>
    <message>
        <source>beginning, rewind</source>
        <translation>début, rembobiner</translation>
    </message>
    <message>
        <source>repeat, cycle, endless</source>
        <translation>répéter, cycle, sans fin</translation>
    </message>
    <message>
        <source>play live, game, controller, real time</source>
        <translation>jouer en direct, jeu, manette, temps réel</translation>
    </message>
    <message>
        <source>stop live, end</source>
        <translation>arrêter le direct, fin</translation>
    </message>
    <message>
        <source>insert, append, clip, action</source>
        <translation>insérer, ajouter à la fin, clip, action</translation>
    </message>
    <message>
        <source>replace, exchange, other action</source>
        <translation>remplacer, échanger, autre action</translation>
    </message>
    <message>
        <source>delete, erase, cut</source>
        <translation>effacer, enlever, couper</translation>
    </message>
    <message>
        <source>select, jump</source>
        <translation>choisir, sélectionner, sauter</translation>
    </message>
    <message>
        <source>move left, reorder</source>
        <translation>déplacer à gauche, réordonner</translation>
    </message>
    <message>
        <source>move right, reorder</source>
        <translation>déplacer à droite, réordonner</translation>
    </message>
    <message>
        <source>repeat, again, loop</source>
        <translation>répéter, encore, boucle</translation>
    </message>
    <message>
        <source>repeat less</source>
        <translation>répéter moins</translation>
    </message>
    <message>
        <source>trim, in point, cut start</source>
        <translation>rogner, point d’entrée, couper le début</translation>
    </message>
    <message>
        <source>trim, out point, cut end</source>
        <translation>rogner, point de sortie, couper la fin</translation>
    </message>
    <message>
        <source>untrim, reset</source>
        <translation>annuler le rognage, réinitialiser</translation>
    </message>
    <message>
        <source>random, reroll, blend, other path</source>
        <translation>aléatoire, relancer, mélange, autre chemin</translation>
    </message>
    <message>
        <source>random, reroll, shuffle</source>
        <translation>aléatoire, relancer, mélanger</translation>
    </message>
    <message>
        <source>fix, hold, keep</source>
        <translation>fixer, tenir, garder</translation>
    </message>
    <message>
        <source>delete all, new, reset</source>
        <translation>tout effacer, nouveau, réinitialiser</translation>
    </message>
    <message>
        <source>search, filter, actions</source>
        <translation>rechercher, filtrer, actions</translation>
    </message>
    <message>
        <source>library, list, show</source>
        <translation>bibliothèque, liste, afficher</translation>
    </message>
    <message>
        <source>clusters, poses, graph, space</source>
        <translation>groupes, poses, graphe, espace</translation>
    </message>
    <message>
        <source>manual, documentation, guide</source>
        <translation>manuel, documentation, guide</translation>
    </message>
    <message>
        <source>tutorial, introduction, start, guide</source>
        <translation>tutoriel, introduction, débuter, guide</translation>
    </message>
    <message>
        <source>formula, explain, statistics, papers, sources</source>
        <translation>formule, expliquer, statistiques, articles, sources</translation>
    </message>
    <message>
        <source>tutorial, introduction, walkthrough, wizard, guide</source>
        <translation>tutoriel, introduction, visite pas à pas, assistant, guide</translation>
    </message>
    <message>
        <source>explain, context help</source>
        <translation>expliquer, aide contextuelle</translation>
    </message>
    <message>
        <source>explain, accessibility</source>
        <translation>expliquer, accessibilité</translation>
    </message>
    <message>
        <source>shortcuts, hotkeys, cheat sheet, help, manual, print</source>
        <translation>raccourcis, touches de raccourci, aide-mémoire, aide, manuel, imprimer</translation>
    </message>
    <message>
        <source>release notes, changelog, news, version</source>
        <translation>notes de version, journal des modifications, actualités, version</translation>
    </message>
    <message>
        <source>version, licence, license</source>
        <translation>version, licence</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ActionTiles</name>
    <message>
        <source>Similar actions</source>
        <translation>Actions similaires</translation>
    </message>
    <message>
        <source>Those that look most like the current action, side by side.</source>
        <translation>Celles qui ressemblent le plus à l’action actuelle, côte à côte.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ActionsModel</name>
    <message>
        <source>%1, %2 from %3
Return adds it, Shift+Return swaps it for the chosen block</source>
        <translation>%1, %2 de %3
Entrée l’ajoute, Maj+Entrée l’échange contre le bloc choisi</translation>
    </message>
    <message>
        <source>action</source>
        <translation>action</translation>
    </message>
    <message>
        <source>where</source>
        <translation>où</translation>
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
        <translation>Temps du combat</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>sur %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutCommands</name>
    <message>
        <source>Avatar: %1</source>
        <translation>Avatar&#xa0;: %1</translation>
    </message>
    <message>
        <source>The analysis is not finished yet.</source>
        <translation>L’analyse n’est pas encore terminée.</translation>
    </message>
    <message>
        <source>Keep the bout as a take</source>
        <translation>Garder le combat comme prise</translation>
    </message>
    <message>
        <source>Recordings, NAME-1 and NAME-2 (*.bvh)</source>
        <translation>Enregistrements, NOM-1 et NOM-2 (*.bvh)</translation>
    </message>
    <message>
        <source>Keeping the bout</source>
        <translation>Conservation du combat</translation>
    </message>
    <message>
        <source>The project changed while the bout was written. Its files are there; open them as a take, or keep it again under another name.</source>
        <translation>Le projet a changé pendant l’écriture du combat. Ses fichiers sont là&#xa0;; ouvrez-les comme prise, ou gardez-le de nouveau sous un autre nom.</translation>
    </message>
    <message>
        <source>Kept as take %1. Detection alone finds %2 % and %3 % of its boundaries.</source>
        <translation>Gardé comme prise %1. La détection seule trouve %2&#xa0;% et %3&#xa0;% de ses limites.</translation>
    </message>
    <message>
        <source>Writing the bout</source>
        <translation>Écriture du combat</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Export the bout</source>
        <translation>Exporter le combat</translation>
    </message>
    <message>
        <source>Motion of both, NAME-1 and NAME-2 (*.bvh);;glTF: skeletons and animation (*.glb);;Pictures, 30 a second (*.png);;Video, by ffmpeg (*.mp4);;Log: everything that makes it again (*.json)</source>
        <translation>Mouvement des deux, NOM-1 et NOM-2 (*.bvh);;glTF&#xa0;: squelettes et animation (*.glb);;Images, 30 par seconde (*.png);;Vidéo, par ffmpeg (*.mp4);;Journal&#xa0;: tout pour le refaire (*.json)</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Bout</source>
        <translation>Com&amp;bat</translation>
    </message>
    <message>
        <source>&amp;Fight or pause</source>
        <translation>&amp;Combattre ou suspendre</translation>
    </message>
    <message>
        <source>Begin a&amp;new</source>
        <translation>&amp;Recommencer à neuf</translation>
    </message>
    <message>
        <source>Begin with the next &amp;seed</source>
        <translation>Commencer avec la graine &amp;suivante</translation>
    </message>
    <message>
        <source>Go on from here with other &amp;draws</source>
        <translation>Continuer d’ici avec d’autres &amp;tirages</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Une image en arrière</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Une image en avant</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>Une seconde en arrière</translation>
    </message>
    <message>
        <source>One second on</source>
        <translation>Une seconde en avant</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>To the end of what was shown</source>
        <translation>À la fin de ce qui a été montré</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Plus lent</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Plus vite</translation>
    </message>
    <message>
        <source>&amp;Automatic: the model decides</source>
        <translation>&amp;Automatique&#xa0;: le modèle décide</translation>
    </message>
    <message>
        <source>A&amp;vatar: keys lead one fighter</source>
        <translation>A&amp;vatar&#xa0;: les touches guident un combattant</translation>
    </message>
    <message>
        <source>&amp;Passive: one answers a captured attack</source>
        <translation>&amp;Passif&#xa0;: l’un répond à une attaque capturée</translation>
    </message>
    <message>
        <source>Avatar: key %1</source>
        <translation>Avatar&#xa0;: touche %1</translation>
    </message>
    <message>
        <source>Avatar: forget &amp;what was asked for</source>
        <translation>Avatar&#xa0;: &amp;oublier ce qui était demandé</translation>
    </message>
    <message>
        <source>&amp;Measure the quality</source>
        <translation>&amp;Mesurer la qualité</translation>
    </message>
    <message>
        <source>&amp;Keep as a take…</source>
        <translation>&amp;Garder comme prise…</translation>
    </message>
    <message>
        <source>E&amp;xport the bout…</source>
        <translation>E&amp;xporter le combat…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutExport</name>
    <message>
        <source>%1: it cannot be written there.</source>
        <translation>%1&#xa0;: impossible d’écrire à cet endroit.</translation>
    </message>
    <message>
        <source>There is no ffmpeg on this computer, which a video needs: install it (on Debian and Ubuntu: sudo apt install ffmpeg), or export pictures (.png).</source>
        <translation>Il n’y a pas de ffmpeg sur cet ordinateur, or une vidéo en a besoin&#xa0;: installez-le (sous Debian et Ubuntu&#xa0;: sudo apt install ffmpeg), ou exportez des images (.png).</translation>
    </message>
    <message>
        <source>%1 cannot be started.</source>
        <translation>Impossible de démarrer %1.</translation>
    </message>
    <message>
        <source>ffmpeg could not write the video: %1</source>
        <translation>ffmpeg n’a pas pu écrire la vidéo&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutPage</name>
    <message>
        <source>Why there is no bout</source>
        <translation>Pourquoi il n’y a pas de combat</translation>
    </message>
    <message>
        <source>Anew</source>
        <translation>À neuf</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>Garder…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>A bout that goes on for ever, made from what was learnt of the labelled actions, appears here.</source>
        <translation>Un combat sans fin, fait de ce qui a été appris des actions étiquetées, apparaît ici.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutPanel</name>
    <message>
        <source>foot skate</source>
        <translation>glissement</translation>
    </message>
    <message>
        <source>Share of frames in which a foot near the floor slides faster than 0.5 m/s</source>
        <translation>Part des images où un pied proche du sol glisse à plus de 0,5 m/s</translation>
    </message>
    <message>
        <source>in the floor</source>
        <translation>dans le sol</translation>
    </message>
    <message>
        <source>Share of frames with a foot more than 5 mm in the floor</source>
        <translation>Part des images où un pied est enfoncé de plus de 5 mm dans le sol</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>collision</translation>
    </message>
    <message>
        <source>Share of frames with the bodies more than 3 cm in each other</source>
        <translation>Part des images où les corps se pénètrent de plus de 3 cm</translation>
    </message>
    <message>
        <source>joins</source>
        <translation>raccords</translation>
    </message>
    <message>
        <source>Joint accelerations where actions are joined, their 99th percentile over that inside recorded actions</source>
        <translation>Accélérations des articulations là où les actions se raccordent&#xa0;: leur 99e centile, rapporté à celui des actions enregistrées</translation>
    </message>
    <message>
        <source>facing</source>
        <translation>face-à-face</translation>
    </message>
    <message>
        <source>Mean angle between where a fighter faces and its opponent</source>
        <translation>Angle moyen entre la direction où un combattant regarde et son adversaire</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distance</translation>
    </message>
    <message>
        <source>Mean distance between both fighters</source>
        <translation>Distance moyenne entre les deux combattants</translation>
    </message>
    <message>
        <source>hit timing</source>
        <translation>à temps</translation>
    </message>
    <message>
        <source>How far reactions are from their due moment, on average</source>
        <translation>Écart moyen des réactions par rapport à leur moment voulu</translation>
    </message>
    <message>
        <source>variety</source>
        <translation>variété</translation>
    </message>
    <message>
        <source>Share of distinct runs of three labels; falls with length</source>
        <translation>Part des suites distinctes de trois étiquettes&#xa0;; baisse avec la durée</translation>
    </message>
    <message>
        <source>reacts first</source>
        <translation>réagit d’abord</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Avatar</source>
        <translation>Avatar</translation>
    </message>
    <message>
        <source>Passive</source>
        <translation>Passif</translation>
    </message>
    <message>
        <source>The model decides for both</source>
        <translation>Le modèle décide pour les deux</translation>
    </message>
    <message>
        <source>Keys and pointer lead one fighter, the model the other</source>
        <translation>Touches et pointeur guident un combattant, le modèle l’autre</translation>
    </message>
    <message>
        <source>One replays a captured attack that the model has not seen; the other answers and may not attack</source>
        <translation>L’un rejoue une attaque capturée que le modèle n’a pas vue&#xa0;; l’autre répond sans pouvoir attaquer</translation>
    </message>
    <message>
        <source>Under attack the avatar may answer before it does as asked</source>
        <translation>Attaqué, l’avatar peut répondre avant de faire ce qu’on lui demande</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>graine</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>The same seed gives the same bout</source>
        <translation>La même graine donne le même combat</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>0: always the likeliest; 1: as learnt; above: more even</source>
        <translation>0&#xa0;: toujours le plus probable&#xa0;; 1&#xa0;: comme appris&#xa0;; au-dessus&#xa0;: plus uniforme</translation>
    </message>
    <message>
        <source>State of the bout</source>
        <translation>État du combat</translation>
    </message>
    <message>
        <source>Why this?</source>
        <translation>Pourquoi cela&#xa0;?</translation>
    </message>
    <message>
        <source>The choice</source>
        <translation>Le choix</translation>
    </message>
    <message>
        <source>What else it could have done</source>
        <translation>Ce qu’il aurait pu faire d’autre</translation>
    </message>
    <message>
        <source>A click takes another one and goes on from there</source>
        <translation>Un clic en prend un autre et continue à partir de là</translation>
    </message>
    <message>
        <source>It cannot be taken: %1.</source>
        <translation>Impossible de le prendre&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>Measures all that was shown, beside the longest recording</source>
        <translation>Mesure tout ce qui a été montré, à côté de l’enregistrement le plus long</translation>
    </message>
    <message>
        <source>Quality of the bout and of the recording</source>
        <translation>Qualité du combat et de l’enregistrement</translation>
    </message>
    <message>
        <source>bout</source>
        <translation>combat</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>enregistré</translation>
    </message>
    <message>
        <source>attacker</source>
        <translation>attaquant</translation>
    </message>
    <message>
        <source>avatar</source>
        <translation>avatar</translation>
    </message>
    <message>
        <source>Who attacks</source>
        <translation>Qui attaque</translation>
    </message>
    <message>
        <source>Who is led</source>
        <translation>Qui est guidé</translation>
    </message>
    <message>
        <source>The fighter that replays a captured attack</source>
        <translation>Le combattant qui rejoue une attaque capturée</translation>
    </message>
    <message>
        <source>The fighter that keys and clicks on the floor lead</source>
        <translation>Le combattant que guident les touches et les clics sur le sol</translation>
    </message>
    <message>
        <source>A bout is being prepared.</source>
        <translation>Un combat se prépare.</translation>
    </message>
    <message>
        <source>Keys 1 to 9 ask the avatar for something, a click on the floor says where to be.</source>
        <translation>Les touches 1 à 9 demandent quelque chose à l’avatar, un clic sur le sol dit où aller.</translation>
    </message>
    <message>
        <source>Asked for: %1</source>
        <translation>Demandé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Labels or boundaries changed: begin anew to use them.</source>
        <translation>Des étiquettes ou des limites ont changé&#xa0;: recommencez à neuf pour les utiliser.</translation>
    </message>
    <message>
        <source>Each choice, with all that could have been, appears here.</source>
        <translation>Chaque choix, avec tout ce qui aurait été possible, apparaît ici.</translation>
    </message>
    <message>
        <source>%1 at %2, after %3, while %4</source>
        <translation>%1 à %2, après %3, face à %4</translation>
    </message>
    <message>
        <source>: replayed</source>
        <translation>&#xa0;: rejoué</translation>
    </message>
    <message>
        <source>: chosen by hand</source>
        <translation>&#xa0;: choisi à la main</translation>
    </message>
    <message>
        <source>: as asked for</source>
        <translation>&#xa0;: comme demandé</translation>
    </message>
    <message>
        <source> (no other stance was left)</source>
        <translation> (il ne restait aucun autre appui)</translation>
    </message>
    <message>
        <source>Measure (%1 s)</source>
        <translation>Mesurer (%1 s)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutSession</name>
    <message>
        <source>anything</source>
        <translation>n’importe quoi</translation>
    </message>
    <message>
        <source>Preparing a bout</source>
        <translation>Préparation d’un combat</translation>
    </message>
    <message>
        <source>Measuring the bout</source>
        <translation>Mesure du combat</translation>
    </message>
</context>
<context>
    <name>kumite::studio::BoutStrip</name>
    <message>
        <source>Actions of the bout</source>
        <translation>Actions du combat</translation>
    </message>
    <message>
        <source>%1 · %2 to %3 · %4</source>
        <translation>%1 · %2 à %3 · %4</translation>
    </message>
    <message>
        <source>   ·   as asked for</source>
        <translation>   ·   comme demandé</translation>
    </message>
    <message>
        <source>   ·   chosen by hand</source>
        <translation>   ·   choisi à la main</translation>
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
        <translation>étiq. %1</translation>
    </message>
    <message>
        <source>geom. %1</source>
        <translation>géom. %1</translation>
    </message>
    <message>
        <source>both %1</source>
        <translation>les deux %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CandidatesModel</name>
    <message>
        <source>no example</source>
        <translation>aucun exemple</translation>
    </message>
    <message>
        <source>not in this mode</source>
        <translation>pas dans ce mode</translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation>pas demandé</translation>
    </message>
    <message>
        <source>other stance</source>
        <translation>autre appui</translation>
    </message>
    <message>
        <source>banned</source>
        <translation>exclu</translation>
    </message>
    <message>
        <source>%1: chance %2, label term %3, geometry term %4, product %5</source>
        <translation>%1&#xa0;: chance %2, terme d’étiquette %3, terme géométrique %4, produit %5</translation>
    </message>
    <message>
        <source>
Sample: %1, %2</source>
        <translation>
Exemple&#xa0;: %1, %2</translation>
    </message>
    <message>
        <source>
Could not be drawn: %1</source>
        <translation>
N’a pas pu être tiré&#xa0;: %1</translation>
    </message>
    <message>
        <source>
This was chosen</source>
        <translation>
C’est lui qui a été choisi</translation>
    </message>
    <message>
        <source>
A click takes it instead</source>
        <translation>
Un clic le prend à la place</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ClusterMap</name>
    <message>
        <source>Map of poses</source>
        <translation>Carte des poses</translation>
    </message>
    <message>
        <source>A map of the poses appears here: like ones near each other, and the way that a transition takes.</source>
        <translation>Une carte des poses apparaît ici&#xa0;: les semblables y sont voisines, avec le chemin que suit une transition.</translation>
    </message>
    <message>
        <source>%1 kinds of poses, like ones near each other · line: what leads where</source>
        <translation>%1 sortes de poses, les semblables voisines · trait&#xa0;: ce qui mène où</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CommandPalette</name>
    <message>
        <source> · on</source>
        <translation> · activé</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Tapez ce que vous voulez faire</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>A name, a menu or a word for it: ↑ ↓ choose, Return runs, Esc leaves</source>
        <translation>Un nom, un menu ou un mot&#xa0;: ↑ ↓ choisissent, Entrée exécute, Échap quitte</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>%1 · “%2”</source>
        <translation>%1 · «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>No command that can be run now is called “%1”.</source>
        <translation>Aucune commande utilisable maintenant ne s’appelle «&#xa0;%1&#xa0;».</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CompareBox</name>
    <message>
        <source>Compare with settings B</source>
        <translation>Comparer aux réglages B</translation>
    </message>
    <message>
        <source> B</source>
        <translation> B</translation>
    </message>
    <message>
        <source>Use B</source>
        <translation>Utiliser B</translation>
    </message>
    <message>
        <source>Draw beside the project&apos;s boundaries (A) those that other settings give</source>
        <translation>Dessiner à côté des limites du projet (A) celles que donnent d’autres réglages</translation>
    </message>
    <message>
        <source>Boundaries that differ</source>
        <translation>Limites qui diffèrent</translation>
    </message>
    <message>
        <source>On the timeline: ○ only in A, dotted lines only in B</source>
        <translation>Sur la ligne de temps&#xa0;: ○ dans A seul, pointillés dans B seul</translation>
    </message>
    <message>
        <source>Cut the project by settings B</source>
        <translation>Découper le projet selon les réglages B</translation>
    </message>
    <message>
        <source>Comparing settings</source>
        <translation>Comparaison des réglages</translation>
    </message>
    <message>
        <source>%1: %2 in both, %3 only A, %4 only B</source>
        <translation>%1&#xa0;: %2 dans les deux, %3 dans A seul, %4 dans B seul</translation>
    </message>
</context>
<context>
    <name>kumite::studio::CompareLabelsBox</name>
    <message>
        <source>Take theirs</source>
        <translation>Prendre la leur</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Garder la mienne</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>aspect</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
    </message>
    <message>
        <source>same</source>
        <translation>égales</translation>
    </message>
    <message>
        <source>κ</source>
        <translation>κ</translation>
    </message>
    <message>
        <source>Agreement per aspect</source>
        <translation>Accord par aspect</translation>
    </message>
    <message>
        <source>Both: actions of which both people said something. κ (Cohen): how much more often they say the same than by chance; 1 always, 0 as often as by chance.</source>
        <translation>Les deux&#xa0;: actions dont les deux personnes ont dit quelque chose. κ (Cohen)&#xa0;: combien elles s’accordent plus souvent que par hasard&#xa0;; 1 toujours, 0 aussi souvent que par hasard.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Différences</translation>
    </message>
    <message>
        <source>Their value, as said by a hand; goes on to the next (Enter)</source>
        <translation>Leur valeur, comme dite à la main&#xa0;; passe à la suivante (Entrée)</translation>
    </message>
    <message>
        <source>What the project says stays; goes on to the next (Backspace)</source>
        <translation>Ce que dit le projet reste&#xa0;; passe à la suivante (Retour arrière)</translation>
    </message>
    <message>
        <source>Theirs for all that are not decided, as one step of the history</source>
        <translation>La leur pour toutes celles qui restent à décider, en une étape de l’historique</translation>
    </message>
    <message>
        <source>Their labels where you have none, as said by a hand, in one step</source>
        <translation>Leurs étiquettes là où vous n’en avez pas, comme dites à la main, en une étape</translation>
    </message>
    <message>
        <source>The boundaries have changed. Open %1 once more to compare.</source>
        <translation>Les limites ont changé. Rouvrez %1 pour comparer.</translation>
    </message>
    <message>
        <source>Another person&apos;s labels are compared here with those of the project: Label &gt; Compare with labels of… opens their file.</source>
        <translation>Les étiquettes d’une autre personne sont comparées ici à celles du projet&#xa0;: Étiquetage &gt; Comparer aux étiquettes de… ouvre leur fichier.</translation>
    </message>
    <message>
        <source>%1: 1 action labelled by both, %2 alike</source>
        <translation>%1&#xa0;: 1 action étiquetée par les deux, %2 pareille</translation>
    </message>
    <message>
        <source>%1: %3 actions labelled by both, %2 alike</source>
        <translation>%1&#xa0;: %3 actions étiquetées par les deux, %2 pareilles</translation>
    </message>
    <message>
        <source>, κ %1</source>
        <translation>, κ %1</translation>
    </message>
    <message>
        <source>. No difference to decide.</source>
        <translation>. Aucune différence à décider.</translation>
    </message>
    <message>
        <source>. 1 difference to decide.</source>
        <translation>. 1 différence à décider.</translation>
    </message>
    <message>
        <source>. %1 differences to decide.</source>
        <translation>. %1 différences à décider.</translation>
    </message>
    <message>
        <source> Only you labelled %1 more.</source>
        <translation> Vous seul en avez étiqueté %1 de plus.</translation>
    </message>
    <message>
        <source>Theirs for all %1</source>
        <translation>La leur pour les %1</translation>
    </message>
    <message>
        <source>Add the 1 that only they labelled</source>
        <translation>Ajouter la seule étiquetée par eux seuls</translation>
    </message>
    <message>
        <source>Add the %1 that only they labelled</source>
        <translation>Ajouter les %1 étiquetées par eux seuls</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ConfusionMatrix</name>
    <message>
        <source>no answer</source>
        <translation>sans réponse</translation>
    </message>
    <message>
        <source>Confusion matrix</source>
        <translation>Matrice de confusion</translation>
    </message>
    <message>
        <source>by rule</source>
        <translation>par règle</translation>
    </message>
    <message>
        <source>by machine</source>
        <translation>par machine</translation>
    </message>
    <message>
        <source>%1 by hand and %2: </source>
        <translation>%1 à la main et %2&#xa0;: </translation>
    </message>
    <message>
        <source>%1 by hand, %2 %3: </source>
        <translation>%1 à la main, %2 %3&#xa0;: </translation>
    </message>
    <message>
        <source>1 action</source>
        <translation>1 action</translation>
    </message>
    <message>
        <source>%1 actions</source>
        <translation>%1 actions</translation>
    </message>
    <message>
        <source>, %1 of %2</source>
        <translation>, %1 sur %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DetectionBox</name>
    <message>
        <source>Warning about the cutoff</source>
        <translation>Avertissement sur la coupure</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DifferencesModel</name>
    <message>
        <source>%1, %2, %3: mine %4, theirs %5</source>
        <translation>%1, %2, %3&#xa0;: moi %4, eux %5</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>aspect</translation>
    </message>
    <message>
        <source>mine</source>
        <translation>moi</translation>
    </message>
    <message>
        <source>theirs</source>
        <translation>eux</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DistanceGridView</name>
    <message>
        <source>Distances of poses where motions are joined</source>
        <translation>Distances des poses au raccord des mouvements</translation>
    </message>
    <message>
        <source>How far the poses are from each other: the last frames of what was there down, the first frames of what comes in to the right. The stronger the colour, the nearer they are; the ring is where both were joined.</source>
        <translation>Écart entre les poses&#xa0;: vers le bas les dernières images de ce qui était là, vers la droite les premières de ce qui arrive. Plus la couleur est forte, plus elles sont proches&#xa0;; l’anneau est là où elles sont raccordées.</translation>
    </message>
    <message>
        <source>frames that come in →</source>
        <translation>images qui arrivent →</translation>
    </message>
    <message>
        <source>← frames there</source>
        <translation>← images en place</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Document</name>
    <message>
        <source>The force curves are still being computed; try again in a moment.</source>
        <translation>Les courbes de force sont encore en calcul&#xa0;; réessayez dans un instant.</translation>
    </message>
    <message>
        <source>Computing force curves</source>
        <translation>Calcul des courbes de force</translation>
    </message>
</context>
<context>
    <name>kumite::studio::DocumentPanel</name>
    <message>
        <source>Add recordings to begin a take.</source>
        <translation>Ajoutez des enregistrements pour commencer une prise.</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Prises</translation>
    </message>
    <message>
        <source>Fighters</source>
        <translation>Combattants</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source> (missing)</source>
        <translation> (manquant)</translation>
    </message>
    <message>
        <source>%1: %2
%3 Hz, %4 frames
Double-click: start, place, floor, joints</source>
        <translation>%1&#xa0;: %2
%3 Hz, %4 images
Double-clic&#xa0;: début, place, sol, articulations</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FighterProperties</name>
    <message>
        <source>Fighter properties</source>
        <translation>Propriétés du combattant</translation>
    </message>
    <message>
        <source>Fighter</source>
        <translation>Combattant</translation>
    </message>
    <message>
        <source>Whose properties are shown: the active fighter&apos;s (Tab)</source>
        <translation>De qui sont les propriétés&#xa0;: du combattant actif (Tab)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Start in seconds</source>
        <translation>Début en secondes</translation>
    </message>
    <message>
        <source>When its first frame stands on the clock of the take; puts the fighters in step.</source>
        <translation>Quand sa première image se place sur l’horloge de la prise&#xa0;; met les combattants au pas.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Starts at</source>
        <translation>Commence à</translation>
    </message>
    <message>
        <source>Place in the bout</source>
        <translation>Place dans le combat</translation>
    </message>
    <message>
        <source>x in metres</source>
        <translation>x en mètres</translation>
    </message>
    <message>
        <source>Shifts the fighter to the side.</source>
        <translation>Décale le combattant sur le côté.</translation>
    </message>
    <message>
        <source>z in metres</source>
        <translation>z en mètres</translation>
    </message>
    <message>
        <source>Shifts the fighter forward or back.</source>
        <translation>Décale le combattant vers l’avant ou l’arrière.</translation>
    </message>
    <message>
        <source>Turn in degrees</source>
        <translation>Rotation en degrés</translation>
    </message>
    <message>
        <source>Turns the fighter about the origin of its recording, before it is shifted.</source>
        <translation>Tourne le combattant autour de l’origine de son enregistrement, avant de le décaler.</translation>
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
        <translation>Tourné de</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>found from the feet</source>
        <translation>trouvé d’après les pieds</translation>
    </message>
    <message>
        <source>The height at which the feet rest; switch it off to set the floor by hand.</source>
        <translation>La hauteur où reposent les pieds&#xa0;; désactivez pour fixer le sol à la main.</translation>
    </message>
    <message>
        <source>Height of the floor in metres</source>
        <translation>Hauteur du sol en mètres</translation>
    </message>
    <message>
        <source>Where the floor is in the space of the recording.</source>
        <translation>Où est le sol dans l’espace de l’enregistrement.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Body model of the project</source>
        <translation>Modèle corporel du projet</translation>
    </message>
    <message>
        <source>Body model</source>
        <translation>Modèle corporel</translation>
    </message>
    <message>
        <source>How the mass is spread over the body: what the centre of mass and with it the contact force are made of.</source>
        <translation>Comment la masse est répartie sur le corps&#xa0;: de là viennent le centre de masse et, avec lui, la force de contact.</translation>
    </message>
    <message>
        <source>Which joint is what</source>
        <translation>Rôle des articulations</translation>
    </message>
    <message>
        <source>Joint of the role %1</source>
        <translation>Articulation du rôle %1</translation>
    </message>
    <message>
        <source>The joint of the recording that is the %1 of the body.</source>
        <translation>L’articulation de l’enregistrement qui est la partie «&#xa0;%1&#xa0;» du corps.</translation>
    </message>
    <message>
        <source>Start, place, floor and joints of a fighter appear here as soon as there is a take.</source>
        <translation>Début, place, sol et articulations d’un combattant apparaissent ici dès qu’il y a une prise.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 Hz, frames %2 to %3 of %4, %5 joints</source>
        <translation>%1 Hz, images %2 à %3 sur %4, %5 articulations</translation>
    </message>
    <message>
        <source>one unit is %1 m, %2 is up</source>
        <translation>une unité vaut %1 m, %2 est le haut</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>The recording is missing: File, Find recording.</source>
        <translation>L’enregistrement manque&#xa0;: Fichier, Trouver l’enregistrement.</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>D’un fichier…</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>1 role has no joint.</source>
        <translation>1 rôle est sans articulation.</translation>
    </message>
    <message>
        <source>%1 roles have no joint.</source>
        <translation>%1 rôles sont sans articulation.</translation>
    </message>
    <message>
        <source>Open a body model</source>
        <translation>Ouvrir un modèle corporel</translation>
    </message>
    <message>
        <source>Body models (*.json)</source>
        <translation>Modèles corporels (*.json)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FileActions</name>
    <message>
        <source>A project opens alone: choose one .kumite file, or one or two recordings.</source>
        <translation>Un projet s’ouvre seul&#xa0;: choisissez un fichier .kumite, ou un ou deux enregistrements.</translation>
    </message>
    <message>
        <source>A take has one or two fighters: choose one or two recordings, not %1.</source>
        <translation>Une prise a un ou deux combattants&#xa0;: choisissez un ou deux enregistrements, pas %1.</translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation>Ouvert ailleurs</translation>
    </message>
    <message>
        <source>%1 is open in another studio.</source>
        <translation>%1 est ouvert dans un autre studio.</translation>
    </message>
    <message>
        <source>A copy can be changed and saved under another name. Taking over, you save into this file, and so may the other.</source>
        <translation>Une copie peut être modifiée et enregistrée sous un autre nom. En reprenant la main, vous enregistrez dans ce fichier, et l’autre peut le faire aussi.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Ouvrir une copie</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>Found in %1</source>
        <translation>Constats dans %1</translation>
    </message>
    <message>
        <source>Making the demo bout</source>
        <translation>Création du combat de démonstration</translation>
    </message>
    <message>
        <source>The demo bout: two made fighters. Save it to keep what you change.</source>
        <translation>Le combat de démonstration&#xa0;: deux combattants fabriqués. Enregistrez-le pour garder vos modifications.</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>Récupération de %1</translation>
    </message>
    <message>
        <source>Found while recovering</source>
        <translation>Constats à la récupération</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Found in the recordings</source>
        <translation>Constats dans les enregistrements</translation>
    </message>
    <message>
        <source>Open one or two recordings</source>
        <translation>Ouvrir un ou deux enregistrements</translation>
    </message>
    <message>
        <source>Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)</source>
        <translation>Enregistrements (*.bvh *.BVH *.amc *.AMC);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Ouvrir un projet</translation>
    </message>
    <message>
        <source>Kumite projects (*.kumite)</source>
        <translation>Projets Kumite (*.kumite)</translation>
    </message>
    <message>
        <source>Where is %1 of %2?</source>
        <translation>Où est %1 de %2&#xa0;?</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Enregistrement de %1</translation>
    </message>
    <message>
        <source>Found while saving</source>
        <translation>Constats à l’enregistrement</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 est enregistré.</translation>
    </message>
    <message>
        <source>Save all the same</source>
        <translation>Enregistrer quand même</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Changed on the disk</source>
        <translation>Modifié sur le disque</translation>
    </message>
    <message>
        <source>%1 was changed outside this window since you opened it.</source>
        <translation>%1 a été modifié hors de cette fenêtre depuis que vous l’avez ouvert.</translation>
    </message>
    <message>
        <source>It was written %1. If you save over it, what it holds now is kept as a version.</source>
        <translation>Il a été écrit %1. Si vous l’écrasez, son contenu actuel est gardé comme version.</translation>
    </message>
    <message>
        <source>Save over it</source>
        <translation>Écraser</translation>
    </message>
    <message>
        <source>Export the actions of this take</source>
        <translation>Exporter les actions de cette prise</translation>
    </message>
    <message>
        <source>Table of actions (*.csv);;Segmentation (*.json)</source>
        <translation>Tableau des actions (*.csv);;Segmentation (*.json)</translation>
    </message>
    <message>
        <source>Export the motion of this take</source>
        <translation>Exporter le mouvement de cette prise</translation>
    </message>
    <message>
        <source>Motion, one file per fighter (*.bvh)</source>
        <translation>Mouvement, un fichier par combattant (*.bvh)</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Export de %1</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1 est exporté.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
    <message>
        <source>Reading the version of %1</source>
        <translation>Lecture de la version de %1</translation>
    </message>
    <message>
        <source>Found in the version</source>
        <translation>Constats dans la version</translation>
    </message>
    <message>
        <source>Restored the version of %1; Ctrl+Z takes it back.</source>
        <translation>Version de %1 restaurée&#xa0;; Ctrl+Z y revient.</translation>
    </message>
    <message>
        <source>That version is what is open.</source>
        <translation>Cette version est celle qui est ouverte.</translation>
    </message>
    <message>
        <source>The version of %1 is open as a copy.</source>
        <translation>La version de %1 est ouverte comme copie.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Enregistrer les modifications de %1&#xa0;?</translation>
    </message>
    <message>
        <source>What is not saved is lost.</source>
        <translation>Ce qui n’est pas enregistré est perdu.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FindBox</name>
    <message>
        <source>Actions found</source>
        <translation>Actions trouvées</translation>
    </message>
    <message>
        <source>right kick up, machine, below 0.6</source>
        <translation>p. ex. right kick up, machine, below 0.6</translation>
    </message>
    <message>
        <source>Find actions</source>
        <translation>Trouver des actions</translation>
    </message>
    <message>
        <source>Aspects and qualifiers (kick, right punch fwd, jump none), who said it (by hand, machine, rule), how surely (uncertain, below 0.6), which fighter or take, when (after 1:20, longer than 1 s), unlabelled. All must hold; &quot;or&quot; joins two, &quot;not&quot; turns one round. Source and confidence are those of the aspects that are named.</source>
        <translation>Aspects et qualificatifs (kick, right punch fwd, jump none), qui l’a dit (by hand, machine, rule), avec quelle sûreté (uncertain, below 0.6), quel combattant ou quelle prise, quand (after 1:20, longer than 1 s), unlabelled pour sans étiquette. Tout doit être vrai&#xa0;; «&#xa0;or&#xa0;» en relie deux, «&#xa0;not&#xa0;» en inverse un. Source et confiance sont celles des aspects nommés.</translation>
    </message>
    <message>
        <source>What was understood</source>
        <translation>Ce qui a été compris</translation>
    </message>
    <message>
        <source>Choose all that were found in this take: the next label goes to all of them, as one step</source>
        <translation>Choisir toutes celles trouvées dans cette prise&#xa0;: l’étiquette suivante va à toutes, en une étape</translation>
    </message>
    <message>
        <source>1 action</source>
        <translation>1 action</translation>
    </message>
    <message>
        <source>%1 actions</source>
        <translation>%1 actions</translation>
    </message>
    <message>
        <source>Choose all %1</source>
        <translation>Choisir les %1</translation>
    </message>
    <message>
        <source>The actions of the bout appear here once a recording is cut.</source>
        <translation>Les actions du combat apparaissent ici dès qu’un enregistrement est découpé.</translation>
    </message>
    <message>
        <source>No action is like that.</source>
        <translation>Aucune action n’est ainsi.</translation>
    </message>
    <message>
        <source>Choose all</source>
        <translation>Tout choisir</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FindingsPage</name>
    <message>
        <source>Findings in the recordings</source>
        <translation>Constats sur les enregistrements</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Fermer cette page (Échap)</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>What is odd or worth knowing about the recordings of a project is listed here. There is nothing.</source>
        <translation>Ce qui est étrange ou bon à savoir sur les enregistrements d’un projet est listé ici. Il n’y a rien.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::FoundModel</name>
    <message>
        <source>%1, %2: %3, %4</source>
        <translation>%1, %2&#xa0;: %3, %4</translation>
    </message>
    <message>
        <source>, p %1</source>
        <translation>, p %1</translation>
    </message>
    <message>
        <source>Who says it; of several aspects the least sure</source>
        <translation>Qui le dit&#xa0;; de plusieurs aspects, le moins sûr</translation>
    </message>
    <message>
        <source>Confidence; of several aspects the least</source>
        <translation>Confiance&#xa0;; de plusieurs aspects, la plus faible</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>label</source>
        <translation>étiquette</translation>
    </message>
    <message>
        <source>by</source>
        <translation>par</translation>
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
        <translation>Matrice</translation>
    </message>
    <message>
        <source>Transitions as a matrix (V)</source>
        <translation>Transitions en matrice (V)</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Graphe</translation>
    </message>
    <message>
        <source>Transitions as circles and edges (V)</source>
        <translation>Transitions en cercles et arêtes (V)</translation>
    </message>
    <message>
        <source>What %1 does next (Tab)</source>
        <translation>Ce que %1 fait ensuite (Tab)</translation>
    </message>
    <message>
        <source>compared with nothing</source>
        <translation>comparé à rien</translation>
    </message>
    <message>
        <source>with the other fighter</source>
        <translation>à l’autre combattant</translation>
    </message>
    <message>
        <source>with labels by hand alone</source>
        <translation>aux étiquettes à la main seules</translation>
    </message>
    <message>
        <source>with EQU7</source>
        <translation>à EQU7</translation>
    </message>
    <message>
        <source>with EQU6</source>
        <translation>à EQU6</translation>
    </message>
    <message>
        <source>with EQU5</source>
        <translation>à EQU5</translation>
    </message>
    <message>
        <source>What it is compared with</source>
        <translation>À quoi cela est comparé</translation>
    </message>
    <message>
        <source>Compares with another, side by side or as a difference</source>
        <translation>Compare à un autre, côte à côte ou par différence</translation>
    </message>
    <message>
        <source>What each fighter tends to do next</source>
        <translation>Ce que chaque combattant tend à faire ensuite</translation>
    </message>
    <message>
        <source>Why nothing is shown</source>
        <translation>Pourquoi rien n’est affiché</translation>
    </message>
    <message>
        <source>Transitions are being learnt from the labels.</source>
        <translation>Les transitions s’apprennent d’après les étiquettes.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphCommands</name>
    <message>
        <source>Export transitions</source>
        <translation>Exporter les transitions</translation>
    </message>
    <message>
        <source>Edges as a table (*.csv);;Graph and model (*.json);;Graph (*.graphml);;Picture (*.png);;Picture of lines (*.svg)</source>
        <translation>Arêtes en tableau (*.csv);;Graphe et modèle (*.json);;Graphe (*.graphml);;Image (*.png);;Image vectorielle (*.svg)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Graph</source>
        <translation>&amp;Graphe</translation>
    </message>
    <message>
        <source>&amp;Matrix or graph</source>
        <translation>&amp;Matrice ou graphe</translation>
    </message>
    <message>
        <source>Graph in &amp;space</source>
        <translation>Graphe dans l’&amp;espace</translation>
    </message>
    <message>
        <source>&amp;Play what is behind it, the next each time</source>
        <translation>&amp;Lire ce qu’il y a derrière, le suivant à chaque fois</translation>
    </message>
    <message>
        <source>&amp;Next surprise</source>
        <translation>Surprise &amp;suivante</translation>
    </message>
    <message>
        <source>Pre&amp;vious surprise</source>
        <translation>Surprise &amp;précédente</translation>
    </message>
    <message>
        <source>Surprise of bo&amp;th terms</source>
        <translation>Surprise des &amp;deux termes</translation>
    </message>
    <message>
        <source>S&amp;urprise of the label term</source>
        <translation>Surprise du &amp;terme d’étiquette</translation>
    </message>
    <message>
        <source>Su&amp;rprise of the geometry term</source>
        <translation>Surprise du terme &amp;géométrique</translation>
    </message>
    <message>
        <source>Rows by &amp;own label</source>
        <translation>Lignes par étiquette p&amp;ropre</translation>
    </message>
    <message>
        <source>Ro&amp;ws by opponent&apos;s label</source>
        <translation>Lignes par étiquette de l’ad&amp;versaire</translation>
    </message>
    <message>
        <source>Rows by &amp;both labels</source>
        <translation>Lignes par les deux éti&amp;quettes</translation>
    </message>
    <message>
        <source>Sort by &amp;count</source>
        <translation>Trier par &amp;nombre</translation>
    </message>
    <message>
        <source>Sort by n&amp;ame</source>
        <translation>Trier par n&amp;om</translation>
    </message>
    <message>
        <source>Sort by &amp;likeness</source>
        <translation>Trier par ressem&amp;blance</translation>
    </message>
    <message>
        <source>Lar&amp;ger cells</source>
        <translation>&amp;Agrandir les cellules</translation>
    </message>
    <message>
        <source>Smaller cells</source>
        <translation>Réduire les cellules</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>Tout a&amp;fficher</translation>
    </message>
    <message>
        <source>E&amp;xport transitions…</source>
        <translation>E&amp;xporter les transitions…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphExport</name>
    <message>
        <source>Transitions</source>
        <translation>Transitions</translation>
    </message>
    <message>
        <source>%1: the name must end in .csv, .json, .graphml, .png or .svg.</source>
        <translation>%1&#xa0;: le nom doit finir par .csv, .json, .graphml, .png ou .svg.</translation>
    </message>
    <message>
        <source>%1: it cannot be written there.</source>
        <translation>%1&#xa0;: impossible d’écrire à cet endroit.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphPanel</name>
    <message>
        <source>What a fighter does next, given what both are doing, and the moments of the recording behind each probability appear here.</source>
        <translation>Ce qu’un combattant fait ensuite, selon ce que font les deux, et les moments de l’enregistrement derrière chaque probabilité apparaissent ici.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphSession</name>
    <message>
        <source>%1: more often</source>
        <translation>%1&#xa0;: plus souvent</translation>
    </message>
    <message>
        <source>others</source>
        <translation>autres</translation>
    </message>
    <message>
        <source>label</source>
        <translation>étiquette</translation>
    </message>
    <message>
        <source>geometry</source>
        <translation>géométrie</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
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
        <translation>surprise %1 (%2 après avoir vu le mouvement)&#xa0;: étiquette %3 (%4), géométrie %5</translation>
    </message>
    <message>
        <source>Learning transitions</source>
        <translation>Apprentissage des transitions</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>n’importe quoi</translation>
    </message>
    <message>
        <source>all labels</source>
        <translation>toutes les étiquettes</translation>
    </message>
    <message>
        <source>labels by hand</source>
        <translation>étiquettes à la main</translation>
    </message>
</context>
<context>
    <name>kumite::studio::GraphView</name>
    <message>
        <source>Graph of transitions</source>
        <translation>Graphe des transitions</translation>
    </message>
    <message>
        <source>A node is a label, an edge leads to what follows. A click shows the moments behind it.</source>
        <translation>Un nœud est une étiquette, une arête mène à ce qui suit. Un clic montre les moments derrière.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Help</name>
    <message>
        <source>&amp;Help on this workspace</source>
        <translation>&amp;Aide sur cet espace</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>P&amp;remiers pas</translation>
    </message>
    <message>
        <source>What the &amp;numbers mean</source>
        <translation>Ce que disent les &amp;nombres</translation>
    </message>
    <message>
        <source>&amp;What is this? Click on it</source>
        <translation>&amp;Qu’est-ce que c’est&#xa0;? Cliquez dessus</translation>
    </message>
    <message>
        <source>What has the f&amp;ocus?</source>
        <translation>&amp;Où est le focus&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Touches et souris</translation>
    </message>
    <message>
        <source>What is n&amp;ew</source>
        <translation>Nou&amp;veautés</translation>
    </message>
    <message>
        <source>&amp;About Kumite</source>
        <translation>À &amp;propos de Kumite</translation>
    </message>
    <message>
        <source>About Kumite</source>
        <translation>À propos de Kumite</translation>
    </message>
    <message>
        <source>Kumite %1

A studio for annotating two-player martial-arts motion capture.</source>
        <translation>Kumite %1

Un studio pour annoter la capture de mouvement d’arts martiaux à deux.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HelpWindow</name>
    <message>
        <source>The page before</source>
        <translation>La page précédente</translation>
    </message>
    <message>
        <source>On again</source>
        <translation>Avancer à nouveau</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Close the help (Esc)</source>
        <translation>Fermer l’aide (Échap)</translation>
    </message>
    <message>
        <source>Search all pages</source>
        <translation>Chercher dans toutes les pages</translation>
    </message>
    <message>
        <source>Shows the pages that hold all of these words. Return: the next place; Shift+Return: the one before. (Ctrl+F)</source>
        <translation>Affiche les pages qui contiennent tous ces mots. Entrée&#xa0;: l’endroit suivant&#xa0;; Maj+Entrée&#xa0;: le précédent. (Ctrl+F)</translation>
    </message>
    <message>
        <source>How often the words were found</source>
        <translation>Combien de fois les mots ont été trouvés</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>The pages of the help</source>
        <translation>Les pages de l’aide</translation>
    </message>
    <message>
        <source>The page</source>
        <translation>La page</translation>
    </message>
    <message>
        <source>Tab leads from link to link, Return follows one.</source>
        <translation>Tab mène de lien en lien, Entrée en suit un.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Found %1 times on this page</source>
        <translation>Trouvé %1 fois sur cette page</translation>
    </message>
    <message>
        <source>Show this page</source>
        <translation>Afficher cette page</translation>
    </message>
    <message>
        <source>No page holds these words.</source>
        <translation>Aucune page ne contient ces mots.</translation>
    </message>
    <message>
        <source>%1 of %2 on this page</source>
        <translation>%1 sur %2 dans cette page</translation>
    </message>
    <message>
        <source>%1 — Help</source>
        <translation>%1 — Aide</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HistoryModel</name>
    <message>
        <source>%1
The project as it is now.</source>
        <translation>%1
Le projet tel qu’il est maintenant.</translation>
    </message>
    <message>
        <source>%1
Click to go back to this state.</source>
        <translation>%1
Cliquez pour revenir à cet état.</translation>
    </message>
    <message>
        <source>%1
Undone. Click to redo up to here.</source>
        <translation>%1
Annulé. Cliquez pour rétablir jusqu’ici.</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, annulé</translation>
    </message>
    <message>
        <source>%1, now</source>
        <translation>%1, maintenant</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HitBox</name>
    <message>
        <source>Hit a target</source>
        <translation>Toucher une cible</translation>
    </message>
    <message>
        <source>Drag the target in the 3D view: the strike follows it. Dots: where whole examples hit; the box: what is reached.</source>
        <translation>Faites glisser la cible dans la vue 3D : la frappe la suit. Points : où frappent les exemples entiers ; boîte : ce qui est atteint.</translation>
    </message>
    <message>
        <source>Strike</source>
        <translation>Frappe</translation>
    </message>
    <message>
        <source>Which strike; its examples are the actions with that label</source>
        <translation>Quelle frappe&#xa0;; ses exemples sont les actions de cette étiquette</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>un lieu</translation>
    </message>
    <message>
        <source>Aim at</source>
        <translation>Viser</translation>
    </message>
    <message>
        <source>A place in space, or the opponent as the recording&apos;s playhead shows it; a click on its marks in the 3D view aims there</source>
        <translation>Un lieu de l’espace, ou l’adversaire tel que le montre la tête de lecture ; un clic sur ses repères dans la vue 3D le vise</translation>
    </message>
    <message>
        <source>Distance of the opponent, metres</source>
        <translation>Distance de l’adversaire, mètres</translation>
    </message>
    <message>
        <source>How far ahead the opponent stands, from pelvis to pelvis</source>
        <translation>À quelle distance devant se tient l’adversaire, de bassin à bassin</translation>
    </message>
    <message>
        <source>Away, m</source>
        <translation>Distance, m</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>vers la gauche</translation>
    </message>
    <message>
        <source>up</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>devant</translation>
    </message>
    <message>
        <source>Target, metres %1</source>
        <translation>Cible, mètres %1</translation>
    </message>
    <message>
        <source>Target, m</source>
        <translation>Cible, m</translation>
    </message>
    <message>
        <source>How well it is hit</source>
        <translation>Avec quelle précision elle est touchée</translation>
    </message>
    <message>
        <source>The strikes are being aligned.</source>
        <translation>Les frappes s’alignent.</translation>
    </message>
    <message>
        <source>A blend of whole examples reaches it.</source>
        <translation>Un mélange d’exemples entiers l’atteint.</translation>
    </message>
    <message>
        <source>No blend of whole examples reaches it: parts of the body are blended and turned.</source>
        <translation>Aucun mélange d’exemples entiers ne l’atteint&#xa0;: des parties du corps sont mélangées et tournées.</translation>
    </message>
    <message>
        <source>It is outside of the box that is reached.</source>
        <translation>Elle est hors de la zone accessible.</translation>
    </message>
    <message>
        <source>Hit, %1 cm off. %2 %3 examples.</source>
        <translation>Touchée, à %1 cm près. %2 %3 exemples.</translation>
    </message>
    <message>
        <source>Missed by %1 cm: the nearest that can be reached. %2 %3 examples.</source>
        <translation>Manquée de %1 cm&#xa0;: le plus près possible. %2 %3 exemples.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::HitSession</name>
    <message>
        <source>Aim at the opponent</source>
        <translation>Viser l’adversaire</translation>
    </message>
    <message>
        <source>Aim at a place</source>
        <translation>Viser un lieu</translation>
    </message>
    <message>
        <source>Opponent %1 m away</source>
        <translation>Adversaire à %1 m</translation>
    </message>
    <message>
        <source>Strike with %1</source>
        <translation>Frapper avec %1</translation>
    </message>
    <message>
        <source>Aligning the strikes</source>
        <translation>Alignement des frappes</translation>
    </message>
    <message>
        <source>Move the target</source>
        <translation>Déplacer la cible</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ImportDialog</name>
    <message>
        <source>Open recordings</source>
        <translation>Ouvrir des enregistrements</translation>
    </message>
    <message>
        <source>Not read. Choose the file again to read it.</source>
        <translation>Pas lu. Choisissez à nouveau le fichier pour le lire.</translation>
    </message>
    <message>
        <source>Choose a recording</source>
        <translation>Choisir un enregistrement</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Lecture…</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Start, place and floor of %1 must be numbers, such as 0.25.</source>
        <translation>Début, place et sol de %1 doivent être des nombres, comme 0.25.</translation>
    </message>
    <message>
        <source>Choose a recording for fighter 1.</source>
        <translation>Choisissez un enregistrement pour le combattant 1.</translation>
    </message>
    <message>
        <source>The rate must be a positive number of frames per second, such as 60.</source>
        <translation>La cadence doit être un nombre positif d’images par seconde, comme 60.</translation>
    </message>
    <message>
        <source>Frames read begin:end, such as 120:900; either may be left out.</source>
        <translation>Les images s’écrivent début:fin, comme 120:900&#xa0;; l’un ou l’autre peut manquer.</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Roles, %1 missing</source>
        <translation>Rôles, %1 manquants</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Rôles</translation>
    </message>
    <message>
        <source>&lt;b&gt;Check:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;À vérifier&#xa0;:&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>%1 (found)</source>
        <translation>%1 (détecté)</translation>
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
        <translation>comme détecté</translation>
    </message>
    <message>
        <source>%1:%2 of %3</source>
        <translation>%1:%2 sur %3</translation>
    </message>
    <message>
        <source>Hz; header: %1</source>
        <translation>Hz&#xa0;; en-tête&#xa0;: %1</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>begin:end</source>
        <translation>début:fin</translation>
    </message>
    <message>
        <source>Fighter %1</source>
        <translation>Combattant %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Path of the recording; the button beside it, or a drop, chooses one</source>
        <translation>Chemin de l’enregistrement&#xa0;; le bouton à côté, ou un dépôt, en choisit un</translation>
    </message>
    <message>
        <source>a .bvh or .amc file</source>
        <translation>un fichier .bvh ou .amc</translation>
    </message>
    <message>
        <source>none: a single fighter</source>
        <translation>aucun&#xa0;: un combattant seul</translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation>Squelette</translation>
    </message>
    <message>
        <source>Which skeleton of a file that holds several</source>
        <translation>Quel squelette d’un fichier qui en contient plusieurs</translation>
    </message>
    <message>
        <source>ASF skeleton</source>
        <translation>Squelette ASF</translation>
    </message>
    <message>
        <source>the one beside it</source>
        <translation>celui d’à côté</translation>
    </message>
    <message>
        <source>The .asf file that belongs to the .amc</source>
        <translation>Le fichier .asf qui va avec le .amc</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Unité de longueur</translation>
    </message>
    <message>
        <source>What one unit of the file is</source>
        <translation>Ce que vaut une unité du fichier</translation>
    </message>
    <message>
        <source>found</source>
        <translation>détecté</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Axe vertical</translation>
    </message>
    <message>
        <source>The file&apos;s axis that points up</source>
        <translation>L’axe du fichier qui pointe vers le haut</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Seconds on the take&apos;s clock at which its first frame stands</source>
        <translation>Secondes sur l’horloge de la prise où se place sa première image</translation>
    </message>
    <message>
        <source>Place x</source>
        <translation>Place x</translation>
    </message>
    <message>
        <source>Metres along x from where the file stands</source>
        <translation>Mètres le long de x depuis la position du fichier</translation>
    </message>
    <message>
        <source>Place z</source>
        <translation>Place z</translation>
    </message>
    <message>
        <source>Metres along z from where the file stands</source>
        <translation>Mètres le long de z depuis la position du fichier</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Degrees about the vertical, about the file&apos;s origin</source>
        <translation>Degrés autour de la verticale, à l’origine du fichier</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Height of the floor in the file, metres</source>
        <translation>Hauteur du sol dans le fichier, mètres</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Choose the recording of %1</source>
        <translation>Choisir l’enregistrement de %1</translation>
    </message>
    <message>
        <source>BVH, or AMC with its ASF; others go through Blender</source>
        <translation>BVH, ou AMC avec son ASF&#xa0;; les autres passent par Blender</translation>
    </message>
    <message>
        <source>Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)</source>
        <translation>Enregistrements (*.bvh *.BVH *.amc *.AMC);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>S&amp;wap</source>
        <translation>É&amp;changer</translation>
    </message>
    <message>
        <source>Swap fighters</source>
        <translation>Échanger les combattants</translation>
    </message>
    <message>
        <source>Fighter 1 becomes fighter 2, with all that is said of them (Alt+W)</source>
        <translation>Le combattant 1 devient le 2, avec tout ce qui est dit d’eux (Alt+W)</translation>
    </message>
    <message>
        <source>Take name</source>
        <translation>Nom de la prise</translation>
    </message>
    <message>
        <source>How the take is called in the project</source>
        <translation>Comment la prise s’appelle dans le projet</translation>
    </message>
    <message>
        <source>Rate in Hz</source>
        <translation>Cadence en Hz</translation>
    </message>
    <message>
        <source>as the header</source>
        <translation>comme l’en-tête</translation>
    </message>
    <message>
        <source>True frame rate, where the header is wrong: the preview shows it</source>
        <translation>Vraie cadence, si l’en-tête est faux&#xa0;: l’aperçu la montre</translation>
    </message>
    <message>
        <source>Frames, begin:end</source>
        <translation>Images, début:fin</translation>
    </message>
    <message>
        <source>Frames of the files; the end is the first frame left out. Empty: all, without a leading T-pose.</source>
        <translation>Images des fichiers&#xa0;; la fin est la première image exclue. Vide&#xa0;: toutes, sans pose en T initiale.</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Prise</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>ASF file</source>
        <translation>Fichier ASF</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Starts at, s</source>
        <translation>Commence à, s</translation>
    </message>
    <message>
        <source>Place x, m</source>
        <translation>Place x, m</translation>
    </message>
    <message>
        <source>Place z, m</source>
        <translation>Place z, m</translation>
    </message>
    <message>
        <source>Turned, °</source>
        <translation>Tourné, °</translation>
    </message>
    <message>
        <source>Floor, m</source>
        <translation>Sol, m</translation>
    </message>
    <message>
        <source>Add as a take to %1</source>
        <translation>Ajouter comme prise à %1</translation>
    </message>
    <message>
        <source>Otherwise it becomes a project of its own</source>
        <translation>Sinon, cela devient un projet à part</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Play or pause (Space in the preview, Alt+P)</source>
        <translation>Lecture ou pause (Espace dans l’aperçu, Alt+P)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>What was found in the recordings</source>
        <translation>Constats dans les enregistrements</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Open nothing (Esc)</source>
        <translation>Ne rien ouvrir (Échap)</translation>
    </message>
    <message>
        <source>Open bout</source>
        <translation>Ouvrir le combat</translation>
    </message>
    <message>
        <source>Make a take of these recordings (Enter)</source>
        <translation>Faire une prise de ces enregistrements (Entrée)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ImportPreview</name>
    <message>
        <source>Preview of both fighters</source>
        <translation>Aperçu des deux combattants</translation>
    </message>
    <message>
        <source>From above, from the side, and their distance over time</source>
        <translation>D’en haut, de côté, et leur distance au fil du temps</translation>
    </message>
    <message>
        <source>Space plays, ← → steps, a drag on the distance scrubs</source>
        <translation>Espace lit, ← → avancent par image, tirer sur la distance fait défiler</translation>
    </message>
    <message>
        <source>from above, grid %1 m</source>
        <translation>d’en haut, grille de %1 m</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>de côté</translation>
    </message>
    <message>
        <source>%1   distance %2 m</source>
        <translation>%1   distance %2 m</translation>
    </message>
    <message>
        <source>distance of the pelvises, m</source>
        <translation>distance des bassins, m</translation>
    </message>
    <message>
        <source>Both fighters move here once their recordings are read. Choose them above, or drop them here.</source>
        <translation>Les deux combattants bougent ici dès que leurs enregistrements sont lus. Choisissez-les au-dessus, ou déposez-les ici.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JobBar</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JobRunner</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Il n’y a pas assez de mémoire pour cela.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::JointBox</name>
    <message>
        <source>Joint</source>
        <translation>Articulation</translation>
    </message>
    <message>
        <source>Joint to turn</source>
        <translation>Articulation à tourner</translation>
    </message>
    <message>
        <source>Which joint has rings in the 3D view; J chooses the next one</source>
        <translation>Quelle articulation a des anneaux dans la vue 3D ; J choisit la suivante</translation>
    </message>
    <message>
        <source>Turn about %1, degrees</source>
        <translation>Tourner autour de %1, degrés</translation>
    </message>
    <message>
        <source>About the parent&apos;s %1, degrees; turned about y first, then x, then z</source>
        <translation>Autour de %1 du parent, degrés ; d’abord autour de y, puis x, puis z</translation>
    </message>
    <message>
        <source>x y z, °</source>
        <translation>x, y, z, °</translation>
    </message>
    <message>
        <source>How much of the joint&apos;s limits that takes</source>
        <translation>Quelle part des limites de l’articulation cela prend</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Bent by %1° of %2°, twisted by %3° of %4° from rest.</source>
        <translation>Fléchie de %1° sur %2°, tournée de %3° sur %4° depuis le repos.</translation>
    </message>
    <message>
        <source>This joint has no limits.</source>
        <translation>Cette articulation n’a pas de limites.</translation>
    </message>
    <message>
        <source>A chosen joint has rings in the 3D view: drag one to turn it.</source>
        <translation>Une articulation choisie a des anneaux dans la vue 3D : faites-en glisser un pour la tourner.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyBar</name>
    <message>
        <source>Time of the keys</source>
        <translation>Temps des clés</translation>
    </message>
    <message>
        <source>the strike</source>
        <translation>la frappe</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source> · the motion</source>
        <translation> · le mouvement</translation>
    </message>
    <message>
        <source> · the keys</source>
        <translation> · les clés</translation>
    </message>
    <message>
        <source> · beside it without adjustment</source>
        <translation> · à côté, sans ajustement</translation>
    </message>
    <message>
        <source> · out of reach by %1 cm</source>
        <translation> · hors de portée de %1 cm</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyCommands</name>
    <message>
        <source>Ke&amp;yframe</source>
        <translation>P&amp;oses clés</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lire ou suspendre</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Une image en arrière</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Une image en avant</translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation>Dix images en arrière</translation>
    </message>
    <message>
        <source>Ten frames on</source>
        <translation>Dix images en avant</translation>
    </message>
    <message>
        <source>To the first key</source>
        <translation>À la première clé</translation>
    </message>
    <message>
        <source>To the last key</source>
        <translation>À la dernière clé</translation>
    </message>
    <message>
        <source>Show the &amp;motion instead of the keys</source>
        <translation>Afficher le &amp;mouvement au lieu des clés</translation>
    </message>
    <message>
        <source>Beside it the motion without a&amp;djustment</source>
        <translation>À côté, le mouvement sans aj&amp;ustement</translation>
    </message>
    <message>
        <source>Keys before and after as &amp;ghosts</source>
        <translation>Poses d’avant et d’après en &amp;fantômes</translation>
    </message>
    <message>
        <source>&amp;Hit a target</source>
        <translation>Toucher une ci&amp;ble</translation>
    </message>
    <message>
        <source>&amp;Add a key here</source>
        <translation>&amp;Ajouter une clé ici</translation>
    </message>
    <message>
        <source>&amp;Remove the key</source>
        <translation>&amp;Supprimer la clé</translation>
    </message>
    <message>
        <source>Key before</source>
        <translation>Clé précédente</translation>
    </message>
    <message>
        <source>Key after</source>
        <translation>Clé suivante</translation>
    </message>
    <message>
        <source>Move the key earlier</source>
        <translation>Déplacer la clé plus tôt</translation>
    </message>
    <message>
        <source>Move the key later</source>
        <translation>Déplacer la clé plus tard</translation>
    </message>
    <message>
        <source>Move the key and later ones earlier</source>
        <translation>Cette pose et les suivantes plus tôt</translation>
    </message>
    <message>
        <source>Move the key and later ones later</source>
        <translation>Cette pose et les suivantes plus tard</translation>
    </message>
    <message>
        <source>Later keys closer together</source>
        <translation>Poses suivantes plus serrées</translation>
    </message>
    <message>
        <source>Later keys farther apart</source>
        <translation>Poses suivantes plus espacées</translation>
    </message>
    <message>
        <source>&amp;Copy the key to the playhead, or behind the last</source>
        <translation>&amp;Copier la clé à la tête de lecture, ou après la dernière</translation>
    </message>
    <message>
        <source>M&amp;irror the pose</source>
        <translation>Pose en mi&amp;roir</translation>
    </message>
    <message>
        <source>&amp;Take the pose that the recording shows</source>
        <translation>&amp;Prendre la pose que montre l’enregistrement</translation>
    </message>
    <message>
        <source>Copy the pose from an&amp;y take or clip…</source>
        <translation>Cop&amp;ier la pose d’une prise ou d’un clip…</translation>
    </message>
    <message>
        <source>The handle &amp;stays where it is, or not</source>
        <translation>La poignée reste e&amp;n place, ou non</translation>
    </message>
    <message>
        <source>Next handle</source>
        <translation>Poignée suivante</translation>
    </message>
    <message>
        <source>Next &amp;joint to turn</source>
        <translation>Articulation suivante à &amp;tourner</translation>
    </message>
    <message>
        <source>Joint before</source>
        <translation>Articulation précédente</translation>
    </message>
    <message>
        <source>Handle up</source>
        <translation>Poignée vers le haut</translation>
    </message>
    <message>
        <source>Handle down</source>
        <translation>Poignée vers le bas</translation>
    </message>
    <message>
        <source>Handle toward −x</source>
        <translation>Poignée vers −x</translation>
    </message>
    <message>
        <source>Handle toward +x</source>
        <translation>Poignée vers +x</translation>
    </message>
    <message>
        <source>Handle toward −z</source>
        <translation>Poignée vers −z</translation>
    </message>
    <message>
        <source>Handle toward +z</source>
        <translation>Poignée vers +z</translation>
    </message>
    <message>
        <source>The body from anywhere again</source>
        <translation>Le corps de n’importe où, à nouveau</translation>
    </message>
    <message>
        <source>Take the body from anywhere</source>
        <translation>Prendre le corps de n’importe où</translation>
    </message>
    <message>
        <source>Remove all keys</source>
        <translation>Supprimer toutes les clés</translation>
    </message>
    <message>
        <source>Add clips of &amp;files…</source>
        <translation>A&amp;jouter des clips de fichiers…</translation>
    </message>
    <message>
        <source>Add cl&amp;ips of a folder…</source>
        <translation>Ajouter des clips d’un &amp;dossier…</translation>
    </message>
    <message>
        <source>R&amp;eplace a part of a take…</source>
        <translation>&amp;Remplacer une partie d’une prise…</translation>
    </message>
    <message>
        <source>&amp;Keep as a take…</source>
        <translation>&amp;Garder comme prise…</translation>
    </message>
    <message>
        <source>E&amp;xport the motion…</source>
        <translation>&amp;Exporter le mouvement…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyEditor</name>
    <message>
        <source>Remove keys</source>
        <translation>Supprimer les touches</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>Tout réinitialiser</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Chercher des commandes</translation>
    </message>
    <message>
        <source>Shows the commands whose name, menu or key holds these letters.</source>
        <translation>Affiche les commandes dont le nom, le menu ou la touche contient ces lettres.</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Commandes et leurs touches</translation>
    </message>
    <message>
        <source>Choose a command, then press its key in the field below</source>
        <translation>Choisissez une commande, puis pressez sa touche dans le champ ci-dessous</translation>
    </message>
    <message>
        <source>command</source>
        <translation>commande</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>menu</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>touches</translation>
    </message>
    <message>
        <source>The chosen command gets the key in the field.</source>
        <translation>La commande choisie reçoit la touche du champ.</translation>
    </message>
    <message>
        <source>The chosen command is run from menus and the palette only.</source>
        <translation>La commande choisie ne se lance plus que par les menus et la palette.</translation>
    </message>
    <message>
        <source>The chosen command gets back the keys that the studio brings.</source>
        <translation>La commande choisie retrouve les touches fournies par le studio.</translation>
    </message>
    <message>
        <source>All commands get back the keys that the studio brings.</source>
        <translation>Toutes les commandes retrouvent les touches fournies par le studio.</translation>
    </message>
    <message>
        <source>Your own; the studio brings: %1</source>
        <translation>La vôtre&#xa0;; le studio fournit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Attribuer</translation>
    </message>
    <message>
        <source>Choose a command to give it another key.</source>
        <translation>Choisissez une commande pour lui donner une autre touche.</translation>
    </message>
    <message>
        <source>Press the new key for “%1” in the field.</source>
        <translation>Pressez la nouvelle touche de «&#xa0;%1&#xa0;» dans le champ.</translation>
    </message>
    <message>
        <source>%1 is its key already.</source>
        <translation>%1 est déjà sa touche.</translation>
    </message>
    <message>
        <source>%1 is free.</source>
        <translation>%1 est libre.</translation>
    </message>
    <message>
        <source>Take it over</source>
        <translation>La reprendre</translation>
    </message>
    <message>
        <source>%1 is the key of %2. Taking it over leaves that command without it.</source>
        <translation>%1 est la touche de %2. La reprendre en prive cette commande.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyField</name>
    <message>
        <source>Press a key</source>
        <translation>Pressez une touche</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nouvelle touche</translation>
    </message>
    <message>
        <source>Press the key here, alone or with Ctrl, Shift, Alt; then Tab goes on, and Shift+Tab always goes back</source>
        <translation>Pressez la touche ici, seule ou avec Ctrl, Maj, Alt&#xa0;; ensuite Tab avance, et Maj+Tab recule toujours</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyPanel</name>
    <message>
        <source>What appears here</source>
        <translation>Ce qui apparaît ici</translation>
    </message>
    <message>
        <source>Key pose</source>
        <translation>Pose clé</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Hit a target</source>
        <translation>Toucher une cible</translation>
    </message>
    <message>
        <source>A strike of the takes and clips that follows a target, instead of keys</source>
        <translation>Une frappe des prises et des clips qui suit une cible, au lieu de clés</translation>
    </message>
    <message>
        <source>Back to the keys</source>
        <translation>Retour aux clés</translation>
    </message>
    <message>
        <source>Sho&amp;w the key pose</source>
        <translation>Montrer la &amp;pose clé</translation>
    </message>
    <message>
        <source>Show the motio&amp;n</source>
        <translation>Montrer le m&amp;ouvement</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>Clips…</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>Garder…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>A few key poses become a motion that is put together from the takes and clips: it appears here.</source>
        <translation>Quelques poses clés deviennent un mouvement, assemblé à partir des prises et des clips&#xa0;: il apparaît ici.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeySession</name>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>Preparing the clips</source>
        <translation>Préparation des clips</translation>
    </message>
    <message>
        <source>Making the motion</source>
        <translation>Création du mouvement</translation>
    </message>
    <message>
        <source>Add a key at frame %1</source>
        <translation>Ajouter une clé à l’image %1</translation>
    </message>
    <message>
        <source>Take the pose of the recording</source>
        <translation>Prendre la pose de l’enregistrement</translation>
    </message>
    <message>
        <source>Remove the key at frame %1</source>
        <translation>Supprimer la clé à l’image %1</translation>
    </message>
    <message>
        <source>A key stands at frame %1 already.</source>
        <translation>Il y a déjà une clé à l’image %1.</translation>
    </message>
    <message>
        <source>Move the key to frame %1</source>
        <translation>Déplacer la clé à l’image %1</translation>
    </message>
    <message>
        <source>Move the key and later ones to frame %1</source>
        <translation>Déplacer cette pose et les suivantes à l’image %1</translation>
    </message>
    <message>
        <source>Later keys %1 times as far</source>
        <translation>Poses suivantes %1 fois plus loin</translation>
    </message>
    <message>
        <source>Copy the key to frame %1</source>
        <translation>Copier la clé à l’image %1</translation>
    </message>
    <message>
        <source>Mirror the key</source>
        <translation>Retourner la clé en miroir</translation>
    </message>
    <message>
        <source>Change the way to the next key</source>
        <translation>Changer le chemin vers la clé suivante</translation>
    </message>
    <message>
        <source>Remove all keys</source>
        <translation>Supprimer toutes les clés</translation>
    </message>
    <message>
        <source>Drag the %1</source>
        <translation>Tirer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Turn the %1</source>
        <translation>Tourner : %1</translation>
    </message>
    <message>
        <source>Move the %1 a little</source>
        <translation>Déplacer un peu&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeyStrip</name>
    <message>
        <source>Key poses over time</source>
        <translation>Poses clés au fil du temps</translation>
    </message>
    <message>
        <source>The strike over time</source>
        <translation>La frappe au fil du temps</translation>
    </message>
    <message>
        <source>The strikes are being aligned.</source>
        <translation>Les frappes s’alignent.</translation>
    </message>
    <message>
        <source>No strike to bring to a target.</source>
        <translation>Aucune frappe à mener à une cible.</translation>
    </message>
    <message>
        <source>hit, %1</source>
        <translation>impact, %1</translation>
    </message>
    <message>
        <source>No key poses yet. Return makes the first one, of the pose that the take shows now.</source>
        <translation>Pas encore de pose clé. Entrée crée la première, de la pose que la prise montre maintenant.</translation>
    </message>
    <message>
        <source>key at frame %1 · drag to move it</source>
        <translation>clé à l’image %1 · tirez pour la déplacer</translation>
    </message>
</context>
<context>
    <name>kumite::studio::KeysPage</name>
    <message>
        <source>Mouse on the timeline</source>
        <translation>Souris sur la ligne de temps</translation>
    </message>
    <message>
        <source>click, double-click</source>
        <translation>clic, double-clic</translation>
    </message>
    <message>
        <source>select a boundary; remove or restore it</source>
        <translation>choisir une limite&#xa0;; la supprimer ou la rétablir</translation>
    </message>
    <message>
        <source>× over a boundary</source>
        <translation>× sur une limite</translation>
    </message>
    <message>
        <source>remove it at once</source>
        <translation>la supprimer aussitôt</translation>
    </message>
    <message>
        <source>drag a boundary</source>
        <translation>tirer une limite</translation>
    </message>
    <message>
        <source>move it; Ctrl or Alt: without snapping; Esc: leave it</source>
        <translation>la déplacer&#xa0;; Ctrl ou Alt&#xa0;: sans aimantation&#xa0;; Échap&#xa0;: la laisser</translation>
    </message>
    <message>
        <source>drag elsewhere</source>
        <translation>tirer ailleurs</translation>
    </message>
    <message>
        <source>scrub</source>
        <translation>parcourir</translation>
    </message>
    <message>
        <source>drag a loop end on the ruler</source>
        <translation>tirer un bout de boucle sur la graduation</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>le déplacer</translation>
    </message>
    <message>
        <source>click, double-click an action</source>
        <translation>clic, double-clic sur une action</translation>
    </message>
    <message>
        <source>select it; show and loop it</source>
        <translation>la choisir&#xa0;; l’afficher en boucle</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>clic droit</translation>
    </message>
    <message>
        <source>what can be done there</source>
        <translation>ce qu’on peut y faire</translation>
    </message>
    <message>
        <source>wheel, Shift+wheel, middle drag</source>
        <translation>molette, Maj+molette, glisser du milieu</translation>
    </message>
    <message>
        <source>scroll</source>
        <translation>défiler</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+molette</translation>
    </message>
    <message>
        <source>zoom about the pointer</source>
        <translation>zoomer autour du pointeur</translation>
    </message>
    <message>
        <source>Mouse in the 3D view</source>
        <translation>Souris dans la vue 3D</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>glisser</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>tourner</translation>
    </message>
    <message>
        <source>middle or Shift+drag</source>
        <translation>glisser du milieu ou avec Maj</translation>
    </message>
    <message>
        <source>move</source>
        <translation>déplacer</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>molette</translation>
    </message>
    <message>
        <source>click a fighter</source>
        <translation>clic sur un combattant</translation>
    </message>
    <message>
        <source>make it the active one</source>
        <translation>le rendre actif</translation>
    </message>
    <message>
        <source>measuring: click joints</source>
        <translation>en mesure&#xa0;: clic sur des articulations</translation>
    </message>
    <message>
        <source>distance; over a joint: its speed</source>
        <translation>distance&#xa0;; sur une articulation&#xa0;: sa vitesse</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Touches et souris</translation>
    </message>
    <message>
        <source>Search keys and commands</source>
        <translation>Chercher touches et commandes</translation>
    </message>
    <message>
        <source>Shows the lines that hold these letters</source>
        <translation>Affiche les lignes qui contiennent ces lettres</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Imprimer…</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Enregistrer en PDF…</translation>
    </message>
    <message>
        <source>Change keys…</source>
        <translation>Changer les touches…</translation>
    </message>
    <message>
        <source>The keys of all workspaces, on paper. (Ctrl+P)</source>
        <translation>Les touches de tous les espaces, sur papier. (Ctrl+P)</translation>
    </message>
    <message>
        <source>The keys of all workspaces, as a file.</source>
        <translation>Les touches de tous les espaces, en fichier.</translation>
    </message>
    <message>
        <source>Gives commands other keys, in the preferences.</source>
        <translation>Donne d’autres touches aux commandes, dans les préférences.</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Fermer cette page (Échap)</translation>
    </message>
    <message>
        <source>No key and no command holds these letters.</source>
        <translation>Aucune touche ni commande ne contient ces lettres.</translation>
    </message>
    <message>
        <source>Nobody is here to choose a printer.</source>
        <translation>Personne n’est là pour choisir une imprimante.</translation>
    </message>
    <message>
        <source>Print the sheet of keys</source>
        <translation>Imprimer la feuille des touches</translation>
    </message>
    <message>
        <source>%1 does not take the sheet.</source>
        <translation>%1 n’accepte pas la feuille.</translation>
    </message>
    <message>
        <source>Save the sheet of keys</source>
        <translation>Enregistrer la feuille des touches</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written there.</source>
        <translation>Impossible d’y écrire %1.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelExchange</name>
    <message>
        <source>Labels (*.csv *.json *.eaf);;All files (*)</source>
        <translation>Étiquettes (*.csv *.json *.eaf);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>Reprendre des étiquettes</translation>
    </message>
    <message>
        <source>Compare with another person&apos;s labels</source>
        <translation>Comparer aux étiquettes d’une autre personne</translation>
    </message>
    <message>
        <source>Use another vocabulary</source>
        <translation>Utiliser un autre vocabulaire</translation>
    </message>
    <message>
        <source>Vocabularies (*.json)</source>
        <translation>Vocabulaires (*.json)</translation>
    </message>
    <message>
        <source>Write labels</source>
        <translation>Écrire les étiquettes</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json);;ELAN, the shown take (*.eaf)</source>
        <translation>Tableau (*.csv);;JSON (*.json);;ELAN, la prise affichée (*.eaf)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>%1: %2 of %3 labels found their action.</source>
        <translation>%1&#xa0;: %2 étiquettes sur %3 ont trouvé leur action.</translation>
    </message>
    <message>
        <source>Labels written to %1.</source>
        <translation>Étiquettes écrites dans %1.</translation>
    </message>
    <message>
        <source>The vocabulary that the studio brings</source>
        <translation>Le vocabulaire fourni par le studio</translation>
    </message>
    <message>
        <source>It has no word for these labels, which would be dropped (undo brings them back):</source>
        <translation>Il n’a pas de mot pour ces étiquettes, qui seraient abandonnées (annuler les ramène)&#xa0;:</translation>
    </message>
    <message>
        <source>The vocabulary is %1 now.</source>
        <translation>Le vocabulaire est maintenant %1.</translation>
    </message>
    <message>
        <source>%1: %2, %3 aspects.</source>
        <translation>%1&#xa0;: %2, %3 aspects.</translation>
    </message>
    <message>
        <source>Use vocabulary</source>
        <translation>Utiliser le vocabulaire</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelLanes</name>
    <message>
        <source>%1 · action %2</source>
        <translation>%1 · action %2</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>note&#xa0;: %1</translation>
    </message>
    <message>
        <source>the machine would say %1</source>
        <translation>la machine dirait %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelLearning</name>
    <message>
        <source>Comparing actions</source>
        <translation>Comparaison des actions</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Apprentissage</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Étalonnage</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelPalette</name>
    <message>
        <source>Classes and their keys</source>
        <translation>Classes et leurs touches</translation>
    </message>
    <message>
        <source>For two strikes in one action: this, then a class of another lane</source>
        <translation>Pour deux frappes dans une action&#xa0;: ceci, puis une classe d’une autre piste</translation>
    </message>
    <message>
        <source>
Right click: paint with it over actions of the timeline</source>
        <translation>
Clic droit&#xa0;: en peindre les actions de la ligne de temps</translation>
    </message>
    <message>
        <source>first, then two classes: both</source>
        <translation>d’abord, puis deux classes : les deux</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelPanel</name>
    <message>
        <source>Go on after an answer</source>
        <translation>Continuer après une réponse</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Current action</source>
        <translation>Action actuelle</translation>
    </message>
    <message>
        <source>Accept what is proposed</source>
        <translation>Accepter la proposition</translation>
    </message>
    <message>
        <source>Take the second best instead; of what a hand said, nothing any more</source>
        <translation>Prendre le deuxième choix à la place&#xa0;; de ce qu’une main a dit, plus rien</translation>
    </message>
    <message>
        <source>Why rules say so</source>
        <translation>Pourquoi les règles le disent</translation>
    </message>
    <message>
        <source>Most useful first</source>
        <translation>Les plus utiles d’abord</translation>
    </message>
    <message>
        <source>Least sure first</source>
        <translation>Les moins sûres d’abord</translation>
    </message>
    <message>
        <source>In order of time</source>
        <translation>Dans l’ordre du temps</translation>
    </message>
    <message>
        <source>Order of the queue</source>
        <translation>Ordre de la file</translation>
    </message>
    <message>
        <source>Most useful: where the machine is torn, spread over different-looking actions</source>
        <translation>Les plus utiles&#xa0;: là où la machine hésite, réparties sur des actions d’aspects différents</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Questions</translation>
    </message>
    <message>
        <source>Sure from %1 on: %2</source>
        <translation>Sûr à partir de %1&#xa0;: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>%n action</numerusform>
            <numerusform>%n actions</numerusform>
        </translation>
    </message>
    <message>
        <source>No action</source>
        <translation>Aucune action</translation>
    </message>
    <message>
        <source>Actions appear here once a recording is open and cut.</source>
        <translation>Les actions apparaissent ici dès qu’un enregistrement est ouvert et découpé.</translation>
    </message>
    <message>
        <source>%1 leads to the first question; or click an action.</source>
        <translation>%1 mène à la première question&#xa0;; ou cliquez sur une action.</translation>
    </message>
    <message>
        <source>%1 actions chosen</source>
        <translation>%1 actions choisies</translation>
    </message>
    <message>
        <source>%1 · action %2 · %3</source>
        <translation>%1 · action %2 · %3</translation>
    </message>
    <message>
        <source>%1 · by hand</source>
        <translation>%1 · à la main</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>the only class so far</source>
        <translation>la seule classe jusqu’ici</translation>
    </message>
    <message>
        <source>Nothing is proposed yet</source>
        <translation>Rien n’est encore proposé</translation>
    </message>
    <message>
        <source>Something else: a class key</source>
        <translation>Autre chose&#xa0;: une touche de classe</translation>
    </message>
    <message>
        <source>Say what it is by a class key</source>
        <translation>Dites ce que c’est par une touche de classe</translation>
    </message>
    <message>
        <source>%1  %2  %3</source>
        <translation>%1  %2  %3</translation>
    </message>
    <message>
        <source>Queue %1</source>
        <translation>File %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelReview</name>
    <message>
        <source>There is no action to label.</source>
        <translation>Il n’y a aucune action à étiqueter.</translation>
    </message>
    <message>
        <source>No question is left. Accept what rules and machine say of the rest.</source>
        <translation>Il ne reste aucune question. Acceptez ce que règles et machine disent du reste.</translation>
    </message>
    <message>
        <source>No question was shown before.</source>
        <translation>Aucune question n’a été montrée avant.</translation>
    </message>
    <message>
        <source>Said: %1. This is the next question.</source>
        <translation>Dit&#xa0;: %1. Voici la question suivante.</translation>
    </message>
    <message>
        <source>That is what a hand has said already.</source>
        <translation>Une main l’a déjà dit.</translation>
    </message>
    <message>
        <source>The machine proposes nothing yet: say what it is by a class key.</source>
        <translation>La machine ne propose encore rien&#xa0;: dites ce que c’est par une touche de classe.</translation>
    </message>
    <message>
        <source>There is no second best: say what it is by a class key.</source>
        <translation>Il n’y a pas de deuxième choix&#xa0;: dites ce que c’est par une touche de classe.</translation>
    </message>
    <message>
        <source>%1 has no class %2.</source>
        <translation>%1 n’a pas de classe %2.</translation>
    </message>
    <message>
        <source>The next class key adds to the label.</source>
        <translation>La touche de classe suivante s’ajoute à l’étiquette.</translation>
    </message>
    <message>
        <source>Accepted as soon as the machine knows how sure it is.</source>
        <translation>Accepté dès que la machine sait à quel point elle est sûre.</translation>
    </message>
    <message>
        <source>Every action is labelled, all of them by hand.</source>
        <translation>Chaque action est étiquetée, toutes à la main.</translation>
    </message>
    <message>
        <source>Every action is labelled; of these the machine was least sure. Return says that it is right.</source>
        <translation>Chaque action est étiquetée ; de celles-ci la machine était la moins sûre. Entrée confirme.</translation>
    </message>
    <message>
        <source>Said: %1. Now the class beside it.</source>
        <translation>Dit : %1. Maintenant la classe à côté.</translation>
    </message>
    <message numerus="yes">
        <source>Accepted: %n action(s). Ctrl+Z takes all of it back.</source>
        <translation>
            <numerusform>Accepté : %n action. Ctrl+Z annule le tout.</numerusform>
            <numerusform>Accepté : %n actions. Ctrl+Z annule le tout.</numerusform>
        </translation>
    </message>
    <message>
        <source>Accepted what rules say.</source>
        <translation>Ce que disent les règles est accepté.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelViews</name>
    <message>
        <source>Palette and questions</source>
        <translation>Palette et questions</translation>
    </message>
    <message>
        <source>Find actions by what is said of them</source>
        <translation>Trouver des actions d’après ce qui en est dit</translation>
    </message>
    <message>
        <source>Actions that look like the current one, side by side</source>
        <translation>Les actions qui ressemblent à l’actuelle, côte à côte</translation>
    </message>
    <message>
        <source>How well the machine knows the bout: confusion matrix and learning curve</source>
        <translation>Ce que la machine sait du combat&#xa0;: matrice de confusion et courbe d’apprentissage</translation>
    </message>
    <message>
        <source>Thresholds of the rules for move and react</source>
        <translation>Seuils des règles de déplacement et de réaction</translation>
    </message>
    <message>
        <source>Another person&apos;s labels beside these</source>
        <translation>Les étiquettes d’une autre personne à côté de celles-ci</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Étiquetage</translation>
    </message>
    <message>
        <source>Find actions</source>
        <translation>Trouver des actions</translation>
    </message>
    <message>
        <source>Similar actions</source>
        <translation>Actions similaires</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Règles</translation>
    </message>
    <message>
        <source>Two people</source>
        <translation>Deux personnes</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelWords</name>
    <message>
        <source>%1 open</source>
        <translation>%1 à décider</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>sans %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>open</source>
        <translation>à décider</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>main</translation>
    </message>
    <message>
        <source>rule</source>
        <translation>règle</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>machine</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>accepted from a rule</source>
        <translation>accepté d’une règle</translation>
    </message>
    <message>
        <source>accepted from the machine, %1</source>
        <translation>accepté de la machine, %1</translation>
    </message>
    <message>
        <source>proposed by a rule</source>
        <translation>proposé par une règle</translation>
    </message>
    <message>
        <source>proposed by a rule, %1</source>
        <translation>proposé par une règle, %1</translation>
    </message>
    <message>
        <source>proposed: the only one seen so far</source>
        <translation>proposé&#xa0;: le seul vu jusqu’ici</translation>
    </message>
    <message>
        <source>proposed by the machine, %1</source>
        <translation>proposé par la machine, %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LaneSource</name>
    <message>
        <source>labels</source>
        <translation>étiquettes</translation>
    </message>
</context>
<context>
    <name>kumite::studio::LearningPlot</name>
    <message>
        <source>Learning curve</source>
        <translation>Courbe d’apprentissage</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>attendu %1</translation>
    </message>
    <message>
        <source>as asked %1</source>
        <translation>comme demandé %1</translation>
    </message>
    <message>
        <source>random %1</source>
        <translation>au hasard %1</translation>
    </message>
    <message>
        <source>%1 labels: %2</source>
        <translation>%1 étiquettes&#xa0;: %2</translation>
    </message>
    <message>
        <source>labels by hand</source>
        <translation>étiquettes à la main</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>attendu</translation>
    </message>
    <message>
        <source>as asked</source>
        <translation>comme demandé</translation>
    </message>
    <message>
        <source>random</source>
        <translation>au hasard</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MadeMotion</name>
    <message>
        <source>Keep the motion as a take</source>
        <translation>Garder le mouvement comme prise</translation>
    </message>
    <message>
        <source>Recordings (*.bvh)</source>
        <translation>Enregistrements (*.bvh)</translation>
    </message>
    <message>
        <source>Keeping the motion</source>
        <translation>Conservation du mouvement</translation>
    </message>
    <message>
        <source>Kept as take %1.</source>
        <translation>Gardé comme prise %1.</translation>
    </message>
    <message>
        <source>Export the motion</source>
        <translation>Exporter le mouvement</translation>
    </message>
    <message>
        <source>Motion (*.bvh);;glTF: skeleton and animation (*.glb)</source>
        <translation>Mouvement (*.bvh);;glTF&#xa0;: squelette et animation (*.glb)</translation>
    </message>
    <message>
        <source>Writing the motion</source>
        <translation>Écriture du mouvement</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Add clips</source>
        <translation>Ajouter des clips</translation>
    </message>
    <message>
        <source>Motion and projects (*.bvh *.amc *.kumite)</source>
        <translation>Mouvements et projets (*.bvh *.amc *.kumite)</translation>
    </message>
    <message>
        <source>Add all clips of a folder</source>
        <translation>Ajouter tous les clips d’un dossier</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MainWindow</name>
    <message>
        <source>&amp;Segment</source>
        <translation>Dé&amp;coupage</translation>
    </message>
    <message>
        <source>&amp;Remove or restore boundary</source>
        <translation>Supp&amp;rimer ou rétablir la limite</translation>
    </message>
    <message>
        <source>Split here: &amp;add a boundary</source>
        <translation>Couper ici&#xa0;: &amp;ajouter une limite</translation>
    </message>
    <message>
        <source>Join with the action &amp;before</source>
        <translation>&amp;Joindre à l’action précédente</translation>
    </message>
    <message>
        <source>Join with the action af&amp;ter</source>
        <translation>J&amp;oindre à l’action suivante</translation>
    </message>
    <message>
        <source>&amp;Previous boundary</source>
        <translation>Limite &amp;précédente</translation>
    </message>
    <message>
        <source>&amp;Next boundary</source>
        <translation>Limite &amp;suivante</translation>
    </message>
    <message>
        <source>Move boundary one frame &amp;earlier</source>
        <translation>Limite une image plus &amp;tôt</translation>
    </message>
    <message>
        <source>Move boundary one frame &amp;later</source>
        <translation>Limite une image plus tar&amp;d</translation>
    </message>
    <message>
        <source>Select the action before</source>
        <translation>Choisir l’action précédente</translation>
    </message>
    <message>
        <source>Select the action after</source>
        <translation>Choisir l’action suivante</translation>
    </message>
    <message>
        <source>Sho&amp;w and loop the action</source>
        <translation>Aff&amp;icher l’action en boucle</translation>
    </message>
    <message>
        <source>N&amp;ote on the action…</source>
        <translation>&amp;Note sur l’action…</translation>
    </message>
    <message>
        <source>Ne&amp;xt suspect</source>
        <translation>S&amp;uspect suivant</translation>
    </message>
    <message>
        <source>Pre&amp;vious suspect</source>
        <translation>Suspe&amp;ct précédent</translation>
    </message>
    <message>
        <source>&amp;Keep: it is a boundary</source>
        <translation>&amp;Garder&#xa0;: c’est une limite</translation>
    </message>
    <message>
        <source>Re&amp;move: it is spurious</source>
        <translation>Supprimer&#xa0;: elle est &amp;fausse</translation>
    </message>
    <message>
        <source>De&amp;cide anew</source>
        <translation>Décid&amp;er à nouveau</translation>
    </message>
    <message>
        <source>Compare with settings B</source>
        <translation>Comparer aux réglages B</translation>
    </message>
    <message>
        <source>T&amp;imeline</source>
        <translation>Lig&amp;ne de temps</translation>
    </message>
    <message>
        <source>&amp;Height of the centre of mass</source>
        <translation>&amp;Hauteur du centre de masse</translation>
    </message>
    <message>
        <source>Force without &amp;smoothing</source>
        <translation>Force sans &amp;lissage</translation>
    </message>
    <message>
        <source>Speeds of the h&amp;ands</source>
        <translation>Vitesses des &amp;mains</translation>
    </message>
    <message>
        <source>Speeds of the &amp;feet</source>
        <translation>Vitesses des &amp;pieds</translation>
    </message>
    <message>
        <source>Ruler in &amp;time and frames</source>
        <translation>Graduation en &amp;temps et images</translation>
    </message>
    <message>
        <source>Ruler in time</source>
        <translation>Graduation en temps</translation>
    </message>
    <message>
        <source>Ruler in frames</source>
        <translation>Graduation en images</translation>
    </message>
    <message>
        <source>Next &amp;unit of the ruler</source>
        <translation>&amp;Unité suivante de la graduation</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>É&amp;tiquetage</translation>
    </message>
    <message>
        <source>&amp;Next question</source>
        <translation>&amp;Question suivante</translation>
    </message>
    <message>
        <source>&amp;Previous question</source>
        <translation>Question &amp;précédente</translation>
    </message>
    <message>
        <source>&amp;Accept what is proposed</source>
        <translation>&amp;Accepter la proposition</translation>
    </message>
    <message>
        <source>&amp;Reject: the second best instead</source>
        <translation>&amp;Rejeter&#xa0;: le deuxième choix à la place</translation>
    </message>
    <message>
        <source>&amp;Take back what is said of the action</source>
        <translation>R&amp;etirer ce qui est dit de l’action</translation>
    </message>
    <message>
        <source>Accept the &amp;sure rest</source>
        <translation>Accepter le reste &amp;sûr</translation>
    </message>
    <message>
        <source>Less sure is sure eno&amp;ugh</source>
        <translation>Exiger &amp;moins de sûreté</translation>
    </message>
    <message>
        <source>On&amp;ly surer is sure enough</source>
        <translation>Exiger p&amp;lus de sûreté</translation>
    </message>
    <message>
        <source>Answers &amp;go on to the next question</source>
        <translation>Réponse do&amp;nnée, question suivante</translation>
    </message>
    <message>
        <source>Lane abo&amp;ve</source>
        <translation>Piste au-&amp;dessus</translation>
    </message>
    <message>
        <source>Lane belo&amp;w</source>
        <translation>Piste au-dess&amp;ous</translation>
    </message>
    <message>
        <source>Nothing of the lane&apos;s aspect</source>
        <translation>Rien de l’aspect de la piste</translation>
    </message>
    <message>
        <source>Class %1 of the lane</source>
        <translation>Classe %1 de la piste</translation>
    </message>
    <message>
        <source>Next class &amp;besides: a composite</source>
        <translation>Classe su&amp;ivante en plus&#xa0;: un composite</translation>
    </message>
    <message>
        <source>Choose the action before as well</source>
        <translation>Choisir aussi l’action précédente</translation>
    </message>
    <message>
        <source>Choose the action after as well</source>
        <translation>Choisir aussi l’action suivante</translation>
    </message>
    <message>
        <source>Quick label %1</source>
        <translation>Étiquette rapide %1</translation>
    </message>
    <message>
        <source>Label: %1</source>
        <translation>Étiquette&#xa0;: %1</translation>
    </message>
    <message>
        <source>Show pal&amp;ette and questions</source>
        <translation>Afficher palette et ques&amp;tions</translation>
    </message>
    <message>
        <source>&amp;Find actions</source>
        <translation>Trou&amp;ver des actions</translation>
    </message>
    <message>
        <source>Show si&amp;milar actions</source>
        <translation>Affic&amp;her les actions similaires</translation>
    </message>
    <message>
        <source>Show &amp;quality</source>
        <translation>Afficher la &amp;qualité</translation>
    </message>
    <message>
        <source>Show &amp;rules</source>
        <translation>Afficher les &amp;règles</translation>
    </message>
    <message>
        <source>Show &amp;two people&apos;s labels</source>
        <translation>Afficher les étiquettes de &amp;deux personnes</translation>
    </message>
    <message>
        <source>Ne&amp;xt action found</source>
        <translation>Action trouvée sui&amp;vante</translation>
    </message>
    <message>
        <source>Pre&amp;vious action found</source>
        <translation>Action trouvée &amp;précédente</translation>
    </message>
    <message>
        <source>Choose &amp;all that were found</source>
        <translation>&amp;Choisir toutes celles trouvées</translation>
    </message>
    <message>
        <source>&amp;Give similar actions the same label</source>
        <translation>Même étiquette aux actions sim&amp;ilaires</translation>
    </message>
    <message>
        <source>Take t&amp;heirs</source>
        <translation>Prendre la le&amp;ur</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>&amp;Garder la mienne</translation>
    </message>
    <message>
        <source>Take theirs for all that are &amp;open</source>
        <translation>Prendre les leurs &amp;où c’est à décider</translation>
    </message>
    <message>
        <source>Add what onl&amp;y they labelled</source>
        <translation>Ajouter ce qu’eu&amp;x seuls ont étiqueté</translation>
    </message>
    <message>
        <source>Next &amp;difference</source>
        <translation>Di&amp;fférence suivante</translation>
    </message>
    <message>
        <source>Take &amp;over labels…</source>
        <translation>Reprendre des éti&amp;quettes…</translation>
    </message>
    <message>
        <source>&amp;Write labels…</source>
        <translation>Éc&amp;rire les étiquettes…</translation>
    </message>
    <message>
        <source>&amp;Compare with labels of…</source>
        <translation>&amp;Comparer aux étiquettes de…</translation>
    </message>
    <message>
        <source>Use another voca&amp;bulary…</source>
        <translation>Utiliser un autre voca&amp;bulaire…</translation>
    </message>
    <message>
        <source>Use the built-&amp;in vocabulary</source>
        <translation>Utiliser le vocabulaire &amp;intégré</translation>
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
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open the &amp;demo bout</source>
        <translation>Ouvrir le combat de &amp;démonstration</translation>
    </message>
    <message>
        <source>Open &amp;recordings…</source>
        <translation>Ouvrir des e&amp;nregistrements…</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>&amp;Ouvrir un projet…</translation>
    </message>
    <message>
        <source>Opened &amp;lately</source>
        <translation>Ouverts &amp;récemment</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;Versions…</source>
        <translation>&amp;Versions…</translation>
    </message>
    <message>
        <source>&amp;Export actions…</source>
        <translation>E&amp;xporter les actions…</translation>
    </message>
    <message>
        <source>Export &amp;motion…</source>
        <translation>Exporter le &amp;mouvement…</translation>
    </message>
    <message>
        <source>&amp;Find recording…</source>
        <translation>&amp;Trouver l’enregistrement…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Encore rien</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Run a &amp;command by name…</source>
        <translation>Lancer une &amp;commande par son nom…</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Préférences…</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lire ou suspendre</translation>
    </message>
    <message>
        <source>Play &amp;backward, faster</source>
        <translation>Lire en a&amp;rrière, plus vite</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Stop</translation>
    </message>
    <message>
        <source>Play &amp;forward, faster</source>
        <translation>Lire en a&amp;vant, plus vite</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Une image en arrière</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Une image en avant</translation>
    </message>
    <message>
        <source>Leap</source>
        <translation>Saut dans le temps</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>À la fin</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Plus lent</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Plus vite</translation>
    </message>
    <message>
        <source>Loop begins here</source>
        <translation>La boucle commence ici</translation>
    </message>
    <message>
        <source>Loop ends here</source>
        <translation>La boucle finit ici</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Boucle</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Tout afficher</translation>
    </message>
    <message>
        <source>Show the &amp;fighter and what is selected</source>
        <translation>Afficher le &amp;combattant et la sélection</translation>
    </message>
    <message>
        <source>Hide &amp;panels</source>
        <translation>&amp;Masquer les panneaux</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>Theme as the system</source>
        <translation>Thème du système</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>Thème clair</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>Thème sombre</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>Texte plus grand</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>Texte plus petit</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Découpage</translation>
    </message>
    <message>
        <source>Correct the boundaries that cut the bout into actions.</source>
        <translation>Corriger les limites qui découpent le combat en actions.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Étiquetage</translation>
    </message>
    <message>
        <source>Say what a few actions are; the machine says it of the rest.</source>
        <translation>Dire ce que sont quelques actions&#xa0;; la machine le dit du reste.</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Graphe</translation>
    </message>
    <message>
        <source>What each fighter tends to do next, and the moments behind it.</source>
        <translation>Ce que chaque combattant tend à faire ensuite, et les moments derrière.</translation>
    </message>
    <message>
        <source>Label actions</source>
        <translation>Étiqueter les actions</translation>
    </message>
    <message>
        <source>Go to the Label workspace</source>
        <translation>Aller à l’espace Étiquetage</translation>
    </message>
    <message>
        <source>Take over labels</source>
        <translation>Reprendre des étiquettes</translation>
    </message>
    <message>
        <source>From a table of labels; of a made bout at once its truth</source>
        <translation>D’un tableau d’étiquettes&#xa0;; d’un combat fabriqué, aussitôt sa vérité</translation>
    </message>
    <message>
        <source>Bout</source>
        <translation>Combat</translation>
    </message>
    <message>
        <source>Let both fight on from what was learnt, or fight yourself.</source>
        <translation>Laisser les deux combattre d’après ce qui a été appris, ou combattre soi-même.</translation>
    </message>
    <message>
        <source>Clips of sequences</source>
        <translation>Clips des séquences</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Séquence</translation>
    </message>
    <message>
        <source>Play actions in any order, led over to each other.</source>
        <translation>Lire des actions dans n’importe quel ordre, enchaînées l’une à l’autre.</translation>
    </message>
    <message>
        <source>Add clips…</source>
        <translation>Ajouter des clips…</translation>
    </message>
    <message>
        <source>Of motion files or other projects</source>
        <translation>De fichiers de mouvement ou d’autres projets</translation>
    </message>
    <message>
        <source>Keyframe</source>
        <translation>Poses clés</translation>
    </message>
    <message>
        <source>A few key poses become a motion made of the recorded ones.</source>
        <translation>Quelques poses clés deviennent un mouvement fait de ceux enregistrés.</translation>
    </message>
    <message>
        <source>%1 frames back</source>
        <translation>%1 images en arrière</translation>
    </message>
    <message>
        <source>%1 frames on</source>
        <translation>%1 images en avant</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>articulation</translation>
    </message>
    <message>
        <source>measure from or to it</source>
        <translation>mesurer depuis ou vers elle</translation>
    </message>
    <message>
        <source>other fighter</source>
        <translation>autre combattant</translation>
    </message>
    <message>
        <source>leave measuring</source>
        <translation>quitter la mesure</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pause</translation>
    </message>
    <message>
        <source>play</source>
        <translation>lire</translation>
    </message>
    <message>
        <source>next suspect</source>
        <translation>suspect suivant</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>garder</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>supprimer</translation>
    </message>
    <message>
        <source>action</source>
        <translation>action</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
    <message>
        <source>next question</source>
        <translation>question suivante</translation>
    </message>
    <message>
        <source>accept</source>
        <translation>accepter</translation>
    </message>
    <message>
        <source>second best</source>
        <translation>deuxième choix</translation>
    </message>
    <message>
        <source>lane</source>
        <translation>piste</translation>
    </message>
    <message>
        <source>… its classes</source>
        <translation>… ses classes</translation>
    </message>
    <message>
        <source>fight</source>
        <translation>combattre</translation>
    </message>
    <message>
        <source>… lead the avatar</source>
        <translation>… guider l’avatar</translation>
    </message>
    <message>
        <source>go on otherwise</source>
        <translation>continuer autrement</translation>
    </message>
    <message>
        <source>… play a block at once</source>
        <translation>… jouer un bloc aussitôt</translation>
    </message>
    <message>
        <source>back to the sequence</source>
        <translation>retour à la séquence</translation>
    </message>
    <message>
        <source>find an action</source>
        <translation>trouver une action</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>l’ajouter</translation>
    </message>
    <message>
        <source>block</source>
        <translation>bloc</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>le déplacer</translation>
    </message>
    <message>
        <source>draw its transition anew</source>
        <translation>tirer à nouveau sa transition</translation>
    </message>
    <message>
        <source>map of poses</source>
        <translation>carte des poses</translation>
    </message>
    <message>
        <source>live</source>
        <translation>en direct</translation>
    </message>
    <message>
        <source>add a key here</source>
        <translation>ajouter une clé ici</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clé</translation>
    </message>
    <message>
        <source>take the recording&apos;s pose</source>
        <translation>prendre la pose de l’enregistrement</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>poignée</translation>
    </message>
    <message>
        <source>pin it</source>
        <translation>la fixer</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>miroir</translation>
    </message>
    <message>
        <source>back to the keys</source>
        <translation>retour aux clés</translation>
    </message>
    <message>
        <source>hit a target</source>
        <translation>toucher une cible</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>touches</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>mouvement</translation>
    </message>
    <message>
        <source>keep as a take</source>
        <translation>garder comme prise</translation>
    </message>
    <message>
        <source>next surprise</source>
        <translation>surprise suivante</translation>
    </message>
    <message>
        <source>play what is behind</source>
        <translation>lire ce qu’il y a derrière</translation>
    </message>
    <message>
        <source>matrix or graph</source>
        <translation>matrice ou graphe</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>image</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>add</source>
        <translation>ajouter</translation>
    </message>
    <message>
        <source>any command</source>
        <translation>toute commande</translation>
    </message>
    <message>
        <source>help</source>
        <translation>aide</translation>
    </message>
    <message>
        <source>1 finding</source>
        <translation>1 constat</translation>
    </message>
    <message>
        <source>%1 findings</source>
        <translation>%1 constats</translation>
    </message>
    <message>
        <source>What was found in the recordings</source>
        <translation>Constats dans les enregistrements</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>&amp;Prise</translation>
    </message>
    <message>
        <source>&amp;Add recordings as a take…</source>
        <translation>&amp;Ajouter des enregistrements comme prise…</translation>
    </message>
    <message>
        <source>&amp;Rename take</source>
        <translation>&amp;Renommer la prise</translation>
    </message>
    <message>
        <source>Re&amp;move take</source>
        <translation>&amp;Supprimer la prise</translation>
    </message>
    <message>
        <source>Move take &amp;up</source>
        <translation>&amp;Monter la prise</translation>
    </message>
    <message>
        <source>Move take &amp;down</source>
        <translation>&amp;Descendre la prise</translation>
    </message>
    <message>
        <source>Show the take &amp;before</source>
        <translation>Afficher la prise &amp;précédente</translation>
    </message>
    <message>
        <source>Show the take a&amp;fter</source>
        <translation>Afficher la prise s&amp;uivante</translation>
    </message>
    <message>
        <source>&amp;Other fighter active</source>
        <translation>A&amp;ctiver l’autre combattant</translation>
    </message>
    <message>
        <source>Fighter &amp;properties…</source>
        <translation>Pr&amp;opriétés du combattant…</translation>
    </message>
    <message>
        <source>&amp;Swap fighters</source>
        <translation>Éc&amp;hanger les combattants</translation>
    </message>
    <message>
        <source>F&amp;indings on the recordings</source>
        <translation>Consta&amp;ts sur les enregistrements</translation>
    </message>
    <message>
        <source>Removed take %1. %2 brings it back.</source>
        <translation>Prise %1 supprimée. %2 la ramène.</translation>
    </message>
    <message>
        <source>leave the field or button</source>
        <translation>quitter le champ ou le bouton</translation>
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
        <translation>par étiquette propre</translation>
    </message>
    <message>
        <source>by opponent&apos;s label</source>
        <translation>par étiquette de l’adversaire</translation>
    </message>
    <message>
        <source>by both labels</source>
        <translation>par les deux étiquettes</translation>
    </message>
    <message>
        <source>What the rows know</source>
        <translation>Ce que savent les lignes</translation>
    </message>
    <message>
        <source>What the rows know: what the fighter does, what the opponent does, or both. What is left out is summed over.</source>
        <translation>Ce que savent les lignes&#xa0;: ce que fait le combattant, ce que fait l’adversaire, ou les deux. Ce qui est omis est sommé.</translation>
    </message>
    <message>
        <source>by count</source>
        <translation>par nombre</translation>
    </message>
    <message>
        <source>by name</source>
        <translation>par nom</translation>
    </message>
    <message>
        <source>by likeness</source>
        <translation>par ressemblance</translation>
    </message>
    <message>
        <source>Order of rows and columns</source>
        <translation>Ordre des lignes et colonnes</translation>
    </message>
    <message>
        <source>By likeness rows that lead to the same labels become neighbours; a line parts the groups.</source>
        <translation>Par ressemblance, les lignes qui mènent aux mêmes étiquettes deviennent voisines&#xa0;; un trait sépare les groupes.</translation>
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
        <translation>tel que compté</translation>
    </message>
    <message>
        <source>How probabilities are estimated</source>
        <translation>Comment les probabilités sont estimées</translation>
    </message>
    <message>
        <source>EQU7: P(next | own) · P(next | opponent). EQU6: over pairs of label elements. EQU5: counts of whole triples. All three with a prior, so that nothing is impossible; as counted: without.</source>
        <translation>EQU7&#xa0;: P(suite | propre) · P(suite | adversaire). EQU6&#xa0;: sur des paires d’éléments d’étiquette. EQU5&#xa0;: comptes de triplets entiers. Les trois avec un a priori, pour que rien ne soit impossible&#xa0;; tel que compté&#xa0;: sans.</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>côte à côte</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>How two are compared</source>
        <translation>Comment deux sont comparés</translation>
    </message>
    <message>
        <source>Colours over the logarithm: rare transitions become visible</source>
        <translation>Couleurs selon le logarithme&#xa0;: les transitions rares deviennent visibles</translation>
    </message>
    <message>
        <source>Matrix of transitions to compare with</source>
        <translation>Matrice des transitions à comparer</translation>
    </message>
    <message>
        <source>P(next | own)</source>
        <translation>P(suite | propre)</translation>
    </message>
    <message>
        <source>P(next | opponent)</source>
        <translation>P(suite | adversaire)</translation>
    </message>
    <message>
        <source>P(next | own, opponent)</source>
        <translation>P(suite | propre, adversaire)</translation>
    </message>
    <message>
        <source>%1 − %2</source>
        <translation>%1 − %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>difference %1</source>
        <translation>différence %1</translation>
    </message>
    <message>
        <source>P %1</source>
        <translation>P %1</translation>
    </message>
    <message>
        <source>%1 → %2   ·   %3   ·   seen %4 of %5 times</source>
        <translation>%1 → %2   ·   %3   ·   vu %4 fois sur %5</translation>
    </message>
    <message>
        <source>%1   ·   %2 transitions begin so</source>
        <translation>%1   ·   %2 transitions commencent ainsi</translation>
    </message>
    <message>
        <source>%1   ·   %2 transitions lead here</source>
        <translation>%1   ·   %2 transitions mènent ici</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MatrixView</name>
    <message>
        <source>Matrix of transitions</source>
        <translation>Matrice des transitions</translation>
    </message>
    <message>
        <source>A row is what goes on, a column what follows. Arrows lead from cell to cell; the moments behind the chosen one are listed beside it.</source>
        <translation>Une ligne est ce qui est en cours, une colonne ce qui suit. Les flèches mènent de cellule en cellule&#xa0;; les moments derrière celle choisie sont listés à côté.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::MessageStrip</name>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ignorer</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Ce qui s’est passé</translation>
    </message>
    <message numerus="yes">
        <source> And %n more.</source>
        <translation>
            <numerusform> Et %n de plus.</numerusform>
            <numerusform> Et %n de plus.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::MotionBox</name>
    <message>
        <source>joints adjusted</source>
        <translation>articulations ajustées</translation>
    </message>
    <message>
        <source>What the motion is made of</source>
        <translation>De quoi le mouvement est fait</translation>
    </message>
    <message>
        <source>whole body</source>
        <translation>corps entier</translation>
    </message>
    <message>
        <source>What is looked for</source>
        <translation>Ce qui est cherché</translation>
    </message>
    <message>
        <source>In what the places are like the keys: the whole body or one part</source>
        <translation>En quoi les endroits ressemblent aux poses : le corps entier ou une partie</translation>
    </message>
    <message>
        <source>Similar in</source>
        <translation>Semblable en</translation>
    </message>
    <message>
        <source>The keys and places like them</source>
        <translation>Les poses et les endroits semblables</translation>
    </message>
    <message>
        <source>First the keys, then what is most like them; a click takes it</source>
        <translation>D’abord les poses, puis le plus semblable ; un clic le prend</translation>
    </message>
    <message>
        <source>Places that are like the keys</source>
        <translation>Endroits semblables aux clés</translation>
    </message>
    <message>
        <source>The places that are most like the keys, the best first; a click, or Return, takes the body or the part from there</source>
        <translation>Les endroits les plus semblables aux poses, le meilleur d’abord ; un clic ou Entrée en prend le corps ou la partie</translation>
    </message>
    <message>
        <source>what fits better</source>
        <translation>ce qui va le mieux</translation>
    </message>
    <message>
        <source>with the body</source>
        <translation>avec le corps</translation>
    </message>
    <message>
        <source>its own best</source>
        <translation>son propre meilleur</translation>
    </message>
    <message>
        <source>as chosen above</source>
        <translation>comme choisi ci-dessus</translation>
    </message>
    <message>
        <source>Where the %1 comes from</source>
        <translation>D’où vient la partie&#xa0;: %1</translation>
    </message>
    <message>
        <source>Take a part from elsewhere</source>
        <translation>Prendre une partie d’ailleurs</translation>
    </message>
    <message>
        <source>Where parts are joined the joints&apos; mean and spread become those of the keys (paper C, 4.2.2)</source>
        <translation>Là où des parties sont jointes, la moyenne et l’étendue des articulations deviennent celles des clés (article C, 4.2.2)</translation>
    </message>
    <message>
        <source>How far the motion is drawn to the keys</source>
        <translation>À quel point le mouvement est tiré vers les clés</translation>
    </message>
    <message>
        <source>Left: as it was found; right: through the keys&apos; poses</source>
        <translation>Gauche&#xa0;: comme trouvé&#xa0;; droite&#xa0;: par les poses des clés</translation>
    </message>
    <message>
        <source>Meet keys</source>
        <translation>Suivre les clés</translation>
    </message>
    <message>
        <source>Join parts otherwise</source>
        <translation>Joindre les parties autrement</translation>
    </message>
    <message>
        <source>Draw the motion to the keys</source>
        <translation>Tirer le mouvement vers les clés</translation>
    </message>
    <message>
        <source>Two keys or more become a motion, put together from the takes and clips.</source>
        <translation>Deux clés ou plus deviennent un mouvement, assemblé à partir des prises et des clips.</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>Le mouvement se prépare.</translation>
    </message>
    <message>
        <source>Body: %1, %2 of %3 features differ, %4 cm from the keys.</source>
        <translation>Corps&#xa0;: %1, %2 traits sur %3 diffèrent, à %4 cm des clés.</translation>
    </message>
    <message>
        <source>%1 features differ, %2 cm from the keys</source>
        <translation>%1 traits diffèrent, à %2 cm des clés</translation>
    </message>
    <message>
        <source>%1, %2 features differ</source>
        <translation>%1, %2 traits diffèrent</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>les poses</translation>
    </message>
    <message>
        <source>Take the %1 from elsewhere</source>
        <translation>Prendre ailleurs : %1</translation>
    </message>
    <message>
        <source>Take the body from elsewhere</source>
        <translation>Prendre le corps d’ailleurs</translation>
    </message>
</context>
<context>
    <name>kumite::studio::NodePage</name>
    <message>
        <source>cross edges</source>
        <translation>arêtes croisées</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Fighter 1&apos;s graph before fighter 2&apos;s, cross edges between; drag turns</source>
        <translation>Le graphe du combattant 1 devant celui du 2, arêtes croisées entre eux&#xa0;; glisser tourne</translation>
    </message>
    <message>
        <source>Also what a fighter does next given what the opponent is doing; those of what is selected show always</source>
        <translation>Aussi ce qu’un combattant fait ensuite selon ce que fait l’adversaire&#xa0;; celles de la sélection s’affichent toujours</translation>
    </message>
    <message>
        <source>Of each side only what it does more often than the other, as wide as the difference</source>
        <translation>De chaque côté seulement ce qu’il fait plus souvent que l’autre, large comme la différence</translation>
    </message>
    <message>
        <source>Least probability of an edge</source>
        <translation>Probabilité minimale d’une arête</translation>
    </message>
    <message>
        <source>Edges that are less probable are not drawn.</source>
        <translation>Les arêtes moins probables ne sont pas dessinées.</translation>
    </message>
    <message>
        <source>Most edges from a node</source>
        <translation>Nombre maximal d’arêtes par nœud</translation>
    </message>
    <message>
        <source>So many edges of each node are drawn, the likeliest ones.</source>
        <translation>Autant d’arêtes de chaque nœud sont dessinées, les plus probables.</translation>
    </message>
    <message>
        <source>ΔP ≥ 0.000</source>
        <translation>ΔP ≥ 0,000</translation>
    </message>
    <message>
        <source>12 a node</source>
        <translation>12 par nœud</translation>
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
        <translation>%1 par nœud</translation>
    </message>
    <message>
        <source>%1: %2   ·   %3 actions</source>
        <translation>%1&#xa0;: %2   ·   %3 actions</translation>
    </message>
    <message>
        <source>%1: %2 → %3   ·   %4 %5   ·   seen %6 times</source>
        <translation>%1&#xa0;: %2 → %3   ·   %4 %5   ·   vu %6 fois</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>more often by</source>
        <translation>plus souvent par</translation>
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
        <translation>Note sur l’action</translation>
    </message>
    <message>
        <source>Return keeps the note, Esc leaves it as it was; no text removes it.</source>
        <translation>Entrée garde la note, Échap la laisse telle quelle&#xa0;; sans texte, elle est supprimée.</translation>
    </message>
    <message>
        <source>Note on this action</source>
        <translation>Note sur cette action</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PartDialog</name>
    <message>
        <source>joints adjusted</source>
        <translation>articulations ajustées</translation>
    </message>
    <message>
        <source>Replace a part of a take</source>
        <translation>Remplacer une partie d’une prise</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Dans</translation>
    </message>
    <message>
        <source>take that is changed</source>
        <translation>prise qui est modifiée</translation>
    </message>
    <message>
        <source>Part that is replaced</source>
        <translation>Partie qui est remplacée</translation>
    </message>
    <message>
        <source>Where the part hangs on the rest its joint keeps the take&apos;s mean and spread</source>
        <translation>Là où la partie tient au reste, l’articulation garde la moyenne et l’écart de la prise</translation>
    </message>
    <message>
        <source>The</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>By that of</source>
        <translation>Par celle de</translation>
    </message>
    <message>
        <source>take or clip that lends the part</source>
        <translation>prise ou clip qui prête la partie</translation>
    </message>
    <message>
        <source>The take, what lends the part, and the result</source>
        <translation>La prise, ce qui prête la partie, et le résultat</translation>
    </message>
    <message>
        <source>What becomes of it</source>
        <translation>Ce qui en résulte</translation>
    </message>
    <message>
        <source>Keep as a take…</source>
        <translation>Garder comme prise…</translation>
    </message>
    <message>
        <source>The %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>First frame of the %1</source>
        <translation>Première image : %1</translation>
    </message>
    <message>
        <source>Last frame of the %1</source>
        <translation>Dernière image : %1</translation>
    </message>
    <message>
        <source>%1, at %2 Hz</source>
        <translation>%1, à %2 Hz</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>telle quelle</translation>
    </message>
    <message>
        <source>what lends the %1</source>
        <translation>ce qui prête : %1</translation>
    </message>
    <message>
        <source>the result</source>
        <translation>le résultat</translation>
    </message>
    <message>
        <source>%1 of the take&apos;s %2 are changed, in the %3 only; all else stays.</source>
        <translation>%1 sur %2 de la prise changent, seulement ici : %3 ; tout le reste demeure.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PartWords</name>
    <message>
        <source>left arm</source>
        <translation>bras gauche</translation>
    </message>
    <message>
        <source>right arm</source>
        <translation>bras droit</translation>
    </message>
    <message>
        <source>left leg</source>
        <translation>jambe gauche</translation>
    </message>
    <message>
        <source>right leg</source>
        <translation>jambe droite</translation>
    </message>
    <message>
        <source>trunk, head</source>
        <translation>tronc, tête</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PoseBox</name>
    <message>
        <source>left hand</source>
        <translation>main gauche</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>main droite</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>pied gauche</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>pied droit</translation>
    </message>
    <message>
        <source>hips</source>
        <translation>hanches</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>poitrine</translation>
    </message>
    <message>
        <source>head</source>
        <translation>tête</translation>
    </message>
    <message>
        <source>even</source>
        <translation>régulier</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>doux</translation>
    </message>
    <message>
        <source>from rest</source>
        <translation>départ arrêté</translation>
    </message>
    <message>
        <source>to rest</source>
        <translation>arrivée arrêtée</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>tenir</translation>
    </message>
    <message>
        <source>stays where it is</source>
        <translation>reste en place</translation>
    </message>
    <message>
        <source>and later keys</source>
        <translation>et les poses suivantes</translation>
    </message>
    <message>
        <source>The chosen key</source>
        <translation>La clé choisie</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Poignée</translation>
    </message>
    <message>
        <source>What is drawn: drag it in the 3D view, or give its place below</source>
        <translation>Ce qui est tiré&#xa0;: tirez-la dans la vue 3D, ou donnez sa place ci-dessous</translation>
    </message>
    <message>
        <source>While another handle is drawn this one stays; Ctrl and a click on it does the same</source>
        <translation>Quand une autre poignée est tirée, celle-ci reste&#xa0;; Ctrl et un clic dessus font de même</translation>
    </message>
    <message>
        <source>Place, %1 in metres</source>
        <translation>Place, %1 en mètres</translation>
    </message>
    <message>
        <source>%1, metres; y is up</source>
        <translation>%1, mètres&#xa0;; y est le haut</translation>
    </message>
    <message>
        <source>x y z, m</source>
        <translation>x y z, m</translation>
    </message>
    <message>
        <source>Way to the next key</source>
        <translation>Chemin vers la clé suivante</translation>
    </message>
    <message>
        <source>How the way to the next key goes</source>
        <translation>Comment se fait le chemin vers la clé suivante</translation>
    </message>
    <message>
        <source>Way on</source>
        <translation>Vers la suite</translation>
    </message>
    <message>
        <source>Frame of the key</source>
        <translation>Image de la pose</translation>
    </message>
    <message>
        <source>Moves the key to that frame</source>
        <translation>Déplace la pose à cette image</translation>
    </message>
    <message>
        <source>Later keys go as many frames along</source>
        <translation>Les poses suivantes avancent d’autant d’images</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Time from this key on, times</source>
        <translation>Temps après cette pose, fois</translation>
    </message>
    <message>
        <source>All later keys that many times as far from this one: 2 is half as fast</source>
        <translation>Toutes les poses suivantes autant de fois plus loin de celle-ci : 2, c’est deux fois plus lent</translation>
    </message>
    <message>
        <source>Time on</source>
        <translation>Temps après</translation>
    </message>
    <message>
        <source>Frame %1. Drag hands, feet, hips, chest or head in the 3D view.</source>
        <translation>Image %1. Tirez mains, pieds, hanches, poitrine ou tête dans la vue 3D.</translation>
    </message>
    <message>
        <source>Return makes a key.</source>
        <translation>Entrée crée une clé.</translation>
    </message>
    <message>
        <source>Choose a key to change its pose.</source>
        <translation>Choisissez une clé pour changer sa pose.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PoseDialog</name>
    <message>
        <source>Copy a pose</source>
        <translation>Copier une pose</translation>
    </message>
    <message>
        <source>Take or clip</source>
        <translation>Prise ou clip</translation>
    </message>
    <message>
        <source>Whose pose is copied: a fighter of a take, or a clip</source>
        <translation>De qui la pose est copiée : un combattant d’une prise, ou un clip</translation>
    </message>
    <message>
        <source>The pose</source>
        <translation>La pose</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>Which moment; arrow keys go on by one frame</source>
        <translation>Quel moment ; les flèches avancent d’une image</translation>
    </message>
    <message>
        <source>Frame of the take or clip</source>
        <translation>Image de la prise ou du clip</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Copy the pose</source>
        <translation>Copier la pose</translation>
    </message>
    <message>
        <source>frame %1 at %2 Hz</source>
        <translation>image %1 à %2 Hz</translation>
    </message>
    <message>
        <source>Copy the pose of %1</source>
        <translation>Copier la pose de %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Valeurs par défaut</translation>
    </message>
    <message>
        <source>All values of the General page as the studio brings them.</source>
        <translation>Toutes les valeurs de la page Général telles que le studio les fournit.</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Fermer cette page (Échap)</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Colours of the whole window.</source>
        <translation>Couleurs de toute la fenêtre.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Of all texts, numbers and dates in the window; files do not know it. The window is made anew at once, with what is open in it.</source>
        <translation>De tous les textes, nombres et dates de la fenêtre ; les fichiers ne la connaissent pas. La fenêtre est refaite aussitôt, avec ce qui y est ouvert.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Text size, percent</source>
        <translation>Taille du texte, pour cent</translation>
    </message>
    <message>
        <source>How large all text is; pages that it makes too large can be scrolled.</source>
        <translation>Taille de tout le texte ; les pages devenues trop grandes défilent.</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Taille du texte</translation>
    </message>
    <message>
        <source>Reduce motion</source>
        <translation>Moins de mouvement</translation>
    </message>
    <message>
        <source>Nothing begins to move by itself: questions and similar actions stand still until you play them.</source>
        <translation>Rien ne bouge de soi-même : questions et actions semblables restent immobiles jusqu’à ce que vous les lanciez.</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Playback speed of a bout that is opened, percent</source>
        <translation>Vitesse de lecture d’un combat qui s’ouvre, en pour cent</translation>
    </message>
    <message>
        <source>How fast a bout plays when it is opened. While it is open, - and + change it.</source>
        <translation>À quelle vitesse un combat se lit à l’ouverture. Tant qu’il est ouvert, - et + la changent.</translation>
    </message>
    <message>
        <source>Speed at opening</source>
        <translation>Vitesse à l’ouverture</translation>
    </message>
    <message>
        <source>Play in a loop</source>
        <translation>Lire en boucle</translation>
    </message>
    <message>
        <source>Whether a bout loops when it is opened.</source>
        <translation>Si un combat tourne en boucle à l’ouverture.</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> images</translation>
    </message>
    <message>
        <source>Frames of a leap</source>
        <translation>Images par saut</translation>
    </message>
    <message>
        <source>How far Shift+← and Shift+→ go.</source>
        <translation>De combien sautent Maj+← et Maj+→.</translation>
    </message>
    <message>
        <source>Shift+← → goes</source>
        <translation>Maj+← → saute de</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Souris</translation>
    </message>
    <message>
        <source>Mouse sensitivity in the 3D view, percent</source>
        <translation>Sensibilité de la souris dans la vue 3D, en pour cent</translation>
    </message>
    <message>
        <source>How fast a drag turns and the wheel zooms in the 3D view.</source>
        <translation>À quelle vitesse glisser tourne et la molette zoome dans la vue 3D.</translation>
    </message>
    <message>
        <source>Sensitivity in 3D</source>
        <translation>Sensibilité en 3D</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sécurité</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Autosave interval in seconds</source>
        <translation>Intervalle de sauvegarde automatique en secondes</translation>
    </message>
    <message>
        <source>After how long at most changes are kept for a recovery. The project file itself is written only when you save.</source>
        <translation>Après combien de temps au plus les modifications sont gardées pour une récupération. Le fichier du projet n’est écrit que lorsque vous enregistrez.</translation>
    </message>
    <message>
        <source>Autosave every</source>
        <translation>Sauvegarde auto toutes les</translation>
    </message>
</context>
<context>
    <name>kumite::studio::ProgressBox</name>
    <message>
        <source>Progress of labelling</source>
        <translation>Progression de l’étiquetage</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>Que faire ensuite</translation>
    </message>
    <message>
        <source>Keep what machine and rules propose where they are at least so sure; one step of the history (Ctrl+Return)</source>
        <translation>Garder ce que proposent machine et règles là où elles sont au moins aussi sûres&#xa0;; une étape de l’historique (Ctrl+Entrée)</translation>
    </message>
    <message>
        <source>Labelled by hand, accepted, open</source>
        <translation>Étiquetées à la main, acceptées, à décider</translation>
    </message>
    <message>
        <source>How sure the machine must be of what is accepted: 0.90 is nine of ten right. Ctrl+Down and Ctrl+Up move it.</source>
        <translation>À quel point la machine doit être sûre de ce qui est accepté&#xa0;: 0,90, c’est neuf justes sur dix. Ctrl+Bas et Ctrl+Haut le changent.</translation>
    </message>
    <message>
        <source>Least probability of what is accepted</source>
        <translation>Probabilité minimale de ce qui est accepté</translation>
    </message>
    <message>
        <source>Proposals that are at least so probable are accepted.</source>
        <translation>Les propositions au moins aussi probables sont acceptées.</translation>
    </message>
    <message>
        <source>%1 actions: %2 labelled by hand (dark), %3 accepted (light), %4 open</source>
        <translation>%1 actions&#xa0;: %2 étiquetées à la main (foncé), %3 acceptées (clair), %4 à décider</translation>
    </message>
    <message>
        <source>%1 labelled</source>
        <translation>%1 étiquetées</translation>
    </message>
    <message>
        <source>, expected accuracy %1</source>
        <translation>, exactitude attendue %1</translation>
    </message>
    <message>
        <source>Accept rules</source>
        <translation>Accepter les règles</translation>
    </message>
    <message>
        <source>Accept %1 sure</source>
        <translation>Accepter %1 sûres</translation>
    </message>
    <message>
        <source>Accept the sure</source>
        <translation>Accepter les sûres</translation>
    </message>
    <message>
        <source>Every action is labelled. File &gt; Save keeps it; Label &gt; Write labels… makes a table.</source>
        <translation>Chaque action est étiquetée. Fichier &gt; Enregistrer les garde&#xa0;; Étiquetage &gt; Écrire les étiquettes… en fait un tableau.</translation>
    </message>
    <message>
        <source>No recording is cut into actions yet.</source>
        <translation>Aucun enregistrement n’est encore découpé en actions.</translation>
    </message>
    <message>
        <source>Label a few actions by hand; the machine proposes the others. N leads to the one that says most.</source>
        <translation>Étiquetez quelques actions à la main&#xa0;; la machine propose les autres. N mène à celle qui en dit le plus.</translation>
    </message>
    <message>
        <source>Go on: N leads to the next one that says most.</source>
        <translation>Continuez&#xa0;: N mène à la prochaine qui en dit le plus.</translation>
    </message>
    <message>
        <source>What rules say is left to be accepted.</source>
        <translation>Il reste à accepter ce que disent les règles.</translation>
    </message>
    <message>
        <source>Nothing of %1 was labelled so far: if there is any, show the machine one.</source>
        <translation>Rien de %1 n’a été étiqueté jusqu’ici&#xa0;: s’il y en a, montrez-en un à la machine.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Accept %1 guesses</source>
        <translation>Accepter %1 suppositions</translation>
    </message>
    <message>
        <source>Every action has a label, but of ten that the machine gave only about %1 are right. N leads through those of which it was least sure; or undo the acceptance and answer more questions.</source>
        <translation>Chaque action a une étiquette, mais sur dix de la machine environ %1 seulement sont justes. N mène aux moins sûres ; ou annulez l’acceptation et répondez à d’autres questions.</translation>
    </message>
    <message numerus="yes">
        <source>%n minima are still suspect. Half actions are hard to label: correct them in Segment first, or go on with N.</source>
        <translation>
            <numerusform>%n minimum est encore suspect. Une demi-action s’étiquette mal : corrigez d’abord dans Découpage, ou continuez avec N.</numerusform>
            <numerusform>%n minima sont encore suspects. Une demi-action s’étiquette mal : corrigez d’abord dans Découpage, ou continuez avec N.</numerusform>
        </translation>
    </message>
    <message>
        <source>How many of the machine&apos;s answers should be right where no hand has spoken</source>
        <translation>Part des réponses de la machine qui devraient être justes là où aucune main n’a parlé</translation>
    </message>
    <message>
        <source>More labels by hand will hardly help: accept the sure rest (%1), lower the bar for the others (%2), then look through the least sure (%3).</source>
        <translation>D’autres étiquettes à la main n’aideront guère : acceptez le reste sûr (%1), abaissez le seuil pour les autres (%2), puis revoyez les moins sûres (%3).</translation>
    </message>
    <message>
        <source>Go on: the next ones tell the machine most.</source>
        <translation>Continuez : les suivantes en apprennent le plus à la machine.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::QualityBox</name>
    <message>
        <source>Actions of the cell</source>
        <translation>Actions de la cellule</translation>
    </message>
    <message>
        <source>Aspect of the confusion matrix</source>
        <translation>Aspect de la matrice de confusion</translation>
    </message>
    <message>
        <source>Whose classes the matrix and the list are about.</source>
        <translation>De quelles classes parlent la matrice et la liste.</translation>
    </message>
    <message>
        <source>What the cell says</source>
        <translation>Ce que dit la cellule</translation>
    </message>
    <message>
        <source>Share of actions whose learnt aspects are all right. Expected: cross-validation over the hand labels as the session went. As asked and random: the hand labels are dealt into folds; one is held out, and from the others the machine learns more and more labels, in the order in which the queue asks for them and in random orders. Both are judged on the same held-out labels. What was asked for is harder than the rest, so the bout as a whole fares better.</source>
        <translation>Part des actions dont les aspects appris sont tous justes. Attendu&#xa0;: validation croisée sur les étiquettes à la main, au fil de la session. Comme demandé et au hasard&#xa0;: les étiquettes à la main sont réparties en plis&#xa0;; l’un est mis de côté, et des autres la machine apprend de plus en plus d’étiquettes, dans l’ordre où la file les demande et dans des ordres aléatoires. Les deux sont jugés sur les mêmes étiquettes mises de côté. Ce qui a été demandé est plus difficile que le reste&#xa0;: le combat entier s’en tire donc mieux.</translation>
    </message>
    <message>
        <source>Judging</source>
        <translation>Évaluation</translation>
    </message>
    <message>
        <source>Comparing orders</source>
        <translation>Comparaison des ordres</translation>
    </message>
    <message>
        <source>How often machine and rules say the same as your hand appears here, once some actions are labelled by hand.</source>
        <translation>Combien de fois machine et règles disent la même chose que votre main apparaît ici, dès que quelques actions sont étiquetées à la main.</translation>
    </message>
    <message>
        <source>No hand has said anything of this aspect.</source>
        <translation>Aucune main n’a rien dit de cet aspect.</translation>
    </message>
    <message>
        <source>Rows by hand, columns %1. %2 of %3 right, F1 %4.</source>
        <translation>Lignes à la main, colonnes %1. %2 justes sur %3, F1 %4.</translation>
    </message>
    <message>
        <source>by rule</source>
        <translation>par règle</translation>
    </message>
    <message>
        <source>by machine, unseen</source>
        <translation>par machine, sans les voir</translation>
    </message>
    <message>
        <source>A click on a cell, or Enter, opens its actions.</source>
        <translation>Un clic sur une cellule, ou Entrée, ouvre ses actions.</translation>
    </message>
    <message>
        <source>No action is in this cell.</source>
        <translation>Aucune action n’est dans cette cellule.</translation>
    </message>
    <message>
        <source>%1 labels as asked do what %2 in random order do.</source>
        <translation>%1 étiquettes comme demandé valent %2 dans un ordre aléatoire.</translation>
    </message>
    <message>
        <source>With %1 hand labels the order of the questions is compared with a random one.</source>
        <translation>Avec %1 étiquettes à la main, l’ordre des questions est comparé à un ordre aléatoire.</translation>
    </message>
    <message>
        <source>More labels will hardly help.</source>
        <translation>D’autres étiquettes n’aideront guère.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Questions</name>
    <message>
        <source>%1: nobody is here to choose a file.</source>
        <translation>%1&#xa0;: personne n’est là pour choisir un fichier.</translation>
    </message>
    <message>
        <source>%1 Nobody is here to answer: %2.</source>
        <translation>%1 Personne n’est là pour répondre&#xa0;: %2.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RecentButton</name>
    <message>
        <source>Open %1, %2</source>
        <translation>Ouvrir %1, %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Recovery</name>
    <message>
        <source>Saving a copy</source>
        <translation>Enregistrement d’une copie</translation>
    </message>
    <message>
        <source>Recovery copies cannot be written. %1</source>
        <translation>Les copies de récupération ne peuvent pas être écrites. %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RecoveryDialog</name>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Jeter</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Récupération</translation>
    </message>
    <message>
        <source>Kumite ended unexpectedly. The edits that were not saved are kept here; recovered, they stand in the project as unsaved changes.</source>
        <translation>Kumite s’est arrêté de façon inattendue. Les modifications non enregistrées sont gardées ici&#xa0;; récupérées, elles figurent dans le projet comme modifications non enregistrées.</translation>
    </message>
    <message>
        <source>Projects that can be recovered</source>
        <translation>Projets récupérables</translation>
    </message>
    <message>
        <source>What was not saved; a double-click recovers it</source>
        <translation>Ce qui n’a pas été enregistré&#xa0;; un double-clic le récupère</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projet</translation>
    </message>
    <message>
        <source>Last edit</source>
        <translation>Dernière modification</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Non enregistré</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>jamais enregistré</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>Delete the chosen edits for good (Del)</source>
        <translation>Supprimer définitivement les modifications choisies (Suppr)</translation>
    </message>
    <message>
        <source>Open the chosen project with its unsaved edits (Enter)</source>
        <translation>Ouvrir le projet choisi avec ses modifications non enregistrées (Entrée)</translation>
    </message>
    <message>
        <source>Keep them and ask again at the next start (Esc)</source>
        <translation>Les garder et redemander au prochain démarrage (Échap)</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Review</name>
    <message numerus="yes">
        <source>What you decided clears %n more.</source>
        <translation>
            <numerusform>Votre décision en écarte %n de plus.</numerusform>
            <numerusform>Votre décision en écarte %n de plus.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n suspect(s) left.</source>
        <translation>
            <numerusform>Il reste %n suspect.</numerusform>
            <numerusform>Il reste %n suspects.</numerusform>
        </translation>
    </message>
    <message>
        <source>Every minimum of this take is decided.</source>
        <translation>Chaque minimum de cette prise est décidé.</translation>
    </message>
    <message>
        <source>No suspect is left. N leads through the other minima.</source>
        <translation>Il ne reste aucun suspect. N passe aux autres minima.</translation>
    </message>
    <message>
        <source>No boundary is selected. N leads to the most suspicious minimum.</source>
        <translation>Aucune limite n’est choisie. N mène au minimum le plus suspect.</translation>
    </message>
    <message>
        <source>No minimum is left to decide.</source>
        <translation>Il ne reste aucun minimum à décider.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RoleTable</name>
    <message>
        <source>read off the skeleton&apos;s shape</source>
        <translation>lu d’après la forme du squelette</translation>
    </message>
    <message>
        <source>no human body found</source>
        <translation>aucun corps humain trouvé</translation>
    </message>
    <message>
        <source>by %1 names</source>
        <translation>d’après les noms %1</translation>
    </message>
    <message>
        <source>Joints of the roles</source>
        <translation>Articulations des rôles</translation>
    </message>
    <message>
        <source>Which joint of the recording is which part of the body</source>
        <translation>Quelle articulation de l’enregistrement est quelle partie du corps</translation>
    </message>
    <message>
        <source>fighter 1</source>
        <translation>combattant 1</translation>
    </message>
    <message>
        <source>fighter 2</source>
        <translation>combattant 2</translation>
    </message>
    <message>
        <source>Fighter %1: %2 of %3 roles, %4.</source>
        <translation>Combattant %1&#xa0;: %2 rôles sur %3, %4.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>set by hand</source>
        <translation>fixé à la main</translation>
    </message>
    <message>
        <source>found</source>
        <translation>détecté</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>introuvable</translation>
    </message>
</context>
<context>
    <name>kumite::studio::RulesBox</name>
    <message>
        <source>Lands below</source>
        <translation>Se pose sous</translation>
    </message>
    <message>
        <source>Height below which a foot lands</source>
        <translation>Hauteur sous laquelle un pied se pose</translation>
    </message>
    <message>
        <source>A foot stands once its toes are lower than this above their rest height …</source>
        <translation>Un pied est posé dès que ses orteils sont plus bas que cela au-dessus de leur hauteur de repos …</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>slower than</source>
        <translation>plus lent que</translation>
    </message>
    <message>
        <source>Speed below which a foot lands</source>
        <translation>Vitesse sous laquelle un pied se pose</translation>
    </message>
    <message>
        <source>… and slower than this.</source>
        <translation>… et plus lents que cela.</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Lifts above</source>
        <translation>Se lève au-dessus de</translation>
    </message>
    <message>
        <source>Height above which a foot lifts</source>
        <translation>Hauteur au-dessus de laquelle un pied se lève</translation>
    </message>
    <message>
        <source>It no longer stands once its toes are higher than this …</source>
        <translation>Il n’est plus posé dès que ses orteils sont plus haut que cela …</translation>
    </message>
    <message>
        <source>faster than</source>
        <translation>plus vite que</translation>
    </message>
    <message>
        <source>Speed above which a foot lifts</source>
        <translation>Vitesse au-dessus de laquelle un pied se lève</translation>
    </message>
    <message>
        <source>… or faster than this.</source>
        <translation>… ou plus rapides que cela.</translation>
    </message>
    <message>
        <source>Stands for</source>
        <translation>Posé pendant</translation>
    </message>
    <message>
        <source>Shortest stance</source>
        <translation>Appui le plus court</translation>
    </message>
    <message>
        <source>A stance that is shorter does not count.</source>
        <translation>Un appui plus court ne compte pas.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Closes at</source>
        <translation>Approche à</translation>
    </message>
    <message>
        <source>Speed at which an attack must close</source>
        <translation>Vitesse à laquelle une attaque doit approcher</translation>
    </message>
    <message>
        <source>An attack counts for the react rule if its fist or foot closes on the trunk or head faster than this at some moment.</source>
        <translation>Une attaque compte pour la règle de réaction si son poing ou son pied approche du tronc ou de la tête plus vite que cela à un moment.</translation>
    </message>
    <message>
        <source>Usual thresholds</source>
        <translation>Seuils habituels</translation>
    </message>
    <message>
        <source>Back to the thresholds that the studio brings</source>
        <translation>Revenir aux seuils fournis par le studio</translation>
    </message>
    <message>
        <source>What the thresholds change</source>
        <translation>Ce que changent les seuils</translation>
    </message>
    <message>
        <source>Why the rules say so</source>
        <translation>Pourquoi les règles le disent</translation>
    </message>
    <message>
        <source>%1: no action</source>
        <translation>%1&#xa0;: aucune action</translation>
    </message>
    <message>
        <source>%1: %2 of %3 actions</source>
        <translation>%1&#xa0;: %2 actions sur %3</translation>
    </message>
    <message>
        <source>How many actions get another label stands here while a threshold is changed.</source>
        <translation>Combien d’actions changent d’étiquette s’affiche ici pendant qu’un seuil est modifié.</translation>
    </message>
    <message>
        <source>Changed: %1.</source>
        <translation>Changé&#xa0;: %1.</translation>
    </message>
    <message>
        <source>React: %1</source>
        <translation>Réaction&#xa0;: %1</translation>
    </message>
    <message>
        <source>Move: %1</source>
        <translation>Déplacement&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SegmentPanel</name>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Suspect minima</source>
        <translation>Minima suspects</translation>
    </message>
    <message>
        <source>Minima of the force curves that cut actions appear here, the most suspicious first. Lower the prominence below to see more.</source>
        <translation>Les minima des courbes de force qui découpent les actions apparaissent ici, le plus suspect d’abord. Baissez la proéminence ci-dessous pour en voir plus.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Revue</translation>
    </message>
    <message>
        <source>Detection</source>
        <translation>Détection</translation>
    </message>
    <message>
        <source>Why the minimum is suspected</source>
        <translation>Pourquoi le minimum est suspect</translation>
    </message>
    <message>
        <source>It is a boundary: no suspect any more; goes on to the next</source>
        <translation>C’est une limite&#xa0;: plus suspecte&#xa0;; passe à la suivante</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurer</translation>
    </message>
    <message>
        <source>A boundary that a hand has set.</source>
        <translation>Une limite fixée à la main.</translation>
    </message>
    <message>
        <source>No suspect is left. %1 leads through the others.</source>
        <translation>Il ne reste aucun suspect. %1 passe aux autres.</translation>
    </message>
    <message>
        <source>Bring the boundary back</source>
        <translation>Ramener la limite</translation>
    </message>
    <message>
        <source>It is spurious; goes on to the next</source>
        <translation>Elle est fausse&#xa0;; passe à la suivante</translation>
    </message>
    <message>
        <source>%1 leads to the most suspicious minimum. Remove it where the body hardly dips: a kick down and up again is one action. Keep it where one ends and another begins.</source>
        <translation>%1 mène au minimum le plus suspect. Supprimez-le là où le corps baisse à peine : un coup de pied qui descend et remonte est une seule action. Gardez-le là où une action finit et où une autre commence.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceBar</name>
    <message>
        <source>Time of the sequence</source>
        <translation>Temps de la séquence</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>sur %1</translation>
    </message>
    <message>
        <source>the chosen action, %1 s; Esc: back to the sequence</source>
        <translation>l’action choisie, %1 s&#xa0;; Échap&#xa0;: retour à la séquence</translation>
    </message>
    <message>
        <source>live: 1 … 9 play blocks at once</source>
        <translation>en direct&#xa0;: 1 … 9 jouent des blocs aussitôt</translation>
    </message>
    <message>
        <source> · last %1, cost %2</source>
        <translation> · dernière : %1, coût %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceCommands</name>
    <message>
        <source>Se&amp;quence</source>
        <translation>Sé&amp;quence</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lire ou suspendre</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Une image en arrière</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Une image en avant</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>À la fin</translation>
    </message>
    <message>
        <source>Play it &amp;over and over</source>
        <translation>Lire en &amp;boucle</translation>
    </message>
    <message>
        <source>&amp;Live: keys play blocks at once</source>
        <translation>En direc&amp;t&#xa0;: les touches jouent des blocs aussitôt</translation>
    </message>
    <message>
        <source>Live: block %1</source>
        <translation>En direct&#xa0;: bloc %1</translation>
    </message>
    <message>
        <source>Back to the sequence</source>
        <translation>Retour à la séquence</translation>
    </message>
    <message>
        <source>The playhead is not inside the chosen block.</source>
        <translation>La tête de lecture n’est pas dans le bloc choisi.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>Rogner %1</translation>
    </message>
    <message>
        <source>&amp;Add the chosen action</source>
        <translation>&amp;Ajouter l’action choisie</translation>
    </message>
    <message>
        <source>S&amp;wap the block for the chosen action</source>
        <translation>Remplacer le bloc par l’action c&amp;hoisie</translation>
    </message>
    <message>
        <source>&amp;Remove the block</source>
        <translation>&amp;Supprimer le bloc</translation>
    </message>
    <message>
        <source>Block before</source>
        <translation>Bloc précédent</translation>
    </message>
    <message>
        <source>Block after</source>
        <translation>Bloc suivant</translation>
    </message>
    <message>
        <source>Move the block &amp;earlier</source>
        <translation>Déplacer le bloc &amp;plus tôt</translation>
    </message>
    <message>
        <source>Move the &amp;block later</source>
        <translation>Déplacer le bloc pl&amp;us tard</translation>
    </message>
    <message>
        <source>Once &amp;more</source>
        <translation>U&amp;ne fois de plus</translation>
    </message>
    <message>
        <source>Repeat the block</source>
        <translation>Répéter le bloc</translation>
    </message>
    <message>
        <source>Once less</source>
        <translation>Une fois de moins</translation>
    </message>
    <message>
        <source>Repeat the block less</source>
        <translation>Répéter moins le bloc</translation>
    </message>
    <message>
        <source>Block begins at the playhead</source>
        <translation>Le bloc commence à la tête de lecture</translation>
    </message>
    <message>
        <source>Block ends at the playhead</source>
        <translation>Le bloc finit à la tête de lecture</translation>
    </message>
    <message>
        <source>The whole action again</source>
        <translation>L’action entière à nouveau</translation>
    </message>
    <message>
        <source>Trim nothing</source>
        <translation>Ne rien rogner</translation>
    </message>
    <message>
        <source>&amp;Draw the transition anew</source>
        <translation>Tire&amp;r à nouveau la transition</translation>
    </message>
    <message>
        <source>Draw all that are not locked anew</source>
        <translation>Tirer à nouveau toutes celles non verrouillées</translation>
    </message>
    <message>
        <source>Loc&amp;k the transition, or let it go</source>
        <translation>&amp;Verrouiller la transition, ou la libérer</translation>
    </message>
    <message>
        <source>Unlock the transition</source>
        <translation>Déverrouiller la transition</translation>
    </message>
    <message>
        <source>Lock the transition</source>
        <translation>Verrouiller la transition</translation>
    </message>
    <message>
        <source>Clear the sequence</source>
        <translation>Vider la séquence</translation>
    </message>
    <message>
        <source>&amp;Find an action</source>
        <translation>Tr&amp;ouver une action</translation>
    </message>
    <message>
        <source>Show all of it</source>
        <translation>La montrer en entier</translation>
    </message>
    <message>
        <source>Map of po&amp;ses</source>
        <translation>&amp;Carte des poses</translation>
    </message>
    <message>
        <source>Add &amp;clips of files…</source>
        <translation>A&amp;jouter des clips de fichiers…</translation>
    </message>
    <message>
        <source>Add cl&amp;ips of a folder…</source>
        <translation>Ajouter des clips d’un &amp;dossier…</translation>
    </message>
    <message>
        <source>Keep as a &amp;take…</source>
        <translation>&amp;Garder comme prise…</translation>
    </message>
    <message>
        <source>E&amp;xport the sequence…</source>
        <translation>E&amp;xporter la séquence…</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequencePanel</name>
    <message>
        <source>What appears here</source>
        <translation>Ce qui apparaît ici</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Actions</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Chercher des actions</translation>
    </message>
    <message>
        <source>Shows the actions in which every word appears: right kick</source>
        <translation>Affiche les actions où figure chaque mot&#xa0;: pied droit</translation>
    </message>
    <message>
        <source>Actions to choose from</source>
        <translation>Actions à choisir</translation>
    </message>
    <message>
        <source>Clips…</source>
        <translation>Clips…</translation>
    </message>
    <message>
        <source>Keep…</source>
        <translation>Garder…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Actions of the takes, and clips of other files, in any order, led over to each other: they appear here.</source>
        <translation>Des actions des prises, et des clips d’autres fichiers, dans n’importe quel ordre, enchaînés l’un à l’autre&#xa0;: ils apparaissent ici.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceSession</name>
    <message>
        <source>Preparing the clips</source>
        <translation>Préparation des clips</translation>
    </message>
    <message>
        <source>Making the motion</source>
        <translation>Création du mouvement</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Swap for %1</source>
        <translation>Échanger contre %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message>
        <source>Clear the sequence</source>
        <translation>Vider la séquence</translation>
    </message>
    <message>
        <source>Draw the transition anew</source>
        <translation>Tirer à nouveau la transition</translation>
    </message>
    <message>
        <source>Draw all anew</source>
        <translation>Tout tirer à nouveau</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SequenceStrip</name>
    <message>
        <source>Blocks of the sequence</source>
        <translation>Blocs de la séquence</translation>
    </message>
    <message>
        <source>  (%1 of %2)</source>
        <translation>  (%1 sur %2)</translation>
    </message>
    <message>
        <source>Actions in the order in which they shall be played. Choose one at the right and press Return to add it.</source>
        <translation>Les actions dans l’ordre où elles seront lues. Choisissez-en une à droite et pressez Entrée pour l’ajouter.</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>Le mouvement se prépare.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>Rogner %1</translation>
    </message>
    <message>
        <source>Drag to trim</source>
        <translation>Tirez pour rogner</translation>
    </message>
    <message>
        <source>transition to %1 · %2 to %3</source>
        <translation>transition vers %1 · %2 à %3</translation>
    </message>
    <message>
        <source>%1 · %2 to %3</source>
        <translation>%1 · %2 à %3</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Session</name>
    <message>
        <source>The edit that waited was dropped: another take is shown.</source>
        <translation>La modification en attente a été abandonnée&#xa0;: une autre prise est affichée.</translation>
    </message>
    <message>
        <source>The edit waits until the force curves are computed.</source>
        <translation>La modification attend que les courbes de force soient calculées.</translation>
    </message>
    <message>
        <source>No boundary of %1 lies within 0.1 s of the playhead.</source>
        <translation>Aucune limite de %1 n’est à moins de 0,1 s de la tête de lecture.</translation>
    </message>
    <message>
        <source>This is the first action: nothing comes before it.</source>
        <translation>C’est la première action&#xa0;: rien ne la précède.</translation>
    </message>
    <message>
        <source>This is the last action: nothing comes after it.</source>
        <translation>C’est la dernière action&#xa0;: rien ne la suit.</translation>
    </message>
    <message>
        <source>A removed boundary does not move. Del restores it.</source>
        <translation>Une limite supprimée ne se déplace pas. Suppr la rétablit.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SettingsFields</name>
    <message>
        <source>Cutoff of the low-pass in Hz</source>
        <translation>Coupure du passe-bas en Hz</translation>
    </message>
    <message>
        <source>Low-pass over the centre of mass: lower gives smoother curves and fewer minima.</source>
        <translation>Passe-bas sur le centre de masse&#xa0;: plus bas, les courbes sont plus lisses et les minima moins nombreux.</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>Least prominence in body weights</source>
        <translation>Proéminence minimale en poids du corps</translation>
    </message>
    <message>
        <source>A minimum must be at least this deep to be a boundary.</source>
        <translation>Un minimum doit être au moins aussi profond pour être une limite.</translation>
    </message>
    <message>
        <source> BW</source>
        <translation> BW</translation>
    </message>
    <message>
        <source>Cutoff</source>
        <translation>Coupure</translation>
    </message>
    <message>
        <source>Promin.</source>
        <translation>Proém.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>length of the force</source>
        <translation>norme de la force</translation>
    </message>
    <message>
        <source>vertical part</source>
        <translation>part verticale</translation>
    </message>
    <message>
        <source>Curve that is cut at its minima</source>
        <translation>Courbe coupée à ses minima</translation>
    </message>
    <message>
        <source>Which curve is cut at its minima: the length of the contact force or its vertical part.</source>
        <translation>Quelle courbe est coupée à ses minima&#xa0;: la norme de la force de contact ou sa part verticale.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SimilarBox</name>
    <message>
        <source>this one, %1</source>
        <translation>celle-ci, %1</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>accepté</translation>
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
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Nearest by the numbers from which the machine learns; ⇄: its mirror image is near, and it is seen from the other side. All begin and end together.</source>
        <translation>Les plus proches selon les nombres dont la machine apprend&#xa0;; ⇄&#xa0;: son image miroir est proche, et elle est vue de l’autre côté. Toutes commencent et finissent ensemble.</translation>
    </message>
    <message>
        <source>The chosen ones get the label of the first one, said by a hand, as one step of the history. A click or Space chooses, a double click or Enter goes there.</source>
        <translation>Celles qui sont choisies reçoivent l’étiquette de la première, comme dite à la main, en une étape de l’historique. Un clic ou Espace choisit, un double-clic ou Entrée y va.</translation>
    </message>
    <message>
        <source>Show both fighters: the opponent, too</source>
        <translation>Afficher les deux combattants&#xa0;: aussi l’adversaire</translation>
    </message>
    <message>
        <source>Comparing actions</source>
        <translation>Comparaison des actions</translation>
    </message>
    <message>
        <source>The actions most like the current one.</source>
        <translation>Les actions les plus semblables à l’actuelle.</translation>
    </message>
    <message>
        <source>The actions most like the current one appear here, once there is an action at the playhead.</source>
        <translation>Les actions les plus semblables à l’actuelle apparaissent ici, dès qu’il y a une action à la tête de lecture.</translation>
    </message>
    <message>
        <source>Same label for all</source>
        <translation>Même étiquette pour toutes</translation>
    </message>
    <message>
        <source>Same label for %1</source>
        <translation>Même étiquette pour %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageCommands</name>
    <message>
        <source>Save a picture of the 3D view</source>
        <translation>Enregistrer une capture de la vue 3D</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>Picture of the 3D view</source>
        <translation>Capture de la vue 3D</translation>
    </message>
    <message>
        <source>%1: the picture cannot be written there.</source>
        <translation>%1&#xa0;: impossible d’y écrire la capture.</translation>
    </message>
    <message>
        <source>3&amp;D view</source>
        <translation>&amp;Vue 3D</translation>
    </message>
    <message>
        <source>From the f&amp;ront</source>
        <translation>De &amp;face</translation>
    </message>
    <message>
        <source>From the &amp;side</source>
        <translation>De &amp;côté</translation>
    </message>
    <message>
        <source>From a&amp;bove</source>
        <translation>D’en &amp;haut</translation>
    </message>
    <message>
        <source>Over the shoulder of fighter 1</source>
        <translation>Par-dessus l’épaule du combattant 1</translation>
    </message>
    <message>
        <source>Over the shoulder of fighter 2</source>
        <translation>Par-dessus l’épaule du combattant 2</translation>
    </message>
    <message>
        <source>&amp;Follow the fighters</source>
        <translation>&amp;Suivre les combattants</translation>
    </message>
    <message>
        <source>Foot &amp;contacts</source>
        <translation>Con&amp;tacts des pieds</translation>
    </message>
    <message>
        <source>&amp;Trails of hands and feet</source>
        <translation>T&amp;raînées des mains et des pieds</translation>
    </message>
    <message>
        <source>Centre of &amp;mass</source>
        <translation>Centre de &amp;masse</translation>
    </message>
    <message>
        <source>Contact f&amp;orce</source>
        <translation>F&amp;orce de contact</translation>
    </message>
    <message>
        <source>&amp;Ghosts</source>
        <translation>Fa&amp;ntômes</translation>
    </message>
    <message>
        <source>Longer trails</source>
        <translation>Traînées plus longues</translation>
    </message>
    <message>
        <source>Shorter trails</source>
        <translation>Traînées plus courtes</translation>
    </message>
    <message>
        <source>&amp;Leave a ghost here</source>
        <translation>&amp;Laisser un fantôme ici</translation>
    </message>
    <message>
        <source>Remove all ghosts</source>
        <translation>Supprimer tous les fantômes</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>Mes&amp;urer</translation>
    </message>
    <message>
        <source>Measure: next joint</source>
        <translation>Mesurer&#xa0;: articulation suivante</translation>
    </message>
    <message>
        <source>Measure: joint before</source>
        <translation>Mesurer&#xa0;: articulation précédente</translation>
    </message>
    <message>
        <source>Measure from, then to this joint</source>
        <translation>Mesurer depuis, puis vers cette articulation</translation>
    </message>
    <message>
        <source>Leave measuring</source>
        <translation>Quitter la mesure</translation>
    </message>
    <message>
        <source>Co&amp;py a picture</source>
        <translation>Co&amp;pier une capture</translation>
    </message>
    <message>
        <source>Save a p&amp;icture…</source>
        <translation>&amp;Enregistrer une capture…</translation>
    </message>
    <message>
        <source>Click two joints; or %1 and %2 lead to a joint, %3 takes it</source>
        <translation>Cliquez sur deux articulations&#xa0;; ou %1 et %2 mènent à une articulation, %3 la prend</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageTools</name>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Where the camera stands</source>
        <translation>Où se tient la caméra</translation>
    </message>
    <message>
        <source>Shown in 3D</source>
        <translation>Affiché en 3D</translation>
    </message>
    <message>
        <source>What the 3D view shows</source>
        <translation>Ce que montre la vue 3D</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Trails, frames</source>
        <translation>Traînées, images</translation>
    </message>
    <message>
        <source>Frames of trail before the shown one</source>
        <translation>Images de traînée avant celle affichée</translation>
    </message>
    <message>
        <source>Frames of trail after the shown one</source>
        <translation>Images de traînée après celle affichée</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StageView</name>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>The fighters at the playhead: a drag turns, the wheel zooms</source>
        <translation>Les combattants à la tête de lecture&#xa0;: glisser tourne, la molette zoome</translation>
    </message>
    <message>
        <source>before the action</source>
        <translation>avant l’action</translation>
    </message>
    <message>
        <source>after the action</source>
        <translation>après l’action</translation>
    </message>
    <message>
        <source>grid 1 m</source>
        <translation>grille de 1 m</translation>
    </message>
    <message>
        <source>   ·   left limbs lighter</source>
        <translation>   ·   membres gauches plus clairs</translation>
    </message>
    <message>
        <source>   ·   arrow: contact force, 0.5 m per BW</source>
        <translation>   ·   flèche&#xa0;: force de contact, 0,5 m par BW</translation>
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
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>No joint is chosen. %1</source>
        <translation>Aucune articulation n’est choisie. %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::StatisticsBox</name>
    <message>
        <source>actions</source>
        <translation>actions</translation>
    </message>
    <message>
        <source>Actions that the stream is cut into</source>
        <translation>Actions découpées dans le flux</translation>
    </message>
    <message>
        <source>min/s</source>
        <translation>min/s</translation>
    </message>
    <message>
        <source>Minima a second that cut by themselves</source>
        <translation>Minima par seconde qui coupent d’eux-mêmes</translation>
    </message>
    <message>
        <source>corr.</source>
        <translation>corr.</translation>
    </message>
    <message>
        <source>Share of boundaries that a hand removed, moved or added</source>
        <translation>Part des limites supprimées, déplacées ou ajoutées à la main</translation>
    </message>
    <message>
        <source>left</source>
        <translation>reste</translation>
    </message>
    <message>
        <source>Suspects that nobody has decided yet. Every decision teaches what is suspect, so that others may be cleared, too</source>
        <translation>Suspects que personne n’a encore décidés. Chaque décision apprend ce qui est suspect, si bien que d’autres peuvent être écartés aussi</translation>
    </message>
    <message>
        <source>take</source>
        <translation>prise</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SurpriseStrip</name>
    <message>
        <source>Surprise of the transitions</source>
        <translation>Surprise des transitions</translation>
    </message>
    <message>
        <source>Both terms</source>
        <translation>Les deux termes</translation>
    </message>
    <message>
        <source>−log P(next | own, opponent, motion): seen how it moves, another label was likelier. Finds labels that are wrong.</source>
        <translation>−log P(suite | propre, adversaire, mouvement)&#xa0;: vu comment il bouge, une autre étiquette était plus probable. Trouve les étiquettes fausses.</translation>
    </message>
    <message>
        <source>Label term alone</source>
        <translation>Terme d’étiquette seul</translation>
    </message>
    <message>
        <source>−log P(next | own, opponent): a label that seldom follows. Finds rare decisions.</source>
        <translation>−log P(suite | propre, adversaire)&#xa0;: une étiquette qui suit rarement. Trouve les décisions rares.</translation>
    </message>
    <message>
        <source>Geometry term alone</source>
        <translation>Terme géométrique seul</translation>
    </message>
    <message>
        <source>−log density of places, facing and poses under the label, from its mean: no probability. Finds odd poses and places.</source>
        <translation>−log densité des places, orientations et poses sous l’étiquette, depuis sa moyenne&#xa0;: pas une probabilité. Trouve les poses et places étranges.</translation>
    </message>
    <message>
        <source>How unexpected each transition was to a model that had not seen it, in nats.
%1</source>
        <translation>À quel point chaque transition était inattendue pour un modèle qui ne l’avait pas vue, en nats.
%1</translation>
    </message>
    <message>
        <source>Which surprise is shown</source>
        <translation>Quelle surprise est affichée</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>surprise</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 → %4 while %5   ·   %6</source>
        <translation>%1 · %2 · %3 → %4 face à %5   ·   %6</translation>
    </message>
</context>
<context>
    <name>kumite::studio::SuspectsModel</name>
    <message>
        <source>, removed</source>
        <translation>, supprimé</translation>
    </message>
    <message>
        <source>, accepted</source>
        <translation>, accepté</translation>
    </message>
    <message>
        <source>, set by hand</source>
        <translation>, fixé à la main</translation>
    </message>
    <message>
        <source>%1, suspicion %2: %3</source>
        <translation>%1, suspicion %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>What speaks against the minimum, and how deep it is</source>
        <translation>Ce qui parle contre le minimum, et sa profondeur</translation>
    </message>
    <message>
        <source>How likely the minimum is spurious, learnt from what hands removed and accepted; ✓ accepted or set by hand, × removed</source>
        <translation>À quel point le minimum est sans doute faux, appris de ce qui a été supprimé et accepté à la main&#xa0;; ✓ accepté ou fixé à la main, × supprimé</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>why</source>
        <translation>raison</translation>
    </message>
    <message>
        <source>susp.</source>
        <translation>susp.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TakesList</name>
    <message>
        <source>%1
Double-click or F2 renames, Alt+↑ ↓ or a drag moves it.</source>
        <translation>%1
Double-clic ou F2 renomme, Alt+↑ ↓ ou glisser la déplace.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TimelineView</name>
    <message>
        <source>time, frame</source>
        <translation>temps, image</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>image</translation>
    </message>
    <message>
        <source>Release to move the boundary here, Esc to leave it, Ctrl or Alt to place it freely.</source>
        <translation>Relâchez pour déplacer la limite ici, Échap pour la laisser, Ctrl ou Alt pour la placer librement.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Ligne de temps</translation>
    </message>
    <message>
        <source>Force curves of the fighters, the boundaries that cut them, and the actions between</source>
        <translation>Courbes de force des combattants, limites qui les coupent, et actions entre elles</translation>
    </message>
    <message>
        <source>Preparing curves</source>
        <translation>Préparation des courbes</translation>
    </message>
    <message>
        <source>%1 · frame %2</source>
        <translation>%1 · image %2</translation>
    </message>
    <message>
        <source>%1 · %2 · frame %3</source>
        <translation>%1 · %2 · image %3</translation>
    </message>
    <message>
        <source> · action %1</source>
        <translation> · action %1</translation>
    </message>
    <message>
        <source> · note: %1</source>
        <translation> · note&#xa0;: %1</translation>
    </message>
    <message>
        <source> · removed boundary</source>
        <translation> · limite supprimée</translation>
    </message>
    <message>
        <source> · accepted boundary</source>
        <translation> · limite acceptée</translation>
    </message>
    <message>
        <source> · moved boundary</source>
        <translation> · limite déplacée</translation>
    </message>
    <message>
        <source> · added boundary</source>
        <translation> · limite ajoutée</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Tour</name>
    <message>
        <source>&amp;Tour on the demo bout</source>
        <translation>Visite &amp;guidée sur le combat de démonstration</translation>
    </message>
    <message>
        <source>Tour: next step</source>
        <translation>Visite&#xa0;: étape suivante</translation>
    </message>
    <message>
        <source>Tour: step before</source>
        <translation>Visite&#xa0;: étape précédente</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Quitter la visite</translation>
    </message>
    <message>
        <source>Correct a suspect</source>
        <translation>Corriger un suspect</translation>
    </message>
    <message>
        <source>Label an action</source>
        <translation>Étiqueter une action</translation>
    </message>
    <message>
        <source>%1 leads to the action that says most; it loops. Say what it is: %2 is a left punch forward, %3 a right one; the palette shows the other keys.</source>
        <translation>%1 mène à l’action qui en dit le plus&#xa0;; elle tourne en boucle. Dites ce que c’est&#xa0;: %2 est un coup de poing gauche vers l’avant, %3 un droit&#xa0;; la palette montre les autres touches.</translation>
    </message>
    <message>
        <source>Let the machine say the rest</source>
        <translation>Laisser la machine dire le reste</translation>
    </message>
    <message>
        <source>A machine learns from your labels. One is few: here a third of the bout can be labelled for you. Then %1 accepts all that the machine is sure of; %2 takes it back.</source>
        <translation>Une machine apprend de vos étiquettes. Une seule, c’est peu&#xa0;: ici, un tiers du combat peut être étiqueté pour vous. Ensuite %1 accepte tout ce dont la machine est sûre&#xa0;; %2 y revient.</translation>
    </message>
    <message>
        <source>Label a third for me</source>
        <translation>M’en étiqueter un tiers</translation>
    </message>
    <message>
        <source>See what follows what</source>
        <translation>Voir ce qui suit quoi</translation>
    </message>
    <message>
        <source>A row is what goes on, a column what comes next. Click a cell: the moments behind it are listed, a click plays one. %1 leads to the most surprising moment.</source>
        <translation>Une ligne est ce qui est en cours, une colonne ce qui vient ensuite. Cliquez sur une cellule&#xa0;: les moments derrière sont listés, un clic en lit un. %1 mène au moment le plus surprenant.</translation>
    </message>
    <message>
        <source>Let them fight on</source>
        <translation>Les laisser combattre</translation>
    </message>
    <message>
        <source>%1 starts a bout that was never fought, made from what was learnt. Every choice stands at the right; a click takes another one. Back with %2, on otherwise with %3.</source>
        <translation>%1 lance un combat qui n’a jamais eu lieu, fait de ce qui a été appris. Chaque choix est affiché à droite&#xa0;; un clic en prend un autre. Retour avec %2, continuer autrement avec %3.</translation>
    </message>
    <message>
        <source>The minima of the force cut the bout into actions; a few are wrong. %1 leads to the likeliest, plays it and says why; %2 stops. %3 keeps it, %4 removes it.</source>
        <translation>Les minima de la force découpent le combat en actions&#xa0;; quelques-uns sont faux. %1 mène au plus probable, le lit et dit pourquoi&#xa0;; %2 arrête. %3 le garde, %4 le supprime.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TourBox</name>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ Fait</translation>
    </message>
    <message>
        <source>This step is done</source>
        <translation>Cette étape est faite</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 sur %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Tour, step %1</source>
        <translation>Visite, étape %1</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TraceBox</name>
    <message>
        <source>Behind it</source>
        <translation>Derrière</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>Ce qui est choisi</translation>
    </message>
    <message>
        <source>Transitions behind it</source>
        <translation>Les transitions derrière</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>surprise</translation>
    </message>
    <message>
        <source>Choose a cell, a node, an edge or a row above: the moments behind it appear here, and a click plays them.</source>
        <translation>Choisissez une cellule, un nœud, une arête ou une ligne au-dessus&#xa0;: les moments derrière apparaissent ici, et un clic les lit.</translation>
    </message>
    <message>
        <source>%1. Never seen.</source>
        <translation>%1. Jamais vu.</translation>
    </message>
    <message>
        <source>%1. Seen once.</source>
        <translation>%1. Vu une fois.</translation>
    </message>
    <message>
        <source>%1. Seen %2 times.</source>
        <translation>%1. Vu %2 fois.</translation>
    </message>
    <message>
        <source>%1. Never seen so; these share the own label.</source>
        <translation>%1. Jamais vu ainsi&#xa0;; ceux-ci partagent l’étiquette propre.</translation>
    </message>
    <message>
        <source>%1. Never seen so; these share the opponent&apos;s label.</source>
        <translation>%1. Jamais vu ainsi&#xa0;; ceux-ci partagent l’étiquette de l’adversaire.</translation>
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
        <translation>%1, %2&#xa0;: %3
%4
Un clic le lit</translation>
    </message>
    <message>
        <source>Surprise (%1), nats: how unexpected it was to a model that had not seen it</source>
        <translation>Surprise (%1), nats&#xa0;: à quel point c’était inattendu pour un modèle qui ne l’avait pas vu</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>own → next</source>
        <translation>propre → suite</translation>
    </message>
    <message>
        <source>surprise</source>
        <translation>surprise</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TrackPainter</name>
    <message>
        <source>The recording of %1 is missing. File ▸ Find recording… points to it.</source>
        <translation>L’enregistrement de %1 manque. Fichier ▸ Trouver l’enregistrement… indique où il est.</translation>
    </message>
    <message>
        <source>No contact force: this skeleton has no body that is known here. S adds boundaries by hand.</source>
        <translation>Pas de force de contact&#xa0;: ce squelette n’a aucun corps connu ici. S ajoute des limites à la main.</translation>
    </message>
    <message>
        <source>force, BW</source>
        <translation>force, BW</translation>
    </message>
    <message>
        <source>unsmoothed</source>
        <translation>sans lissage</translation>
    </message>
    <message>
        <source>COM, m</source>
        <translation>CDM, m</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>hands, m/s</source>
        <translation>mains, m/s</translation>
    </message>
    <message>
        <source>feet, m/s</source>
        <translation>pieds, m/s</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TransitionBox</name>
    <message>
        <source>Transition</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>The transition</source>
        <translation>La transition</translation>
    </message>
    <message>
        <source>Ways that the transition can go</source>
        <translation>Chemins possibles de la transition</translation>
    </message>
    <message>
        <source>A click, or Return, takes another way</source>
        <translation>Un clic, ou Entrée, prend un autre chemin</translation>
    </message>
    <message>
        <source>Choose a block, or the transition before it.</source>
        <translation>Choisissez un bloc, ou la transition qui le précède.</translation>
    </message>
    <message>
        <source>The first block begins where it was recorded.</source>
        <translation>Le premier bloc commence là où il a été enregistré.</translation>
    </message>
    <message>
        <source>There is no transition.</source>
        <translation>Il n’y a pas de transition.</translation>
    </message>
    <message>
        <source>The motion is being made.</source>
        <translation>Le mouvement se prépare.</translation>
    </message>
    <message>
        <source>straight from pose to pose</source>
        <translation>tout droit de pose à pose</translation>
    </message>
    <message>
        <source>on a curve</source>
        <translation>sur une courbe</translation>
    </message>
    <message>
        <source>along recorded clips past %1 poses</source>
        <translation>le long de clips enregistrés, par %1 poses</translation>
    </message>
    <message>
        <source>between poses that are alike</source>
        <translation>entre poses semblables</translation>
    </message>
    <message>
        <source>To %1: %2 s, %3%4</source>
        <translation>Vers %1&#xa0;: %2 s, %3%4</translation>
    </message>
    <message>
        <source>. Locked.</source>
        <translation>. Verrouillée.</translation>
    </message>
    <message>
        <source>drawn by cost</source>
        <translation>tiré selon le coût</translation>
    </message>
    <message>
        <source>path %1 · they meet as they are</source>
        <translation>chemin %1 · ils se rejoignent tels quels</translation>
    </message>
    <message>
        <source>path %1 · cost %2 · clips: %3</source>
        <translation>chemin %1 · coût %2 · clips&#xa0;: %3</translation>
    </message>
    <message>
        <source>curve (Bézier)</source>
        <translation>courbe (Bézier)</translation>
    </message>
    <message>
        <source>straight, for comparison</source>
        <translation>tout droit, pour comparer</translation>
    </message>
    <message>
        <source>Take another transition</source>
        <translation>Prendre une autre transition</translation>
    </message>
</context>
<context>
    <name>kumite::studio::TransportBar</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source>Playback speed: - slower, + faster</source>
        <translation>Vitesse de lecture&#xa0;: - plus lent, + plus vite</translation>
    </message>
    <message>
        <source>Rows ▾</source>
        <translation>Lignes ▾</translation>
    </message>
    <message>
        <source>Rows of the timeline</source>
        <translation>Lignes de la ligne de temps</translation>
    </message>
    <message>
        <source>What the timeline shows: curves, speeds, units of the ruler</source>
        <translation>Ce que montre la ligne de temps&#xa0;: courbes, vitesses, unités de la graduation</translation>
    </message>
    <message>
        <source>selected: boundary of %1 at %2</source>
        <translation>choisi&#xa0;: limite de %1 à %2</translation>
    </message>
    <message>
        <source>selected: action of %1, %2 to %3</source>
        <translation>choisi&#xa0;: action de %1, %2 à %3</translation>
    </message>
    <message>
        <source>active: %1</source>
        <translation>actif&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::UnmatchedBox</name>
    <message>
        <source>Put boundary</source>
        <translation>Poser la limite</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Oublier</translation>
    </message>
    <message>
        <source>Corrections without a minimum</source>
        <translation>Corrections sans minimum</translation>
    </message>
    <message>
        <source>With the present settings these corrections mean nothing any more.</source>
        <translation>Avec les réglages actuels, ces corrections ne veulent plus rien dire.</translation>
    </message>
    <message>
        <source>Put a boundary by hand where the correction had one</source>
        <translation>Poser une limite à la main là où la correction en avait une</translation>
    </message>
    <message>
        <source>Drop the correction from the project</source>
        <translation>Enlever la correction du projet</translation>
    </message>
</context>
<context>
    <name>kumite::studio::VersionsDialog</name>
    <message>
        <source>Restore</source>
        <translation>Restaurer</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Ouvrir une copie</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versions</translation>
    </message>
    <message>
        <source>Versions, the newest first</source>
        <translation>Versions, la plus récente d’abord</translation>
    </message>
    <message>
        <source>States that were saved over; a double-click restores one</source>
        <translation>États écrasés par un enregistrement&#xa0;; un double-clic en restaure un</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Prises</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Corrections</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Open the chosen version as a project without a file</source>
        <translation>Ouvrir la version choisie comme projet sans fichier</translation>
    </message>
    <message>
        <source>Make the chosen version the open project; undo takes it back (Enter)</source>
        <translation>Faire de la version choisie le projet ouvert&#xa0;; annuler y revient (Entrée)</translation>
    </message>
    <message>
        <source>Leave everything as it is (Esc)</source>
        <translation>Laisser tout tel quel (Échap)</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Recherche…</translation>
    </message>
    <message>
        <source>Reading versions</source>
        <translation>Lecture des versions</translation>
    </message>
    <message>
        <source>No earlier version yet. Every save keeps what the file held before; the last ten are listed here.</source>
        <translation>Pas encore de version antérieure. Chaque enregistrement garde ce que le fichier contenait avant&#xa0;; les dix derniers sont listés ici.</translation>
    </message>
    <message>
        <source>What the project file held before each of the last saves. Restoring is an edit: undo takes it back, and the file changes only when you save.</source>
        <translation>Ce que le fichier du projet contenait avant chacun des derniers enregistrements. Restaurer est une modification&#xa0;: annuler y revient, et le fichier ne change que lorsque vous enregistrez.</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>illisible</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WelcomePage</name>
    <message>
        <source>Cut a recorded bout into actions: both fighters in 3D over the force that they exert against the ground. Its minima are the boundaries; you correct the few that are wrong. Then say what a few actions are, and the machine says it of the rest.</source>
        <translation>Découpez un combat enregistré en actions&#xa0;: les deux combattants en 3D au-dessus de la force qu’ils exercent sur le sol. Ses minima sont les limites&#xa0;; vous corrigez les quelques fausses. Dites ensuite ce que sont quelques actions, et la machine le dit du reste.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Or drop recordings (BVH, or AMC with its ASF) or a project on this window.</source>
        <translation>Ou déposez des enregistrements (BVH, ou AMC avec son ASF) ou un projet sur cette fenêtre.</translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation>Ouverts récemment</translation>
    </message>
    <message>
        <source>Projects and recordings that you open appear here, with the day and the folder.</source>
        <translation>Les projets et enregistrements que vous ouvrez apparaissent ici, avec le jour et le dossier.</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WelcomePicture</name>
    <message>
        <source>Two fighters over the curves of their contact force, which is cut into actions at its minima</source>
        <translation>Deux combattants au-dessus des courbes de leur force de contact, découpée en actions à ses minima</translation>
    </message>
    <message>
        <source>force</source>
        <translation>force</translation>
    </message>
    <message>
        <source>actions</source>
        <translation>actions</translation>
    </message>
</context>
<context>
    <name>kumite::studio::WhatIfBox</name>
    <message>
        <source>at playhead</source>
        <translation>à la tête de lecture</translation>
    </message>
    <message>
        <source>Both labels are those of the moment that is shown</source>
        <translation>Les deux étiquettes sont celles du moment affiché</translation>
    </message>
    <message>
        <source>own</source>
        <translation>propre</translation>
    </message>
    <message>
        <source>What the fighter does now</source>
        <translation>Ce que fait le combattant maintenant</translation>
    </message>
    <message>
        <source>opponent</source>
        <translation>adversaire</translation>
    </message>
    <message>
        <source>What the opponent does now</source>
        <translation>Ce que fait l’adversaire maintenant</translation>
    </message>
    <message>
        <source>What comes next</source>
        <translation>Ce qui vient ensuite</translation>
    </message>
    <message>
        <source>What next?</source>
        <translation>Et ensuite&#xa0;?</translation>
    </message>
    <message>
        <source>What %1 may do next, the likeliest first</source>
        <translation>Ce que %1 peut faire ensuite, le plus probable d’abord</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>n’importe quoi</translation>
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
        <translation>étiq. %1</translation>
    </message>
    <message>
        <source>geom. %1</source>
        <translation>géom. %1</translation>
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
        <translation>%1&#xa0;: P %2, terme d’étiquette %3</translation>
    </message>
    <message>
        <source>, geometry term %1</source>
        <translation>, terme géométrique %1</translation>
    </message>
    <message>
        <source>
Seen %1 times with both labels, %2 with the own, %3 with the opponent&apos;s</source>
        <translation>
Vu %1 fois avec les deux étiquettes, %2 avec la propre, %3 avec celle de l’adversaire</translation>
    </message>
    <message>
        <source>
This is what came next</source>
        <translation>
C’est ce qui est venu ensuite</translation>
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
        <translation>proéminence %1</translation>
    </message>
    <message>
        <source>slow left kick, %1</source>
        <translation>coup de pied gauche lent, %1</translation>
    </message>
    <message>
        <source>slow right kick, %1</source>
        <translation>coup de pied droit lent, %1</translation>
    </message>
    <message>
        <source>left foot moves at %1 m/s, %2</source>
        <translation>le pied gauche bouge à %1 m/s, %2</translation>
    </message>
    <message>
        <source>right foot moves at %1 m/s, %2</source>
        <translation>le pied droit bouge à %1 m/s, %2</translation>
    </message>
    <message>
        <source>shallow, %1</source>
        <translation>peu profond, %1</translation>
    </message>
    <message>
        <source>%1 s from the next minimum, %2</source>
        <translation>à %1 s du minimum suivant, %2</translation>
    </message>
    <message>
        <source>hardly dips (to %1), %2</source>
        <translation>baisse à peine (à %1), %2</translation>
    </message>
    <message>
        <source>nothing unusual, %1</source>
        <translation>rien d’inhabituel, %1</translation>
    </message>
    <message>
        <source>left kick</source>
        <translation>coup de pied gauche</translation>
    </message>
    <message>
        <source>right kick</source>
        <translation>coup de pied droit</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>pied gauche</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>pied droit</translation>
    </message>
    <message>
        <source>shallow</source>
        <translation>peu profond</translation>
    </message>
    <message>
        <source>crowded</source>
        <translation>serré</translation>
    </message>
    <message>
        <source>hardly dips</source>
        <translation>baisse à peine</translation>
    </message>
    <message>
        <source>%1, suspicion %2</source>
        <translation>%1, suspicion %2</translation>
    </message>
    <message>
        <source>removal at %1</source>
        <translation>suppression à %1</translation>
    </message>
    <message>
        <source>addition at %1</source>
        <translation>ajout à %1</translation>
    </message>
    <message>
        <source>move from %1 to %2</source>
        <translation>déplacement de %1 à %2</translation>
    </message>
    <message>
        <source>acceptance at %1</source>
        <translation>acceptation à %1</translation>
    </message>
    <message>
        <source>fighter %1</source>
        <translation>combattant %1</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>aujourd’hui %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>hier %1</translation>
    </message>
    <message>
        <source>Computer %1, process %2, since %3.</source>
        <translation>Ordinateur %1, processus %2, depuis %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s)</source>
        <translation>
            <numerusform>%n modification</numerusform>
            <numerusform>%n modifications</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::WorkspaceBar</name>
    <message>
        <source>Workspaces</source>
        <translation>Espaces de travail</translation>
    </message>
    <message>
        <source>%1 workspace</source>
        <translation>Espace %1</translation>
    </message>
</context>
<context>
    <name>kumite::studio::Workspaces</name>
    <message>
        <source>%1 workspace</source>
        <translation>Espace %1</translation>
    </message>
</context>
</TS>
