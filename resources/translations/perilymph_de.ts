<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_US">
<context>
    <name>ArrayTour</name>
    <message>
        <source>This array is pre-curved: it curls around the core of the snail, close to the hearing nerve.</source>
        <translation>Dieser Träger ist vorgekrümmt: Er legt sich um den Kern der Schnecke, nahe an den Hörnerv.</translation>
    </message>
    <message>
        <source>This array is straight: it bends along the outer wall of the snail and slides on.</source>
        <translation>Dieser Träger ist gerade: Er biegt sich entlang der Außenwand der Schnecke und gleitet weiter.</translation>
    </message>
</context>
<context>
    <name>Data</name>
    <message>
        <source>1.71 L + 0.18, L = 1.18 (A - 1) + 2.69 (B - 1) - sqrt(0.72 (A - 1) (B - 1))</source>
        <translation>1,71 L + 0,18, L = 1,18 (A - 1) + 2,69 (B - 1) - sqrt(0,72 (A - 1) (B - 1))</translation>
    </message>
    <message>
        <source>Schurzig et al. 2018; constants unverified, within 1 % of the average scala tympani (Froehlich et al. 2024)</source>
        <translation>Schurzig et al. 2018; Konstanten nicht überprüft, bis auf 1 % bei der mittleren Scala tympani (Froehlich et al. 2024)</translation>
    </message>
    <message>
        <source>Rau et al. 2024, Front Neurol 15:1400455: force-sensing hand tool, 5 patients, 4 profiles</source>
        <translation>Rau et al. 2024, Front Neurol 15:1400455: Handinstrument mit Kraftmessung, 5 Patienten, 4 Verläufe</translation>
    </message>
    <message>
        <source>Rau et al. 2024: end of insertion 17.2 to 43.6 mN</source>
        <translation>Rau et al. 2024: am Ende der Insertion 17,2 bis 43,6 mN</translation>
    </message>
    <message>
        <source>Rau et al. 2024: peaks 44.8 to 102.4 mN</source>
        <translation>Rau et al. 2024: Spitzen von 44,8 bis 102,4 mN</translation>
    </message>
    <message>
        <source>in vitro, models and temporal bones</source>
        <translation>in vitro, Modelle und Felsenbeine</translation>
    </message>
    <message>
        <source>in vivo, lateral-wall arrays, hand-held force sensor</source>
        <translation>in vivo, Träger der lateralen Wand, Kraftsensor in der Hand</translation>
    </message>
    <message>
        <source>perception threshold</source>
        <translation>Wahrnehmungsschwelle</translation>
    </message>
    <message>
        <source>published measurements, mean ± SD</source>
        <translation>veröffentlichte Messungen, Mittelwert ± SD</translation>
    </message>
    <message>
        <source>published simulator minus published experiment, 95 % CI</source>
        <translation>veröffentlichter Simulator minus veröffentlichtes Experiment, 95-%-KI</translation>
    </message>
    <message>
        <source>This file carries no seal: it is of an earlier version of the program.</source>
        <translation>Diese Datei trägt kein Siegel: sie ist von einer früheren Version des Programms.</translation>
    </message>
    <message>
        <source>This file was changed by hand after the program wrote it, so it has no number. Do not use its values as results of the program.</source>
        <translation>Diese Datei wurde von Hand geändert, nachdem das Programm sie geschrieben hatte, und hat deshalb keine Nummer. Verwenden Sie ihre Werte nicht als Ergebnisse des Programms.</translation>
    </message>
    <message>
        <source>%1 was changed after the program wrote it, so its results are not continued. Delete it or give another folder.</source>
        <translation>%1 wurde geändert, nachdem das Programm sie geschrieben hatte; ihre Ergebnisse werden nicht fortgesetzt. Löschen Sie sie, oder geben Sie einen anderen Ordner an.</translation>
    </message>
    <message>
        <source>%1 was changed by hand after the program wrote it; its insertions are not run again. Use another copy of it.</source>
        <translation>%1 wurde von Hand geändert, nachdem das Programm sie geschrieben hatte; ihre Insertionen werden nicht wiederholt. Verwenden Sie eine andere Kopie.</translation>
    </message>
    <message>
        <source>%1 carries no seal: it is of an earlier version. Delete it or give another folder.</source>
        <translation>%1 trägt kein Siegel: sie ist von einer früheren Version. Löschen Sie sie, oder geben Sie einen anderen Ordner an.</translation>
    </message>
    <message>
        <source>%1 is in use: another program works on it. Wait until it has ended.</source>
        <translation>%1 ist in Gebrauch: ein anderes Programm arbeitet daran. Warten Sie, bis es beendet ist.</translation>
    </message>
    <message>
        <source>%1 is in use: another program works on it, or it cannot be locked (%2). Wait until that program has ended.</source>
        <translation>%1 ist in Gebrauch: ein anderes Programm arbeitet daran, oder sie lässt sich nicht sperren (%2). Warten Sie, bis jenes Programm beendet ist.</translation>
    </message>
    <message>
        <source>%1 cannot be locked: %2. Check the folder&apos;s permissions and the space on the disk.</source>
        <translation>%1 lässt sich nicht sperren: %2. Prüfen Sie die Rechte des Ordners und den Platz auf der Platte.</translation>
    </message>
    <message>
        <source>%1 was changed by another program meanwhile; it is not replaced. Read it again, and make the change in it.</source>
        <translation>%1 wurde inzwischen von einem anderen Programm geändert und wird nicht ersetzt. Lesen Sie sie noch einmal, und ändern Sie sie dort.</translation>
    </message>
    <message>
        <source>%1 is not replaced: versions, plans, insertions or outcomes in it would be lost. Read it again.</source>
        <translation>%1 wird nicht ersetzt: Versionen, Pläne, Insertionen oder Ergebnisse darin gingen verloren. Lesen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 is there already; it is not replaced. Open that patient, or use another code.</source>
        <translation>%1 gibt es schon; sie wird nicht ersetzt. Öffnen Sie jenen Patienten, oder verwenden Sie einen anderen Code.</translation>
    </message>
    <message>
        <source>%1 holds notes on a patient of this code and ear whose file is missing. Rename it first.</source>
        <translation>%1 enthält Notizen zu einem Patienten mit diesem Code und Ohr, dessen Datei fehlt. Benennen Sie sie zuerst um.</translation>
    </message>
    <message>
        <source>%1 holds notes on a patient of this code and ear whose file is missing; an import does not replace it. Rename it first.</source>
        <translation>%1 enthält Notizen zu einem Patienten mit diesem Code und Ohr, dessen Datei fehlt; ein Import ersetzt sie nicht. Benennen Sie sie zuerst um.</translation>
    </message>
    <message>
        <source>%1 is of a newer program. Open it with that one.</source>
        <translation>%1 ist von einem neueren Programm. Öffnen Sie sie mit jenem.</translation>
    </message>
    <message>
        <source>%1 places the landmark %2 at two points. Keep one of them.</source>
        <translation>%1 setzt die Landmarke %2 an zwei Punkte. Behalten Sie einen davon.</translation>
    </message>
    <message>
        <source>%1 states &quot;%2&quot; twice in one object. Save the points in Slicer again.</source>
        <translation>%1 gibt „%2“ in einem Objekt zweimal an. Speichern Sie die Punkte in Slicer noch einmal.</translation>
    </message>
    <message>
        <source>%1 has landmarks of another CT series than the one that is open. Open that CT, or place the landmarks in this one.</source>
        <translation>%1 hat Landmarken einer anderen CT-Serie als der geöffneten. Öffnen Sie jenes CT, oder setzen Sie die Landmarken in diesem.</translation>
    </message>
    <message>
        <source>The copy was canceled; nothing of it was kept.</source>
        <translation>Das Kopieren wurde abgebrochen; nichts davon wurde behalten.</translation>
    </message>
    <message>
        <source>Lubricated silicone (published)</source>
        <translation>Silikon, geschmiert (veröffentlicht)</translation>
    </message>
    <message>
        <source>Tissue-like (endosteum simulant)</source>
        <translation>Gewebeähnlich (Endost-Simulans)</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>reversals</source>
        <translation>Rückzüge</translation>
    </message>
    <message>
        <source>peak force</source>
        <translation>Maximalkraft</translation>
    </message>
    <message>
        <source>smoothness</source>
        <translation>Gleichmäßigkeit</translation>
    </message>
    <message>
        <source>%1 before maximum insertion depth</source>
        <translation>%1 bis zur maximalen Insertionstiefe</translation>
    </message>
    <message>
        <source>largest difference below perception</source>
        <translation>größte Differenz unter der Wahrnehmung</translation>
    </message>
    <message>
        <source>position of the basal-turn peak</source>
        <translation>Position des Maximums der Basalwindung</translation>
    </message>
    <message>
        <source>position of the following dip</source>
        <translation>Position des folgenden Minimums</translation>
    </message>
    <message>
        <source>small early peak</source>
        <translation>kleines frühes Maximum</translation>
    </message>
    <message>
        <source>mean raw force just before the first rib</source>
        <translation>mittlere Rohkraft kurz vor dem ersten Ring</translation>
    </message>
    <message>
        <source>mean raw force at the first rib</source>
        <translation>mittlere Rohkraft am ersten Ring</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 mN</source>
        <translation>%1 mN</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>travel, mm</source>
        <translation>Vorschub, mm</translation>
    </message>
    <message>
        <source>insertion force, mN</source>
        <translation>Insertionskraft, mN</translation>
    </message>
    <message>
        <source>difference of mean insertion force, mN</source>
        <translation>Differenz der mittleren Insertionskraft, mN</translation>
    </message>
    <message>
        <source>Published forces</source>
        <translation>Veröffentlichte Kräfte</translation>
    </message>
    <message>
        <source>experiment, mean ± SD</source>
        <translation>Versuch, Mittelwert ± SD</translation>
    </message>
    <message>
        <source>published simulator, mean ± SD</source>
        <translation>veröffentlichter Simulator, Mittelwert ± SD</translation>
    </message>
    <message>
        <source>Values between points were not reported.</source>
        <translation>Werte zwischen den Punkten wurden nicht berichtet.</translation>
    </message>
    <message>
        <source>Simulated insertions and the published experiment</source>
        <translation>Simulierte Insertionen und der veröffentlichte Versuch</translation>
    </message>
    <message>
        <source>± SD between insertions</source>
        <translation>± SD zwischen Insertionen</translation>
    </message>
    <message>
        <source>mean of %1 simulated insertions</source>
        <translation>Mittelwert aus %1 simulierten Insertionen</translation>
    </message>
    <message>
        <source>perception threshold, median %1 mN</source>
        <translation>Wahrnehmungsschwelle, Median %1 mN</translation>
    </message>
    <message>
        <source>perception threshold ± %1 mN</source>
        <translation>Wahrnehmungsschwelle ± %1 mN</translation>
    </message>
    <message>
        <source>Simulator minus experiment</source>
        <translation>Simulator minus Versuch</translation>
    </message>
    <message>
        <source>All %1 insertions reached the end.</source>
        <translation>Alle %1 Insertionen erreichten das Ende.</translation>
    </message>
    <message>
        <source>The soft, conical tip (Softip) is general literature; its radius and the length of the cone are choices.</source>
        <translation>Die weiche, konische Spitze (Softip) ist allgemeine Literatur; ihr Radius und die Länge des Konus sind Wahl.</translation>
    </message>
    <message>
        <source>Estimate: taken to be the carrier of the Contour; the table of contour.toml before any calibration.</source>
        <translation>Schätzung: als Träger des Contour angenommen; Tabelle aus contour.toml vor jeder Kalibrierung.</translation>
    </message>
    <message>
        <source>The recording was not closed: it ends where the program was interrupted.</source>
        <translation>Die Aufzeichnung wurde nicht geschlossen: Sie endet, wo das Programm unterbrochen wurde.</translation>
    </message>
    <message>
        <source>The model built from the recorded scenario differs from the recorded model.</source>
        <translation>Das aus dem aufgezeichneten Szenario gebildete Modell weicht vom aufgezeichneten ab.</translation>
    </message>
    <message>
        <source>The recording contains no samples.</source>
        <translation>Die Aufzeichnung enthält keine Messpunkte.</translation>
    </message>
    <message>
        <source>%1 ticks before tick %2 were lost; nothing after them can be compared.</source>
        <translation>%1 Zeitschritte vor Zeitschritt %2 gingen verloren; danach lässt sich nichts vergleichen.</translation>
    </message>
    <message>
        <source>The cochlea is filled with air, as in a dried specimen: a patient&apos;s is filled with fluid, so check that this is the right place and the right series.</source>
        <translation>Die Cochlea enthält Luft wie ein getrocknetes Präparat; die eines Patienten ist mit Flüssigkeit gefüllt. Prüfen, ob Ort und Serie stimmen.</translation>
    </message>
    <message>
        <source>Possible left-right swap: the spiral winds as in the other ear. Check the file and the side before anything is planned.</source>
        <translation>Mögliche Seitenverwechslung: Die Spirale dreht sich wie im anderen Ohr. Prüfen Sie Datei und Seite, bevor etwas geplant wird.</translation>
    </message>
    <message>
        <source>Poor fit: the outline deviates from the images. Measure by hand if it does not lie on the wall.</source>
        <translation>Schlechte Anpassung: Der Umriss weicht von den Bildern ab. Messen Sie von Hand, wenn er nicht auf der Wand liegt.</translation>
    </message>
    <message>
        <source>The wall found in sections through the modiolus lies apart from the fitted one: check the outline in the images.</source>
        <translation>Die in Schnitten durch den Modiolus gefundene Wand weicht von der angepassten ab: Den Umriss in den Bildern prüfen.</translation>
    </message>
    <message>
        <source>Part of the cochlea lies outside the volume, or where nothing was measured: take a series that shows all of it.</source>
        <translation>Ein Teil der Cochlea liegt außerhalb des Volumens oder dort, wo nicht gemessen wurde: eine Serie verwenden, die sie ganz zeigt.</translation>
    </message>
    <message>
        <source>A landmark placed by hand lies far from the fitted cochlea, and the voxels contradict it: check that landmark in the images.</source>
        <translation>Eine von Hand gesetzte Landmarke liegt weit von der angepassten Cochlea entfernt, und die Voxel widersprechen ihr: diese Landmarke in den Bildern prüfen.</translation>
    </message>
    <message>
        <source>Along a fifth or more of the basal turn nothing distinguishes the lumen from the bone: it may be ossified; check the outline in the images.</source>
        <translation>Auf mindestens einem Fünftel der basalen Windung unterscheidet sich das Lumen nicht vom Knochen: Es könnte verknöchert sein; den Umriss in den Bildern prüfen.</translation>
    </message>
    <message>
        <source>There is metal in or beside the cochlea (an implant?): it hides the wall, so take a CT from before the implantation.</source>
        <translation>In oder neben der Cochlea ist Metall (ein Implantat?): Es verdeckt die Wand; ein CT von vor der Implantation verwenden.</translation>
    </message>
    <message>
        <source>B does not fit A, or H is beyond that of known cochleae: check the outline in the images; a malformed cochlea has no A, B and H.</source>
        <translation>B passt nicht zu A, oder H liegt außerhalb bekannter Cochleae: Den Umriss in den Bildern prüfen; für eine missgebildete Cochlea gelten A, B und H nicht.</translation>
    </message>
    <message>
        <source>The volume shows a second cochlea: choose the ear by its side, or by a point in it.</source>
        <translation>Das Volumen zeigt eine zweite Cochlea: Das Ohr durch seine Seite oder einen Punkt darin wählen.</translation>
    </message>
    <message>
        <source>A, B or H between the landmarks placed by hand differs from the fitted one by more than the errors of both: check the landmarks in the images.</source>
        <translation>A, B oder H zwischen den von Hand gesetzten Landmarken weicht stärker von der Anpassung ab als die Fehler beider: Die Landmarken in den Bildern prüfen.</translation>
    </message>
    <message>
        <source>There is metal in or beside the cochlea (an implant?): %1 cubic millimeters are brighter than %2 HU and hide its wall. Take a CT from before the implantation.</source>
        <translation>In oder neben der Cochlea ist Metall (ein Implantat?): %1 Kubikmillimeter sind heller als %2 HU und verdecken ihre Wand. Verwenden Sie ein CT von vor der Implantation.</translation>
    </message>
    <message>
        <source>%1 scout images were left out.</source>
        <translation>%1 Übersichtsaufnahmen wurden weggelassen.</translation>
    </message>
    <message>
        <source>%1 slices lie at the position of another; they are dropped if their voxels are the same, and the series is refused if not.</source>
        <translation>%1 Schichten liegen am Ort einer anderen; sie entfallen, wenn ihre Voxel gleich sind, sonst wird die Serie abgelehnt.</translation>
    </message>
    <message>
        <source>The gantry is tilted by %1 degrees; the volume is resampled to right angles.</source>
        <translation>Die Gantry ist um %1 Grad gekippt; das Volumen wird auf rechte Winkel umgerechnet.</translation>
    </message>
    <message>
        <source>The folder holds images of %1 patients; this series is of one of them. Check that it is the right one.</source>
        <translation>Der Ordner enthält Bilder von %1 Patienten; diese Serie ist von einem davon. Prüfen Sie, ob es der richtige ist.</translation>
    </message>
    <message>
        <source>None of the %1 files that the DICOMDIR names is there; the files in its folder were read instead.</source>
        <translation>Keine der %1 Dateien, die das DICOMDIR nennt, ist da; stattdessen wurden die Dateien in seinem Ordner gelesen.</translation>
    </message>
    <message>
        <source>%1 of %2 files that the DICOMDIR names are not there; slices may be missing. Copy the whole medium.</source>
        <translation>%1 von %2 Dateien, die das DICOMDIR nennt, fehlen; vielleicht fehlen Schichten. Kopieren Sie den ganzen Datenträger.</translation>
    </message>
    <message>
        <source>Its images were compressed with loss; fine edges may be gone.</source>
        <translation>Die Bilder wurden verlustbehaftet komprimiert; feine Kanten können fehlen.</translation>
    </message>
    <message>
        <source>Its images were computed from others, as reformatted planes are; original ones are sharper.</source>
        <translation>Die Bilder wurden aus anderen berechnet (reformatierte Ebenen); Originale sind schärfer.</translation>
    </message>
    <message>
        <source>Booth: FLEX24 in the mean cochlea, tissue-like friction</source>
        <translation>Messestand: FLEX24 in der mittleren Cochlea, gewebeähnliche Reibung</translation>
    </message>
    <message>
        <source>patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>ear</source>
        <translation>Ohr</translation>
    </message>
    <message>
        <source>anatomy</source>
        <translation>Anatomie</translation>
    </message>
    <message>
        <source>array</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>full depth</source>
        <translation>volle Tiefe</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>force scale</source>
        <translation>Kraftskala</translation>
    </message>
    <message>
        <source>Scripted insertion</source>
        <translation>Automatische Insertion</translation>
    </message>
    <message>
        <source>Mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>Recorded hand</source>
        <translation>Aufgezeichnete Hand</translation>
    </message>
    <message>
        <source>Surgery: FLEX28 through the round window</source>
        <translation>Operation: FLEX28 durch das runde Fenster</translation>
    </message>
    <message>
        <source>largest difference of the predicted</source>
        <translation>größter Unterschied der Vorhersagen</translation>
    </message>
    <message>
        <source>mean raw force at the basal turn</source>
        <translation>mittlere Rohkraft an der Basalwindung</translation>
    </message>
    <message>
        <source>approach tilt</source>
        <translation>Neigung des Zugangs</translation>
    </message>
    <message>
        <source>approach turn</source>
        <translation>Drehung des Zugangs</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>force limit</source>
        <translation>Kraftgrenze</translation>
    </message>
    <message>
        <source>share of A</source>
        <translation>Aufteilung von A</translation>
    </message>
    <message>
        <source>share of B</source>
        <translation>Aufteilung von B</translation>
    </message>
    <message>
        <source>section at the base</source>
        <translation>Querschnitt an der Basis</translation>
    </message>
    <message>
        <source>section in the second turn</source>
        <translation>Querschnitt in der zweiten Windung</translation>
    </message>
    <message>
        <source>dip of the basal turn</source>
        <translation>Senke der Basalwindung</translation>
    </message>
    <message>
        <source>wave of the outer wall</source>
        <translation>Welle der Außenwand</translation>
    </message>
    <message>
        <source>height without H</source>
        <translation>Höhe ohne H</translation>
    </message>
    <message>
        <source>lining</source>
        <translation>Auskleidung</translation>
    </message>
    <message>
        <source>membrane</source>
        <translation>Membran</translation>
    </message>
    <message>
        <source>The shape of the cochlea is the mean one, scaled to A, B and H; sections, course of the center line and outer wall vary along it as in few measured ears. Outline and tilt of the sections are those of the mean.</source>
        <translation>Die Form der Cochlea ist die mittlere, skaliert auf A, B und H; Querschnitte, Verlauf der Mittellinie und Außenwand schwanken entlang der Windungen wie in wenigen gemessenen Ohren. Umriss und Neigung der Querschnitte sind die mittleren.</translation>
    </message>
    <message>
        <source>The force on the partition is the sum on the basilar membrane, as former versions computed it: not the force that ruptures.</source>
        <translation>Die Kraft auf die Trennwand ist die Summe auf der Basilarmembran, wie frühere Versionen sie berechneten: nicht die Kraft, bei der sie reißt.</translation>
    </message>
    <message>
        <source>Insertions have longer steps than the scenario: their median angle differs by up to %1 degrees.</source>
        <translation>Die Insertionen haben längere Schritte als das Szenario: Ihr medianer Winkel weicht um bis zu %1 Grad ab.</translation>
    </message>
    <message>
        <source>Errors of A, B and H are independent unless the patient&apos;s file states their correlations.</source>
        <translation>Die Fehler von A, B und H sind unabhängig, wenn die Datei des Patienten keine Korrelationen nennt.</translation>
    </message>
    <message>
        <source>The strength of the cochlear partition and the surgeon&apos;s force limit rest on few publications; see sources.</source>
        <translation>Festigkeit der Trennwand und Kraftgrenze des Chirurgen beruhen auf wenigen Veröffentlichungen; siehe Quellen.</translation>
    </message>
    <message>
        <source>Ends are those of the model: a probability is not a clinical risk.</source>
        <translation>Die Ausgänge sind die des Modells: Eine Wahrscheinlichkeit ist kein klinisches Risiko.</translation>
    </message>
    <message>
        <source>Choice: forceps take the array a few millimeters in front of the opening and advance it in strokes.</source>
        <translation>Wahl: Die Pinzette fasst den Elektrodenträger wenige Millimeter vor der Öffnung und schiebt ihn in Hüben vor.</translation>
    </message>
    <message>
        <source>Choice. Relaxation of the silicone itself is not computed.</source>
        <translation>Wahl. Die Relaxation des Silikons selbst wird nicht berechnet.</translation>
    </message>
    <message>
        <source>Choice by the confidence that the array&apos;s file gives its bending stiffness: no maker publishes a stiffness or its tolerance.</source>
        <translation>Wahl nach der Verlässlichkeit, die die Datei des Elektrodenträgers seiner Biegesteifigkeit gibt: Kein Hersteller veröffentlicht eine Steifigkeit oder ihre Toleranz.</translation>
    </message>
    <message>
        <source>Choice: what the view through the facial recess leaves to correct. No source states it for insertions by hand.</source>
        <translation>Wahl: was die Sicht durch die posteriore Tympanotomie zu korrigieren lässt. Keine Quelle nennt es für Insertionen von Hand.</translation>
    </message>
    <message>
        <source>Endosteum: low end of the reported range</source>
        <translation>Endost: unteres Ende des berichteten Bereichs</translation>
    </message>
    <message>
        <source>The partition ruptures at one strength, bone and membrane alike, into a mirrored scala vestibuli. The model gives fewer translocations than clinics report.</source>
        <translation>Die cochleäre Trennwand reißt bei einer einzigen Festigkeit, Knochen und Membran gleich, in eine gespiegelte Scala vestibuli. Das Modell ergibt weniger Translokationen als klinische Berichte.</translation>
    </message>
    <message>
        <source>No friction in a living ear is known. The default, %1, is the low end of what is reported for arrays on endosteum, chosen with the depths in view that clinics report: four of five straight arrays come within %2 degrees of them, FLEXSOFT stops %3 short. With the friction of a tissue simulant straight arrays stop at %4 to %5.</source>
        <translation>Im lebenden Ohr ist keine Reibung bekannt. Die Vorgabe, %1, ist das untere Ende dessen, was für Elektrodenträger auf Endost berichtet wird; sie ist im Blick auf die Tiefen gewählt, die Kliniken berichten: Vier von fünf geraden Elektrodenträgern kommen bis auf %2 Grad heran, FLEXSOFT endet %3 davor. Mit der Reibung eines Gewebe-Simulans enden gerade Elektrodenträger bei %4 bis %5.</translation>
    </message>
    <message>
        <source>path of the organ of Corti in the plan, round window to apex</source>
        <translation>Weg des Corti-Organs in der Projektion entlang der Achse, vom runden Fenster zum Apex</translation>
    </message>
    <message>
        <source>measured in this model, defined as in Todd and Naghdy</source>
        <translation>in diesem Modell gemessen, definiert wie bei Todd und Naghdy</translation>
    </message>
    <message>
        <source>organ-of-Corti path up to that angle / whole path</source>
        <translation>Weg des Corti-Organs bis zu diesem Winkel / ganzer Weg</translation>
    </message>
    <message>
        <source>geometry of this model; real insertions end earlier</source>
        <translation>Geometrie dieses Modells; wirkliche Insertionen enden früher</translation>
    </message>
    <message>
        <source>%1 of %2 files are compressed as a whole (transfer syntax 1.2.840.10008.1.2.1.99, deflated), which this program does not read. Export the series uncompressed, or convert it with gdcmconv --raw.</source>
        <translation>%1 von %2 Dateien sind als Ganzes komprimiert (Transfersyntax 1.2.840.10008.1.2.1.99, deflated); das liest dieses Programm nicht. Exportieren Sie die Serie unkomprimiert, oder wandeln Sie sie mit gdcmconv --raw um.</translation>
    </message>
    <message>
        <source>It is a secondary capture, a picture of a screen, without a place in the patient (%1 is missing). Choose a series of original images.</source>
        <translation>Es ist eine Sekundäraufnahme, ein Bild eines Bildschirms, ohne Ort im Patienten (%1 fehlt). Wählen Sie eine Serie mit Originalbildern.</translation>
    </message>
    <message>
        <source>It is of the modality %1, a projection without a place in the patient (%2 is missing). Choose the volume that was reconstructed of it.</source>
        <translation>Die Modalität ist %1, eine Projektion ohne Ort im Patienten (%2 fehlt). Wählen Sie das daraus rekonstruierte Volumen.</translation>
    </message>
    <message>
        <source>Its images are of several modalities, %1 and %2. Export each as a series of its own.</source>
        <translation>Die Bilder haben mehrere Modalitäten, %1 und %2. Exportieren Sie jede als eigene Serie.</translation>
    </message>
    <message>
        <source>Its images differ in %1, so they may be of two patients. Export the images of each patient apart.</source>
        <translation>Die Bilder unterscheiden sich in %1, sie können also von zwei Patienten sein. Exportieren Sie die Bilder jedes Patienten für sich.</translation>
    </message>
    <message>
        <source>The slope of its gray values, RescaleSlope (0028,1053), is %1 in %2; it must be above 0. Export the series again as original images.</source>
        <translation>Die Steigung der Grauwerte, RescaleSlope (0028,1053), ist %1 in %2; sie muss über 0 liegen. Exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>PixelRepresentation (0028,0103) differs between its images: signed in %1 and unsigned in %2. Export the series again as original images.</source>
        <translation>PixelRepresentation (0028,0103) ist nicht in allen Bildern gleich: mit Vorzeichen in %1, ohne in %2. Exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>The file %1 stores %2 bits (0028,0101) of a voxel in the %3 that are allocated (0028,0100); export the series again as original images.</source>
        <translation>Die Datei %1 speichert %2 Bits (0028,0101) eines Voxels in den %3 vorgesehenen (0028,0100); exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>The file %1 holds compressed voxels and states that they are not (transfer syntax %2); export the series again as original images.</source>
        <translation>Die Datei %1 enthält komprimierte Voxel und gibt an, dass sie es nicht sind (Transfersyntax %2); exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>It is of the modality %1, not CT. Choose a CT series.</source>
        <translation>Die Modalität ist %1, nicht CT. Wählen Sie eine CT-Serie.</translation>
    </message>
    <message>
        <source>It is a scout (localizer), a projection and no slices. Choose a series of slices.</source>
        <translation>Es ist ein Scout (Localizer), eine Projektion und keine Schichten. Wählen Sie eine Serie mit Schichten.</translation>
    </message>
    <message>
        <source>Its images are in color, as of a picture or a fusion, and hold no Hounsfield units. Choose a series of original images.</source>
        <translation>Die Bilder sind farbig, wie ein Foto oder eine Fusion, und enthalten keine Hounsfield-Werte. Wählen Sie eine Serie mit Originalbildern.</translation>
    </message>
    <message>
        <source>%1 of %2 files are encrypted. Export the series again without encryption.</source>
        <translation>%1 von %2 Dateien sind verschlüsselt. Exportieren Sie die Serie ohne Verschlüsselung.</translation>
    </message>
    <message>
        <source>%1 of %2 files are cut off: they end before their voxels do. Copy the series again.</source>
        <translation>%1 von %2 Dateien sind abgeschnitten: Sie enden vor ihren Voxeln. Kopieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>%1 of %2 files hold no image. Export the series again.</source>
        <translation>%1 von %2 Dateien enthalten kein Bild. Exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>Its voxels are stored in a way this program cannot decode (transfer syntax %1). Export the series uncompressed, or convert it with gdcmconv --raw.</source>
        <translation>Die Voxel sind in einer Weise gespeichert, die dieses Programm nicht dekodieren kann (Transfersyntax %1). Exportieren Sie die Serie unkomprimiert, oder wandeln Sie sie mit gdcmconv --raw um.</translation>
    </message>
    <message>
        <source>Its slices are of several sizes, %1 x %2 and %3 x %4 voxels. Export each size as a series of its own.</source>
        <translation>Die Schichten haben verschiedene Größen, %1 x %2 und %3 x %4 Voxel. Exportieren Sie jede Größe als eigene Serie.</translation>
    </message>
    <message>
        <source>Its slices are of several reconstruction kernels, %1 and %2. Export each reconstruction as a series of its own.</source>
        <translation>Die Schichten haben verschiedene Rekonstruktionskerne, %1 und %2. Exportieren Sie jede Rekonstruktion als eigene Serie.</translation>
    </message>
    <message>
        <source>Its slices have no pixel spacing, so no length can be measured in them. Export the series again as original images.</source>
        <translation>Den Schichten fehlt der Pixelabstand, so dass sich in ihnen keine Länge messen lässt. Exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>Its slices have several pixel spacings, %1 mm and %2 mm. Export each as a series of its own.</source>
        <translation>Die Schichten haben verschiedene Pixelabstände, %1 mm und %2 mm. Exportieren Sie jeden als eigene Serie.</translation>
    </message>
    <message>
        <source>It has %1 million voxels; at most %2 million are read. Export the region of the temporal bone.</source>
        <translation>Die Serie hat %1 Millionen Voxel; höchstens %2 Millionen werden gelesen. Exportieren Sie den Bereich des Felsenbeins.</translation>
    </message>
    <message>
        <source>%1 of %2 slices have no position or orientation in the patient, so no length along the stack can be trusted. Export the series again as original images.</source>
        <translation>%1 von %2 Schichten haben keine Lage oder Ausrichtung im Patienten, so dass keine Länge entlang des Stapels verlässlich ist. Exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>%1 of %2 slices have an orientation that is not two unit vectors at right angles. Export the series again as original images.</source>
        <translation>Die Ausrichtung von %1 der %2 Schichten besteht nicht aus zwei Einheitsvektoren im rechten Winkel. Exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>%1 of %2 slices have another orientation than the first. Export each orientation as a series of its own.</source>
        <translation>%1 von %2 Schichten sind anders ausgerichtet als die erste. Exportieren Sie jede Ausrichtung als eigene Serie.</translation>
    </message>
    <message>
        <source>There is no slice. Choose another series.</source>
        <translation>Es ist keine Schicht da. Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>All %1 slices lie at one position; a volume needs them one above the other. Choose another series.</source>
        <translation>Alle %1 Schichten liegen an einer Stelle; für ein Volumen müssen sie übereinander liegen. Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>%1 images that differ lie at the position of slice %2 of %3: the series holds several phases or reconstructions. Export each as a series of its own.</source>
        <translation>%1 verschiedene Bilder liegen am Ort von Schicht %2 von %3: Die Serie enthält mehrere Phasen oder Rekonstruktionen. Exportieren Sie jede als eigene Serie.</translation>
    </message>
    <message>
        <source>%1 voxels lie beyond -32768 to 32767, which 16 bits hold. Export the series as Hounsfield units.</source>
        <translation>%1 Voxel liegen außerhalb von -32768 bis 32767, dem Bereich von 16 Bit. Exportieren Sie die Serie in Hounsfield-Werten.</translation>
    </message>
    <message>
        <source>The voxels of a file could not be decoded: it is damaged, or stored in a way this program does not know. Copy or export the series again, uncompressed if it can be.</source>
        <translation>Die Voxel einer Datei ließen sich nicht dekodieren: Sie ist beschädigt oder in einer Weise gespeichert, die dieses Programm nicht kennt. Kopieren oder exportieren Sie die Serie noch einmal, möglichst unkomprimiert.</translation>
    </message>
    <message>
        <source>The tilted gantry&apos;s volume could not be resampled to right angles. Export it reformatted without tilt.</source>
        <translation>Das Volumen der gekippten Gantry ließ sich nicht auf rechte Winkel umrechnen. Exportieren Sie es ohne Kippung reformatiert.</translation>
    </message>
    <message>
        <source>the voxel size</source>
        <translation>die Voxelgröße</translation>
    </message>
    <message>
        <source>the place of its voxels</source>
        <translation>den Ort der Voxel</translation>
    </message>
    <message>
        <source>the handedness of its axes</source>
        <translation>die Händigkeit der Achsen</translation>
    </message>
    <message>
        <source>whether it has an SForm</source>
        <translation>ob es eine SForm gibt</translation>
    </message>
    <message>
        <source>the bits of a voxel</source>
        <translation>die Bits eines Voxels</translation>
    </message>
    <message>
        <source>its gray values</source>
        <translation>die Grauwerte</translation>
    </message>
    <message>
        <source>the length of its voxels</source>
        <translation>die Länge der Voxel</translation>
    </message>
    <message>
        <source>the unit of length</source>
        <translation>die Längeneinheit</translation>
    </message>
    <message>
        <source>its dimensions in space</source>
        <translation>die Dimensionen im Raum</translation>
    </message>
    <message>
        <source>the number of its voxels</source>
        <translation>die Zahl der Voxel</translation>
    </message>
    <message>
        <source>one field</source>
        <translation>ein Feld</translation>
    </message>
    <message>
        <source>where its axes point</source>
        <translation>wohin die Achsen zeigen</translation>
    </message>
    <message>
        <source>the length of its packed voxels</source>
        <translation>die Länge der gepackten Voxel</translation>
    </message>
    <message>
        <source>the SForm</source>
        <translation>der SForm</translation>
    </message>
    <message>
        <source>the QForm</source>
        <translation>der QForm</translation>
    </message>
    <message>
        <source>the QForm of the same code</source>
        <translation>der QForm mit demselben Code</translation>
    </message>
    <message>
        <source>the QForm of another code</source>
        <translation>der QForm mit anderem Code</translation>
    </message>
    <message>
        <source>the QForm of code 1 or 2</source>
        <translation>der QForm mit Code 1 oder 2</translation>
    </message>
    <message>
        <source>the SForm of a higher code</source>
        <translation>der SForm mit höherem Code</translation>
    </message>
    <message>
        <source>the matrix</source>
        <translation>der Matrix</translation>
    </message>
    <message>
        <source>its data</source>
        <translation>den Daten</translation>
    </message>
    <message>
        <source>its sizes and number type</source>
        <translation>Größen und Zahlentyp</translation>
    </message>
    <message>
        <source>its first line</source>
        <translation>der ersten Zeile</translation>
    </message>
    <message>
        <source>a later line</source>
        <translation>einer späteren Zeile</translation>
    </message>
    <message>
        <source>axis mins and axis maxs</source>
        <translation>axis mins und axis maxs</translation>
    </message>
    <message>
        <source>old min and old max</source>
        <translation>old min und old max</translation>
    </message>
    <message>
        <source>the thickness of its slices</source>
        <translation>die Dicke der Schichten</translation>
    </message>
    <message>
        <source>the steps of space directions</source>
        <translation>den Schritten von space directions</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>thicknesses</translation>
    </message>
    <message>
        <source>its geometry</source>
        <translation>die Geometrie</translation>
    </message>
    <message>
        <source>a field</source>
        <translation>einem Feld</translation>
    </message>
    <message>
        <source>a key with a value</source>
        <translation>einem Schlüssel mit Wert</translation>
    </message>
    <message>
        <source>one of both may be wrong, so check the voxel size in the original series</source>
        <translation>eine von beiden kann falsch sein, prüfen Sie die Voxelgröße in der Originalserie</translation>
    </message>
    <message>
        <source>ElementSpacing times TransformMatrix</source>
        <translation>ElementSpacing mal TransformMatrix</translation>
    </message>
    <message>
        <source>ElementMin and ElementMax</source>
        <translation>ElementMin und ElementMax</translation>
    </message>
    <message>
        <source>export it again from the original series</source>
        <translation>exportieren Sie die Datei noch einmal aus der Originalserie</translation>
    </message>
    <message>
        <source>it is cut off or damaged, or its header was changed: copy or export it again</source>
        <translation>sie ist abgeschnitten oder beschädigt, oder ihr Kopf wurde geändert: Kopieren oder exportieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>the SForm is used, so check the sides</source>
        <translation>die SForm wird benutzt; prüfen Sie die Seiten</translation>
    </message>
    <message>
        <source>the QForm, of the scanner&apos;s space, is used, so check the sides</source>
        <translation>die QForm, im Raum des Scanners, wird benutzt; prüfen Sie die Seiten</translation>
    </message>
    <message>
        <source>the QForm is used</source>
        <translation>die QForm wird benutzt</translation>
    </message>
    <message>
        <source>they are read as stored, so check that bone is above 1000</source>
        <translation>sie werden gelesen, wie sie gespeichert sind; prüfen Sie, dass Knochen über 1000 liegt</translation>
    </message>
    <message>
        <source>The file</source>
        <translation>Die Datei</translation>
    </message>
    <message>
        <source>right-handed</source>
        <translation>rechtshändig</translation>
    </message>
    <message>
        <source>left-handed</source>
        <translation>linkshändig</translation>
    </message>
    <message>
        <source>0 (none)</source>
        <translation>0 (keine)</translation>
    </message>
    <message>
        <source>zeros or values that are no numbers</source>
        <translation>Nullen oder Werte, die keine Zahlen sind</translation>
    </message>
    <message>
        <source>as stored</source>
        <translation>wie gespeichert</translation>
    </message>
    <message>
        <source>not stated and taken as the millimeter</source>
        <translation>nicht angegeben und als Millimeter genommen</translation>
    </message>
    <message>
        <source>the meter (xyzt_units)</source>
        <translation>der Meter (xyzt_units)</translation>
    </message>
    <message>
        <source>the millimeter (xyzt_units)</source>
        <translation>der Millimeter (xyzt_units)</translation>
    </message>
    <message>
        <source>the micrometer (xyzt_units)</source>
        <translation>der Mikrometer (xyzt_units)</translation>
    </message>
    <message>
        <source>not stated (xyzt_units) and taken as the millimeter</source>
        <translation>nicht angegeben (xyzt_units) und als Millimeter genommen</translation>
    </message>
    <message>
        <source>, the smallest,</source>
        <translation>, den kleinsten,</translation>
    </message>
    <message>
        <source>, the largest,</source>
        <translation>, den größten,</translation>
    </message>
    <message>
        <source>The volume has %1 x %2 x %3 voxels; at least 2 are needed along every axis. Choose another series.</source>
        <translation>Das Volumen hat %1 x %2 x %3 Voxel; in jeder Richtung sind mindestens 2 nötig. Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>The volume holds %1 voxels where its size says %2. The file is damaged; export the series again.</source>
        <translation>Das Volumen enthält %1 Voxel, seine Größe nennt %2. Die Datei ist beschädigt; exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>The volume&apos;s orientation matrix is singular or not finite, so no length can be measured in it. Export the series again with its positions and orientation.</source>
        <translation>Die Ausrichtungsmatrix des Volumens ist singulär oder nicht endlich, so dass sich darin keine Länge messen lässt. Exportieren Sie die Serie noch einmal mit Lage und Ausrichtung.</translation>
    </message>
    <message>
        <source>No cochlea of usual shape was found: the best fit leaves %1 % of the voxels near its wall unexplained, at most %2 % is allowed. Click into the cochlea; of a malformed or ossified one A, B and H do not apply.</source>
        <translation>Es wurde keine Cochlea üblicher Form gefunden: Die beste Anpassung erklärt %1 % der Voxel nahe ihrer Wand nicht, höchstens %2 % sind erlaubt. Klicken Sie in die Cochlea; für eine missgebildete oder verknöcherte gelten A, B und H nicht.</translation>
    </message>
    <message>
        <source>No cochlea of usual shape was found: the best fit falls from the base to the middle turn, where a cochlea climbs. Click into the cochlea; of a malformed or ossified one A, B and H do not apply.</source>
        <translation>Es wurde keine Cochlea üblicher Form gefunden: Die beste Anpassung fällt von der Basis zur mittleren Windung ab, wo eine Cochlea ansteigt. Klicken Sie in die Cochlea; für eine missgebildete oder verknöcherte gelten A, B und H nicht.</translation>
    </message>
    <message>
        <source>The point given lies outside the volume. Click into the cochlea, or give none and let the volume be searched.</source>
        <translation>Der angeklickte Punkt liegt außerhalb des Volumens. Klicken Sie in die Cochlea, oder lassen Sie das Volumen ohne Punkt absuchen.</translation>
    </message>
    <message>
        <source>No bone with a hollow was found there: the volume is empty or shows no temporal bone. Choose another series, or click into the cochlea.</source>
        <translation>Dort wurde kein Knochen mit einem Hohlraum gefunden: Das Volumen ist leer oder zeigt kein Felsenbein. Wählen Sie eine andere Serie, oder klicken Sie in die Cochlea.</translation>
    </message>
    <message>
        <source>Too few voxels lie near the place given to measure a cochlea. Click into the cochlea, and take a series that shows all of it.</source>
        <translation>Nahe der angeklickten Stelle liegen zu wenige Voxel, um eine Cochlea zu messen. Klicken Sie in die Cochlea, und nehmen Sie eine Serie, die sie ganz zeigt.</translation>
    </message>
    <message>
        <source>The port %1 at %2 is taken by another program. End that program, or choose another port.</source>
        <translation>Den Port %1 auf %2 belegt ein anderes Programm. Beenden Sie es, oder wählen Sie einen anderen Port.</translation>
    </message>
    <message>
        <source>%1 is not an address of this computer. 127.0.0.1 always is; &apos;ip address&apos; lists all.</source>
        <translation>%1 ist keine Adresse dieses Rechners. 127.0.0.1 ist immer eine; „ip address“ nennt alle.</translation>
    </message>
    <message>
        <source>The image %1 has another size or lies across the others, as a scout does; it was left out.</source>
        <translation>Das Bild %1 hat eine andere Größe oder liegt quer zu den anderen wie eine Übersichtsaufnahme; es wurde weggelassen.</translation>
    </message>
    <message>
        <source>The file %1 beside its images cannot be read or ends before it names its series: a slice may be missing. Copy the series again.</source>
        <translation>Die Datei %1 neben den Bildern kann nicht gelesen werden oder endet, bevor sie ihre Serie nennt: Vielleicht fehlt eine Schicht. Kopieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>The thickness of slice %1 of %2 (%3) is %4 mm at a distance of %5 mm between the slices: what lies between them was not measured. Take a series without gaps if there is one.</source>
        <translation>Die Schicht %1 von %2 (%3) ist %4 mm dick, und der Abstand der Schichten ist %5 mm: Was dazwischen liegt, wurde nicht gemessen. Nehmen Sie eine Serie ohne Lücken, wenn es eine gibt.</translation>
    </message>
    <message>
        <source>The thickness of slice %1 of %2 (%3) is %4 mm at a distance of %5 mm between the slices: they overlap so much that one of both may be wrong. Check them before the measures are used.</source>
        <translation>Die Schicht %1 von %2 (%3) ist %4 mm dick, und der Abstand der Schichten ist %5 mm: Sie überlappen sich so sehr, dass eines von beiden falsch sein kann. Prüfen Sie beides, bevor Sie die Maße verwenden.</translation>
    </message>
    <message>
        <source>Its slices differ in %1: %2 and %3. Check that they are of one reconstruction.</source>
        <translation>Die Schichten unterscheiden sich in %1: %2 und %3. Prüfen Sie, ob sie von einer Rekonstruktion sind.</translation>
    </message>
    <message>
        <source>It states no modality; by its class (SOPClassUID) it is of the modality %1.</source>
        <translation>Die Serie gibt keine Modalität an; nach ihrer Klasse (SOPClassUID) ist sie von der Modalität %1.</translation>
    </message>
    <message>
        <source>Its gray values are not Hounsfield units: %1. Judge them only against others of the same series.</source>
        <translation>Die Grauwerte sind keine Hounsfield-Einheiten: %1. Beurteilen Sie sie nur im Vergleich mit anderen derselben Serie.</translation>
    </message>
    <message>
        <source>Slope or intercept of the gray values differ between slices: slope %1 and intercept %2 in %3, slope %4 and intercept %5 in others; check the gray values of the slices in the images.</source>
        <translation>Steigung oder Achsenabschnitt der Grauwerte unterscheiden sich zwischen den Schichten: Steigung %1 und Achsenabschnitt %2 in %3, Steigung %4 und Achsenabschnitt %5 in anderen; prüfen Sie die Grauwerte der Schichten in den Bildern.</translation>
    </message>
    <message>
        <source>the number of its frames</source>
        <translation>die Zahl der Einzelbilder</translation>
    </message>
    <message>
        <source>the highest bit of its voxels</source>
        <translation>das höchste Bit der Voxel</translation>
    </message>
    <message>
        <source>the bits of its voxels</source>
        <translation>die Bits der Voxel</translation>
    </message>
    <message>
        <source>the distance between its columns</source>
        <translation>den Abstand der Spalten</translation>
    </message>
    <message>
        <source>the distance between its rows</source>
        <translation>den Abstand der Zeilen</translation>
    </message>
    <message>
        <source>the slope of its gray values</source>
        <translation>die Steigung der Grauwerte</translation>
    </message>
    <message>
        <source>the intercept of its gray values</source>
        <translation>den Achsenabschnitt der Grauwerte</translation>
    </message>
    <message>
        <source>the ratio of a voxel&apos;s height to its width</source>
        <translation>das Verhältnis von Höhe zu Breite eines Voxels</translation>
    </message>
    <message>
        <source>the kind of its images</source>
        <translation>die Art der Bilder</translation>
    </message>
    <message>
        <source>the step</source>
        <translation>den Schichtabstand</translation>
    </message>
    <message>
        <source>the extent of its slices</source>
        <translation>die Ausdehnung der Schichten</translation>
    </message>
    <message>
        <source>the place above the first</source>
        <translation>den Ort über der ersten</translation>
    </message>
    <message>
        <source>the width of its images</source>
        <translation>die Breite der Bilder</translation>
    </message>
    <message>
        <source>the tilt of the gantry</source>
        <translation>die Neigung der Gantry</translation>
    </message>
    <message>
        <source>the number of its images</source>
        <translation>die Zahl der Bilder</translation>
    </message>
    <message>
        <source>the class of its images</source>
        <translation>die Klasse der Bilder</translation>
    </message>
    <message>
        <source>where its rows and columns point</source>
        <translation>die Richtung ihrer Zeilen und Spalten</translation>
    </message>
    <message>
        <source>the place in its order</source>
        <translation>den Platz in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>the side of the ear</source>
        <translation>die Seite des Ohrs</translation>
    </message>
    <message>
        <source>the smallest gray value</source>
        <translation>den kleinsten Grauwert</translation>
    </message>
    <message>
        <source>the largest gray value</source>
        <translation>den größten Grauwert</translation>
    </message>
    <message>
        <source>the compressed images that PixelData holds</source>
        <translation>den komprimierten Bildern in PixelData</translation>
    </message>
    <message>
        <source>the offset table of PixelData</source>
        <translation>der Tabelle der Anfänge in PixelData</translation>
    </message>
    <message>
        <source>rows, columns, bits and frames</source>
        <translation>Zeilen, Spalten, Bits und Einzelbildern</translation>
    </message>
    <message>
        <source>the voxels themselves, which need more</source>
        <translation>den Voxeln selbst, die mehr brauchen</translation>
    </message>
    <message>
        <source>the functional groups</source>
        <translation>den Functional Groups</translation>
    </message>
    <message>
        <source>the entries of ModalityLUTSequence (0028,3000)</source>
        <translation>den Einträgen der ModalityLUTSequence (0028,3000)</translation>
    </message>
    <message>
        <source>PixelSpacing (0028,0030) outside of them</source>
        <translation>PixelSpacing (0028,0030) außerhalb</translation>
    </message>
    <message>
        <source>RescaleSlope (0028,1053) outside of them</source>
        <translation>RescaleSlope (0028,1053) außerhalb</translation>
    </message>
    <message>
        <source>RescaleIntercept (0028,1052) outside of them</source>
        <translation>RescaleIntercept (0028,1052) außerhalb</translation>
    </message>
    <message>
        <source>BitsStored (0028,0101) less one</source>
        <translation>BitsStored (0028,0101) minus eins</translation>
    </message>
    <message>
        <source>their positions</source>
        <translation>ihren Positionen</translation>
    </message>
    <message>
        <source>its position</source>
        <translation>ihrer Position</translation>
    </message>
    <message>
        <source>columns and PixelSpacing (0028,0030)</source>
        <translation>Spalten und PixelSpacing (0028,0030)</translation>
    </message>
    <message>
        <source>the slices&apos; positions</source>
        <translation>den Positionen der Schichten</translation>
    </message>
    <message>
        <source>the files that are there</source>
        <translation>den vorhandenen Dateien</translation>
    </message>
    <message>
        <source>its voxels</source>
        <translation>den Voxeln</translation>
    </message>
    <message>
        <source>export the series again as original images</source>
        <translation>exportieren Sie die Serie noch einmal als Originalbilder</translation>
    </message>
    <message>
        <source>check which of them is right before the measures are used</source>
        <translation>prüfen Sie, was davon stimmt, bevor Sie die Maße verwenden</translation>
    </message>
    <message>
        <source>check that the images were cropped and not scaled</source>
        <translation>prüfen Sie, ob die Bilder beschnitten und nicht skaliert wurden</translation>
    </message>
    <message>
        <source>check that the whole series was exported</source>
        <translation>prüfen Sie, ob die ganze Serie exportiert wurde</translation>
    </message>
    <message>
        <source>The series</source>
        <translation>Die Serie</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>it is a secondary capture</source>
        <translation>sie ist ein Secondary Capture</translation>
    </message>
    <message>
        <source>it is of a flat panel</source>
        <translation>sie ist von einem Flachdetektor</translation>
    </message>
    <message>
        <source>it is of a cone-beam scanner</source>
        <translation>sie ist von einem DVT-Gerät</translation>
    </message>
    <message>
        <source>The files of the CT contradict themselves, or something of them is missing: read the warnings about the series before using the measures.</source>
        <translation>Die Dateien des CT widersprechen sich, oder etwas davon fehlt: Lesen Sie die Warnungen zur Serie, bevor Sie die Maße verwenden.</translation>
    </message>
    <message>
        <source>Slices %1 and %2 of %3 have one number (SOPInstanceUID) at different places, so one of both may be of another series. Export the series again as original images.</source>
        <translation>Die Schichten %1 und %2 von %3 haben an verschiedenen Orten dieselbe Nummer (SOPInstanceUID); eine von beiden kann aus einer anderen Serie sein. Exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>Slices %1 and %2 of %3 hold the same voxels at different places, so one of both may be a copy of the other. Export the series again as original images.</source>
        <translation>Die Schichten %1 und %2 von %3 haben an verschiedenen Orten dieselben Voxel; eine von beiden kann eine Kopie der anderen sein. Exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source> of slice %1 of %2 (%3)</source>
        <translation> der Schicht %1 von %2 (%3)</translation>
    </message>
    <message>
        <source>The measures of %1 were changed by hand after the program wrote them. Do not use them as measured in a CT.</source>
        <translation>Die Maße von %1 wurden von Hand geändert, nachdem das Programm sie geschrieben hatte. Verwenden Sie sie nicht als in einem CT gemessen.</translation>
    </message>
    <message>
        <source>The measures of %1 carry no seal: their file is of an earlier version or of another program.</source>
        <translation>Die Maße von %1 tragen kein Siegel: ihre Datei ist von einer früheren Version oder von einem anderen Programm.</translation>
    </message>
    <message>
        <source>%1 would be larger than 4 MiB. Shorten the notes or remove scans.</source>
        <translation>%1 würde größer als 4 MiB. Kürzen Sie die Notizen, oder entfernen Sie Aufnahmen.</translation>
    </message>
    <message>
        <source>%1 is empty: the program that began it ended before it wrote anything. Delete it.</source>
        <translation>%1 ist leer: Das Programm, das die Datei angelegt hat, endete, bevor es etwas schrieb. Löschen Sie sie.</translation>
    </message>
    <message>
        <source>%1 is not a recording; an exported patient has nothing else there. Remove it.</source>
        <translation>%1 ist keine Aufzeichnung; ein exportierter Patient hat dort nichts anderes. Entfernen Sie die Datei.</translation>
    </message>
    <message>
        <source>%1 cannot be imported: %2</source>
        <translation>%1 kann nicht importiert werden: %2</translation>
    </message>
    <message>
        <source>%1 holds more than 10000 recordings. Remove some.</source>
        <translation>%1 enthält mehr als 10000 Aufzeichnungen. Entfernen Sie einige.</translation>
    </message>
    <message>
        <source>A record keeps at most 256 versions and 10000 plans, insertions and outcomes.</source>
        <translation>Eine Akte enthält höchstens 256 Fassungen und je 10000 Pläne, Insertionen und Ergebnisse.</translation>
    </message>
    <message>
        <source>Notes have %1 characters; at most 4000 are kept. Shorten them.</source>
        <translation>Die Notizen haben %1 Zeichen; höchstens 4000 werden gespeichert. Kürzen Sie sie.</translation>
    </message>
    <message>
        <source>There are %1 tags; at most 16 are kept. Remove some.</source>
        <translation>Es sind %1 Schlagwörter; höchstens 16 werden gespeichert. Entfernen Sie einige.</translation>
    </message>
    <message>
        <source>There are %1 scans; at most 64 are kept. Remove some.</source>
        <translation>Es sind %1 Aufnahmen; höchstens 64 werden gespeichert. Entfernen Sie einige.</translation>
    </message>
    <message>
        <source>The tag &quot;%1&quot; is not possible: it has 1 to 24 characters and no comma. Change it.</source>
        <translation>Das Schlagwort „%1“ ist nicht möglich: es hat 1 bis 24 Zeichen und kein Komma. Ändern Sie es.</translation>
    </message>
    <message>
        <source>The tag &quot;%1&quot; stands twice. Remove one.</source>
        <translation>Das Schlagwort „%1“ steht zweimal. Entfernen Sie eines.</translation>
    </message>
    <message>
        <source>%1 The file is not replaced; move it away, or open it with a newer version.</source>
        <translation>%1 Die Datei wird nicht ersetzt; verschieben Sie sie, oder öffnen Sie sie mit einer neueren Version.</translation>
    </message>
    <message>
        <source>%1 exists. Give the name of a new folder.</source>
        <translation>%1 ist schon da. Geben Sie den Namen eines neuen Ordners an.</translation>
    </message>
    <message>
        <source>%1 exists; an import replaces no recording. Rename it first.</source>
        <translation>%1 ist schon da; ein Import ersetzt keine Aufzeichnung. Benennen Sie sie zuerst um.</translation>
    </message>
    <message>
        <source>%1 is not the record of a patient: it needs format, tags, notes and archived. Restore it from a backup, or remove it.</source>
        <translation>%1 ist keine Akte eines Patienten: sie braucht format, tags, notes und archived. Stellen Sie sie aus einer Sicherung wieder her, oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>%1 cannot be created: %2. Check the folder&apos;s permissions and the space on the disk.</source>
        <translation>%1 kann nicht angelegt werden: %2. Prüfen Sie die Rechte des Ordners und den Platz auf dem Datenträger.</translation>
    </message>
    <message>
        <source>%1 cannot be created: its file system has no hard links. Give a folder on another disk.</source>
        <translation>%1 kann nicht angelegt werden: das Dateisystem hat keine harten Verweise. Geben Sie einen Ordner auf einem anderen Datenträger an.</translation>
    </message>
    <message>
        <source>%1 was begun by another build of the program (%2; this is %3). Delete it or give another folder.</source>
        <translation>%1 wurde von einem anderen Stand des Programms begonnen (%2; dies ist %3). Löschen Sie sie, oder geben Sie einen anderen Ordner an.</translation>
    </message>
    <message>
        <source>%1 is for other insertions. Delete it or give another folder.</source>
        <translation>%1 ist für andere Insertionen. Löschen Sie sie, oder geben Sie einen anderen Ordner an.</translation>
    </message>
    <message>
        <source>%1 takes no more %2: %3. Those before are kept; make space and run it again.</source>
        <translation>%1 nimmt keine weiteren Ergebnisse an (%2): %3. Die früheren sind erhalten; machen Sie Platz, und starten Sie erneut.</translation>
    </message>
    <message>
        <source>%1 has %2 insertions, not %3 of each of %4 arrays. Make the plan again.</source>
        <translation>%1 hat %2 Insertionen, nicht %3 von jedem von %4 Elektrodenträgern. Erstellen Sie den Plan neu.</translation>
    </message>
    <message>
        <source>The plan.json beside %1 is of another plan. Make the plan again.</source>
        <translation>Die plan.json neben %1 ist von einem anderen Plan. Erstellen Sie den Plan neu.</translation>
    </message>
    <message>
        <source>%1 is not a plan: %2. Give the folder that &apos;perilymph-cli plan&apos; wrote.</source>
        <translation>%1 ist kein Plan: %2. Geben Sie den Ordner an, den „perilymph-cli plan“ geschrieben hat.</translation>
    </message>
    <message>
        <source>%1 holds no plan.json: the plan was not finished. The same &apos;perilymph-cli plan&apos; continues it.</source>
        <translation>%1 enthält keine plan.json: der Plan wurde nicht beendet. Derselbe Aufruf von „perilymph-cli plan“ setzt ihn fort.</translation>
    </message>
    <message>
        <source>%1 has no insertions yet. Run &apos;perilymph-cli study run&apos; or merge its shards first.</source>
        <translation>%1 hat noch keine Insertionen. Starten Sie „perilymph-cli study run“, oder fügen Sie zuerst die Teile zusammen.</translation>
    </message>
    <message>
        <source>%1 has %2 insertions; at most %3 can be shown. Open one of its shards, or query it with SQL.</source>
        <translation>%1 hat %2 Insertionen; höchstens %3 können gezeigt werden. Öffnen Sie einen der Teile, oder fragen Sie die Datei mit SQL ab.</translation>
    </message>
    <message>
        <source>A plan of %1 simulations is too long. Choose %2 to %3.</source>
        <translation>Ein Plan aus %1 Simulationen ist zu lang. Wählen Sie %2 bis %3.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Check the folder&apos;s permissions and the space on the disk.</source>
        <translation>%1 kann nicht geschrieben werden: %2. Prüfen Sie die Rechte des Ordners und den Platz auf der Platte.</translation>
    </message>
    <message>
        <source>No device was chosen. Press H and choose one.</source>
        <translation>Es wurde kein Gerät gewählt. Drücken Sie H, und wählen Sie eines.</translation>
    </message>
    <message>
        <source>No insertion is prepared. Press Reset.</source>
        <translation>Es ist keine Insertion vorbereitet. Drücken Sie „Zurücksetzen“.</translation>
    </message>
    <message>
        <source>%1 cannot be created: %2. Check the permissions of its folder and the space on the disk.</source>
        <translation>%1 kann nicht angelegt werden: %2. Prüfen Sie die Rechte des Ordners und den Platz auf der Platte.</translation>
    </message>
    <message>
        <source>Stopped while reading %1.</source>
        <translation>Beim Lesen von %1 angehalten.</translation>
    </message>
    <message>
        <source>%1 contains no samples. Record the insertion to another file.</source>
        <translation>%1 enthält keine Messwerte. Zeichnen Sie die Insertion in eine andere Datei auf.</translation>
    </message>
    <message>
        <source>Canceled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Stopped; nothing was kept.</source>
        <translation>Angehalten; nichts wurde behalten.</translation>
    </message>
    <message>
        <source>The reference &apos;surgeons&apos; has no [[value]] of the quantity &apos;force felt, median&apos;.</source>
        <translation>Die Referenz &apos;surgeons&apos; hat kein [[value]] der Größe &apos;force felt, median&apos;.</translation>
    </message>
    <message>
        <source>%1 % of the insertion at 0.1–2.0 mm/s</source>
        <translation>%1 % der Insertion bei 0,1–2,0 mm/s</translation>
    </message>
    <message>
        <source>robotic insertion 0.1–1.0 mm/s (iotaSOFT); manual insertion in cadaver heads 0.66 ± 0.31 mm/s; phantom study 0.1–2.0 mm/s (Froehlich et al. 2024)</source>
        <translation>robotische Insertion 0,1–1,0 mm/s (iotaSOFT); manuelle Insertion an Leichenköpfen 0,66 ± 0,31 mm/s; Phantomstudie 0,1–2,0 mm/s (Froehlich et al. 2024)</translation>
    </message>
    <message>
        <source>Kesler et al. 2017: 18.6 reversals in manual insertions at a target of 15 mm/min</source>
        <translation>Kesler et al. 2017: 18,6 Rückzüge bei manuellen Insertionen mit Zielgeschwindigkeit 15 mm/min</translation>
    </message>
    <message>
        <source>%1 % of the time at rest (below 0.1 mm/s)</source>
        <translation>%1 % der Zeit in Ruhe (unter 0,1 mm/s)</translation>
    </message>
    <message>
        <source>Kesler et al. 2017: manual insertions at a target of 15 mm/min paused 15.7 % of the time</source>
        <translation>Kesler et al. 2017: manuelle Insertionen mit Zielgeschwindigkeit 15 mm/min pausierten 15,7 % der Zeit</translation>
    </message>
    <message>
        <source>The insertion was stopped before its end. Run it again.</source>
        <translation>Die Insertion wurde vor ihrem Ende angehalten. Starten Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>The tip did not enter the opening: %1. Aim at the opening (approach_tilt_deg, approach_turn_deg), or start deeper inside (start_inside_mm).</source>
        <translation>Die Spitze ist nicht in die Öffnung gelangt: %1. Zielen Sie auf die Öffnung (approach_tilt_deg, approach_turn_deg), oder beginnen Sie weiter innen (start_inside_mm).</translation>
    </message>
    <message>
        <source>turn angle of the likeliest half-diameters with these A and B / 360 deg</source>
        <translation>Windungswinkel der wahrscheinlichsten halben Durchmesser mit diesen A und B / 360°</translation>
    </message>
    <message>
        <source>Pietsch et al. 2017, Sci Rep, n = 138; constants seen in public code</source>
        <translation>Pietsch et al. 2017, Sci Rep, n = 138; Konstanten aus öffentlichem Code</translation>
    </message>
    <message>
        <source>The reference &apos;%1&apos; lacks a point with feature = &quot;peak&quot; and its deviation; a calibration fits this one.</source>
        <translation>Der Referenz &apos;%1&apos; fehlt ein Punkt mit feature = &quot;peak&quot; und seiner Abweichung; eine Kalibrierung passt diesen an.</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>numbers %1 and %2 more</source>
        <translation>Nummern %1 und %2 weitere</translation>
    </message>
    <message>
        <source>numbers %1 and %2</source>
        <translation>Nummern %1 und %2</translation>
    </message>
    <message>
        <source>%1 of %2 insertions reached the end</source>
        <translation>%1 von %2 Insertionen erreichten das Ende</translation>
    </message>
    <message>
        <source>Stopped before insertion %1.</source>
        <translation>Vor Insertion %1 angehalten.</translation>
    </message>
    <message>
        <source>Insertion %1 gave too few samples for its spline. Raise knot_spacing_mm or lower the speed.</source>
        <translation>Insertion %1 ergab zu wenige Messwerte für ihren Spline. Erhöhen Sie knot_spacing_mm, oder verringern Sie die Geschwindigkeit.</translation>
    </message>
    <message>
        <source>A validation of %1 insertions has no spread; ask for at least 2.</source>
        <translation>Eine Validierung mit %1 Insertionen hat keine Streuung; verlangen Sie mindestens 2.</translation>
    </message>
    <message>
        <source>%1 A mean needs at least 2 of them. Ask for more runs, or name a scenario whose insertions reach the end.%2</source>
        <translation>%1 Ein Mittelwert braucht mindestens 2 davon. Verlangen Sie mehr Läufe, oder nennen Sie ein Szenario, dessen Insertionen das Ende erreichen.%2</translation>
    </message>
    <message>
        <source>Todd and Naghdy: Nucleus 24 Contour, synthetic scala tympani, soap, 2.0 mm/s.</source>
        <translation>Todd und Naghdy: Nucleus 24 Contour, synthetische Scala tympani, Seife, 2,0 mm/s.</translation>
    </message>
    <message>
        <source>Simulated insertions and the published %1</source>
        <translation>Simulierte Insertionen und Veröffentlichung: %1</translation>
    </message>
    <message>
        <source>95 % confidence interval of the mean</source>
        <translation>95-%-Konfidenzintervall des Mittelwerts</translation>
    </message>
    <message>
        <source>Seed %1; least-squares spline through each insertion, resampled every 0.1 mm.</source>
        <translation>Startwert %1; Ausgleichsspline durch jede Insertion, neu abgetastet alle 0,1 mm.</translation>
    </message>
    <message>
        <source>Calibrated insertions: fitted and other forces</source>
        <translation>Kalibrierte Insertionen: angepasste und andere Kräfte</translation>
    </message>
    <message>
        <source>experiment, mean ± SD, used for calibration</source>
        <translation>Versuch, Mittelwert ± SD, zur Kalibrierung benutzt</translation>
    </message>
    <message>
        <source>experiment, mean ± SD, not used</source>
        <translation>Versuch, Mittelwert ± SD, nicht benutzt</translation>
    </message>
    <message>
        <source>Stiffness scale %1 ± %2.</source>
        <translation>Skala der Steifigkeit %1 ± %2.</translation>
    </message>
    <message>
        <source>this simulator, 95 % confidence interval</source>
        <translation>dieser Simulator, 95-%-Konfidenzintervall</translation>
    </message>
    <message>
        <source>published simulator, 95 % confidence interval where reported (sign corrected)</source>
        <translation>veröffentlichter Simulator, 95-%-Konfidenzintervall, wo berichtet (Vorzeichen berichtigt)</translation>
    </message>
    <message>
        <source>Shown only where the experiment was reported; its means are from about 11 insertions.</source>
        <translation>Nur gezeigt, wo der Versuch berichtet ist; seine Mittelwerte stammen aus etwa 11 Insertionen.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>Maximum der Basalwindung</translation>
    </message>
    <message>
        <source>dip</source>
        <translation>Minimum danach</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>standard deviation at %1, %2</source>
        <translation>Standardabweichung bei %1, %2</translation>
    </message>
    <message>
        <source>mean force at %1, %2</source>
        <translation>mittlere Kraft bei %1, %2</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>abgeleitet</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>p of the predicted forces</source>
        <translation>p der vorhergesagten Kräfte</translation>
    </message>
    <message>
        <source>%1 (chi-square %2)</source>
        <translation>%1 (Chi-Quadrat %2)</translation>
    </message>
    <message>
        <source>at least 0.05</source>
        <translation>mindestens 0,05</translation>
    </message>
    <message>
        <source>between 3 and 7 mm</source>
        <translation>zwischen 3 und 7 mm</translation>
    </message>
    <message>
        <source>The surface has %1 triangles; a scala tympani needs at least %2. Export the segmentation as triangles.</source>
        <translation>Die Oberfläche hat %1 Dreiecke; eine Scala tympani braucht mindestens %2. Exportieren Sie die Segmentierung als Dreiecke.</translation>
    </message>
    <message>
        <source>A triangle of the surface names the corner %1, but there are %2. Export the surface again.</source>
        <translation>Ein Dreieck der Oberfläche nennt die Ecke %1, es gibt aber %2. Exportieren Sie die Oberfläche noch einmal.</translation>
    </message>
    <message>
        <source>A corner of the surface is not a finite number. Export the surface again.</source>
        <translation>Eine Ecke der Oberfläche ist keine endliche Zahl. Exportieren Sie die Oberfläche noch einmal.</translation>
    </message>
    <message>
        <source>The surface is %1 mm long; a scala tympani is between %2 and %3 mm. Surfaces are read in millimeters; export it so.</source>
        <translation>Die Oberfläche ist %1 mm lang; eine Scala tympani hat %2 bis %3 mm. Oberflächen werden in Millimetern gelesen; exportieren Sie sie so.</translation>
    </message>
    <message>
        <source>At %1 of %2 edges of the surface more than two triangles meet; it must be the one wall of the scala. Repair it in the segmentation program.</source>
        <translation>An %1 von %2 Kanten der Oberfläche treffen sich mehr als zwei Dreiecke; sie muss die eine Wand der Scala sein. Reparieren Sie sie im Segmentierungsprogramm.</translation>
    </message>
    <message>
        <source>The surface has %1 separate pieces; it must be one. Keep the scala tympani alone.</source>
        <translation>Die Oberfläche hat %1 getrennte Teile; es muss eines sein. Behalten Sie nur die Scala tympani.</translation>
    </message>
    <message>
        <source>The surface encloses %1 mm3; a scala tympani holds 23 to 50 mm3, and %2 to %3 are read. Keep the scala tympani alone, in millimeters.</source>
        <translation>Die Oberfläche umschließt %1 mm³; eine Scala tympani fasst 23 bis 50 mm³, gelesen werden %2 bis %3. Behalten Sie nur die Scala tympani, in Millimetern.</translation>
    </message>
    <message>
        <source>The surface has a hole at (%1, %2, %3) mm, %4 mm from the basal end of its duct, where only the round window may be open. Close it in the segmentation program.</source>
        <translation>Die Oberfläche hat ein Loch bei (%1, %2, %3) mm, %4 mm vom basalen Ende ihres Gangs, wo nur das runde Fenster offen sein darf. Schließen Sie es im Segmentierungsprogramm.</translation>
    </message>
    <message>
        <source>The surface does not wind about an axis as a scala tympani does. Keep the scala tympani alone, without vestibule and scala vestibuli.</source>
        <translation>Die Oberfläche windet sich nicht um eine Achse, wie es eine Scala tympani tut. Behalten Sie nur die Scala tympani, ohne Vestibulum und Scala vestibuli.</translation>
    </message>
    <message>
        <source>The duct winds %1 turns about its axis; at least %2 are needed to measure it. Segment the scala tympani farther toward the apex.</source>
        <translation>Der Gang windet sich %1-mal um seine Achse; mindestens %2 Windungen sind nötig, um ihn zu messen. Segmentieren Sie die Scala tympani weiter zum Apex hin.</translation>
    </message>
    <message>
        <source>The surface is torn at %1: a corner lies %2 mm from the others of its rim. Repair it there in the segmentation program, or export it again.</source>
        <translation>Die Oberfläche ist bei %1 gerissen: Eine Ecke liegt %2 mm neben den anderen ihres Rands. Reparieren Sie sie dort im Segmentierungsprogramm, oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>The surface has more than one opening: rims of %1 mm at %2 and %3 mm at %4. Only the round window may be open; close the other.</source>
        <translation>Die Oberfläche hat mehr als eine Öffnung: Ränder von %1 mm bei %2 und %3 mm bei %4. Nur das runde Fenster darf offen sein; schließen Sie die andere.</translation>
    </message>
    <message>
        <source>The surface is torn at %1: its longest rim is a slit of %2 mm, not the opening of a scala tympani at the round window. Repair it there in the segmentation program, or export it again.</source>
        <translation>Die Oberfläche ist bei %1 gerissen: Ihr längster Rand ist ein Schlitz von %2 mm, nicht die Öffnung einer Scala tympani am runden Fenster. Reparieren Sie sie dort im Segmentierungsprogramm, oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>The surface has a hole at %1 with a rim of %2 mm in the side of its wall, not across the duct as the opening at the round window. Close it in the segmentation program.</source>
        <translation>Die Oberfläche hat bei %1 ein Loch mit einem Rand von %2 mm in der Seite ihrer Wand, nicht quer zum Gang wie die Öffnung am runden Fenster. Schließen Sie es im Segmentierungsprogramm.</translation>
    </message>
    <message>
        <source>%1 ends in &apos;%2&apos;; a surface is written as .stl, .ply, .obj, .wrl or .vtp. Choose one of these.</source>
        <translation>%1 endet auf &apos;%2&apos;; eine Oberfläche wird als .stl, .ply, .obj, .wrl oder .vtp geschrieben. Wählen Sie eines davon.</translation>
    </message>
    <message>
        <source>%1 (%2) is %3 mm; it must be between %4 and %5 mm.</source>
        <translation>%1 (%2) ist %3 mm; erlaubt sind %4 bis %5 mm.</translation>
    </message>
    <message>
        <source>%1 is %2; it must be between %3 and %4 mm. Measure again.</source>
        <translation>%1 ist %2; erlaubt sind %3 bis %4 mm. Messen Sie noch einmal.</translation>
    </message>
    <message>
        <source>A (a_mm)</source>
        <translation>A (a_mm)</translation>
    </message>
    <message>
        <source>B (b_mm)</source>
        <translation>B (b_mm)</translation>
    </message>
    <message>
        <source>The height H</source>
        <translation>Die Höhe H</translation>
    </message>
    <message>
        <source>The standard deviation of A</source>
        <translation>Die Standardabweichung von A</translation>
    </message>
    <message>
        <source>The standard deviation of B</source>
        <translation>Die Standardabweichung von B</translation>
    </message>
    <message>
        <source>The standard deviation of H</source>
        <translation>Die Standardabweichung von H</translation>
    </message>
    <message>
        <source>The correlation of two errors (%1) is %2; it must be between -1 and 1.</source>
        <translation>Die Korrelation zweier Fehler (%1) ist %2; sie muss zwischen -1 und 1 liegen.</translation>
    </message>
    <message>
        <source>The correlations of the errors of A, B and H (ab_correlation, ah_correlation, bh_correlation) contradict each other: no three errors have them. Check them.</source>
        <translation>Die Korrelationen der Fehler von A, B und H (ab_correlation, ah_correlation, bh_correlation) widersprechen sich: Keine drei Fehler haben sie. Prüfen Sie sie.</translation>
    </message>
    <message>
        <source>The length of the scala tympani</source>
        <translation>Die Länge der Scala tympani</translation>
    </message>
    <message>
        <source>The width of its section at the round window</source>
        <translation>Die Breite ihres Querschnitts am runden Fenster</translation>
    </message>
    <message>
        <source>The height of its section at the round window</source>
        <translation>Die Höhe ihres Querschnitts am runden Fenster</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be a patient code; use 1 to %2 letters A to Z, digits and hyphens, such as P-017, and no name.</source>
        <translation>&apos;%1&apos; kann kein Patientencode sein; verwenden Sie 1 bis %2 Buchstaben A bis Z, Ziffern und Bindestriche, etwa P-017, und keinen Namen.</translation>
    </message>
    <message>
        <source>The cochlea drawn with seed %1 is out of limits: %2 Use another seed.</source>
        <translation>Die mit Startwert %1 simulierte Cochlea liegt außerhalb der Grenzen: %2 Nehmen Sie einen anderen Startwert.</translation>
    </message>
    <message>
        <source>%1 is %2. Check the measurement.</source>
        <translation>%1 ist %2. Prüfen Sie die Messung.</translation>
    </message>
    <message>
        <source>A and B do not match: with A %1 mm, B is usually %2 mm (SD %3, Pietsch et al. 2017), not %4 mm. Check both measurements.</source>
        <translation>A und B passen nicht zusammen: Bei A %1 mm ist B gewöhnlich %2 mm (SD %3, Pietsch et al. 2017), nicht %4 mm. Prüfen Sie beide Messungen.</translation>
    </message>
    <message>
        <source>H is %1 mm; cochleae have %2 to %3 mm (Medan; Erixon 2009). Check the measurement.</source>
        <translation>H ist %1 mm; Cochleae haben %2 bis %3 mm (Medan; Erixon 2009). Prüfen Sie die Messung.</translation>
    </message>
    <message>
        <source>The cochlea of %1 cannot be built: %2</source>
        <translation>Die Cochlea von %1 kann nicht aufgebaut werden: %2</translation>
    </message>
    <message>
        <source>%1: there are %2 sections; at least 8 over a full turn are needed. Install the program again.</source>
        <translation>%1: Es gibt %2 Querschnitte; mindestens 8 über eine volle Windung sind nötig. Installieren Sie das Programm neu.</translation>
    </message>
    <message>
        <source>%1: imaginary_mm of section %2 sets it more than 0.16 mm above or below its neighbors: the file is damaged. Install the program again.</source>
        <translation>%1: imaginary_mm des Querschnitts %2 legt ihn mehr als 0,16 mm über oder unter seine Nachbarn: Die Datei ist beschädigt. Installieren Sie das Programm neu.</translation>
    </message>
    <message>
        <source>The port %1 at %2 cannot be listened at: %3.</source>
        <translation>Am Port %1 bei %2 kann nicht gelauscht werden: %3.</translation>
    </message>
    <message>
        <source>The port &apos;%1&apos; in &apos;%2&apos; is none to listen at; it must be a number from 1024 to 65535, like 18944.</source>
        <translation>Der Port &apos;%1&apos; in &apos;%2&apos; geht nicht; er muss eine Zahl von 1024 bis 65535 sein, etwa 18944.</translation>
    </message>
    <message>
        <source>The address &apos;%1&apos; in &apos;%2&apos; is not numeric; use one of this machine, like 127.0.0.1 or [::1].</source>
        <translation>Die Adresse &apos;%1&apos; in &apos;%2&apos; ist keine Zahlenadresse; nehmen Sie eine dieses Rechners, etwa 127.0.0.1 oder [::1].</translation>
    </message>
    <message>
        <source>%1 has no [[point]]; a curve needs at least one.</source>
        <translation>%1 hat kein [[point]]; eine Kurve braucht mindestens eines.</translation>
    </message>
    <message>
        <source>The point lies outside the volume. Choose a point inside the scan, in LPS millimeters.</source>
        <translation>Der Punkt liegt außerhalb des Volumens. Wählen Sie einen Punkt im Scan, in LPS-Millimetern.</translation>
    </message>
    <message>
        <source>A voxel is longer than 0.65 mm, the coarsest the measurement was tried with: take a finer series if there is one, or trust the measures less than their error bars say.</source>
        <translation>Ein Voxel ist länger als 0,65 mm; gröber wurde die Messung nicht erprobt. Feinere Serie verwenden, falls vorhanden, oder den Maßen weniger trauen, als ihre Fehlerangaben sagen.</translation>
    </message>
    <message>
        <source>A or B lies more than two standard deviations from the mean of 138 cochleae: check the outline in the images before using the measures.</source>
        <translation>A oder B liegt mehr als zwei Standardabweichungen vom Mittelwert aus 138 Cochleae entfernt: Vor Verwendung der Maße den Umriss in den Bildern prüfen.</translation>
    </message>
    <message>
        <source>No round window was found, so 0 degrees follows from the spiral alone: mark the round window&apos;s center.</source>
        <translation>Kein rundes Fenster gefunden; 0 Grad folgt allein aus der Spirale. Die Mitte des runden Fensters markieren.</translation>
    </message>
    <message>
        <source>Fewer than 2.15 turns of the lumen were seen: the cochlea is malformed, or its upper turns are filled with bone. No duct length is given, because its formula assumes 2.5 turns.</source>
        <translation>Weniger als 2,15 Windungen des Lumens wurden gesehen: Die Cochlea ist missgebildet, oder ihre oberen Windungen sind mit Knochen gefüllt. Eine Ganglänge wird nicht angegeben, weil ihre Formel 2,5 Windungen annimmt.</translation>
    </message>
    <message>
        <source>No modiolus was seen within the middle turn: middle and apical turn may be one cavity (incomplete partition). No duct length is given, because its formula assumes 2.5 turns, and H is that of the cavity.</source>
        <translation>In der mittleren Windung wurde kein Modiolus gesehen: Mittlere und apikale Windung könnten ein Hohlraum sein (inkomplette Partition). Eine Ganglänge wird nicht angegeben, weil ihre Formel 2,5 Windungen annimmt, und H ist das Maß des Hohlraums.</translation>
    </message>
    <message>
        <source>The best fit has A %1 mm and B %2 mm; of 138 cochleae A was %3 mm to %4 mm and B %5 mm to %6 mm at four standard deviations. Click into the cochlea; of a malformed or ossified one A, B and H do not apply.</source>
        <translation>Die beste Anpassung hat A %1 mm und B %2 mm; bei 138 Cochleae war A %3 mm bis %4 mm und B %5 mm bis %6 mm innerhalb von vier Standardabweichungen. Klicken Sie in die Cochlea; für eine missgebildete oder verknöcherte gelten A, B und H nicht.</translation>
    </message>
    <message>
        <source>slice %1 of %2 (at %3 mm along the normal)</source>
        <translation>Schicht %1 von %2 (bei %3 mm entlang der Normalen)</translation>
    </message>
    <message>
        <source>%1 of %2 slices have a position more than 1 km from the origin of the patient&apos;s coordinates, where no scanner measures. Export the series again as original images.</source>
        <translation>%1 von %2 Schichten liegen mehr als 1 km vom Ursprung der Patientenkoordinaten entfernt, wo kein Scanner misst. Exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>1 slice is missing behind %1, where the gap is %2 mm and the step elsewhere %3 mm. Export the whole series again.</source>
        <translation>1 Schicht fehlt hinter %1; die Lücke ist dort %2 mm und der Abstand sonst %3 mm. Exportieren Sie die ganze Serie noch einmal.</translation>
    </message>
    <message>
        <source>%1 slices are missing, the first behind %2, where the gap is %3 mm and the step elsewhere %4 mm. Export the whole series again.</source>
        <translation>%1 Schichten fehlen, die erste hinter %2; die Lücke ist dort %3 mm und der Abstand sonst %4 mm. Exportieren Sie die ganze Serie noch einmal.</translation>
    </message>
    <message>
        <source>There is a single slice; at least 2 are needed. Choose another series.</source>
        <translation>Es ist nur eine Schicht da; mindestens 2 sind nötig. Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>The slices are not equally spaced: %1 lies %2 mm from where equal steps of %3 mm put it, and at most %4 mm is allowed. Export the series again as original images.</source>
        <translation>Die Schichten haben nicht den gleichen Abstand: %1 liegt %2 mm neben ihrem Ort bei gleichen Abständen von %3 mm, höchstens %4 mm sind erlaubt. Exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>The measurement was canceled.</source>
        <translation>Die Messung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>A voxel is %1 mm long; at most 1.0 mm is allowed, and 0.6 mm or less is advised. Take a series with thinner slices.</source>
        <translation>Ein Voxel ist %1 mm lang; höchstens 1,0 mm sind erlaubt, 0,6 mm oder weniger empfohlen. Nehmen Sie eine Serie mit dünneren Schichten.</translation>
    </message>
    <message>
        <source>The right ear was not measured. %1</source>
        <translation>Das rechte Ohr wurde nicht gemessen. %1</translation>
    </message>
    <message>
        <source>The left ear was not measured. %1</source>
        <translation>Das linke Ohr wurde nicht gemessen. %1</translation>
    </message>
    <message>
        <source>No %1 cochlea was found: the one found at x %2 mm (LPS) winds as in a %3 ear. Measure that ear alone, or take a series that shows both.</source>
        <translation>Keine %1 Cochlea wurde gefunden: Die bei x %2 mm (LPS) gefundene windet sich wie eine %3. Messen Sie dieses Ohr allein, oder nehmen Sie eine Serie, die beide zeigt.</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechte</translation>
    </message>
    <message>
        <source>left</source>
        <translation>linke</translation>
    </message>
    <message>
        <source>%1 %2, so the file beside it is not opened. Copy %3 alone to another folder.</source>
        <translation>%1 %2; die Datei daneben wird darum nicht geöffnet. Kopieren Sie %3 allein in einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Reading %1 was stopped.</source>
        <translation>Das Lesen von %1 wurde angehalten.</translation>
    </message>
    <message>
        <source>%1 is damaged (%2). %3</source>
        <translation>%1 ist beschädigt (%2). %3</translation>
    </message>
    <message>
        <source>SQLite cannot be set up</source>
        <translation>SQLite kann nicht eingerichtet werden</translation>
    </message>
    <message>
        <source>%1 is not %2. %3</source>
        <translation>%1 ist etwas anderes als %2. %3</translation>
    </message>
    <message>
        <source>%1 has format %2; this program reads up to %3. Open it with a newer version.</source>
        <translation>%1 hat das Format %2; dieses Programm liest bis %3. Öffnen Sie sie mit einer neueren Version.</translation>
    </message>
    <message>
        <source>its format has no number</source>
        <translation>ihr Format hat keine Nummer</translation>
    </message>
    <message>
        <source>it has content that %1 does not have</source>
        <translation>sie hat Inhalte, die nicht dazugehören: %1</translation>
    </message>
    <message>
        <source>a table is missing</source>
        <translation>eine Tabelle fehlt</translation>
    </message>
    <message>
        <source>%1 is a folder. %2</source>
        <translation>%1 ist ein Ordner. %2</translation>
    </message>
    <message>
        <source>%1 does not exist. Check the name.</source>
        <translation>%1 gibt es nicht. Prüfen Sie den Namen.</translation>
    </message>
    <message>
        <source>%1 may not be read. Check its permissions.</source>
        <translation>%1 darf nicht gelesen werden. Prüfen Sie die Rechte.</translation>
    </message>
    <message>
        <source>%1 cannot be found: %2.</source>
        <translation>%1 kann nicht gefunden werden: %2.</translation>
    </message>
    <message>
        <source>%1 may not be written. Check its permissions and those of its folder.</source>
        <translation>%1 darf nicht geschrieben werden. Prüfen Sie die Rechte der Datei und ihres Ordners.</translation>
    </message>
    <message>
        <source>it is cut short</source>
        <translation>sie ist abgeschnitten</translation>
    </message>
    <message>
        <source>%1, but the device has no such axis. Choose another axis in [axes].</source>
        <translation>%1, aber das Gerät hat keine solche Achse. Wählen Sie eine andere Achse in [axes].</translation>
    </message>
    <message>
        <source>%1, but the device says that it only knows the value %2. Give full_counts in [axes].</source>
        <translation>%1, aber das Gerät gibt an, dass es nur den Wert %2 kennt. Geben Sie full_counts in [axes] an.</translation>
    </message>
    <message>
        <source>The %1 went away while it was told %2. Check its cable and open it again.</source>
        <translation>Das Gerät %1 verschwand, während ihm %2 mitgeteilt wurde. Prüfen Sie sein Kabel, und öffnen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The %1 did not take %2 (report %3, %4 bytes). Unplug it, plug it in again, and close other programs that use it.</source>
        <translation>Das Gerät %1 nahm %2 nicht an (Report %3, %4 Bytes). Ziehen Sie es ab, stecken Sie es wieder ein, und schließen Sie andere Programme, die es benutzen.</translation>
    </message>
    <message>
        <source>The %1 went away while it made room for a force. Check its cable.</source>
        <translation>Das Gerät %1 verschwand, während es Platz für eine Kraft schuf. Prüfen Sie sein Kabel.</translation>
    </message>
    <message>
        <source>The %1 has %2 for effect %3. Close other programs that use it, or take a profile with fewer effects (effects = &quot;direction&quot;).</source>
        <translation>Das Gerät %1 hat %2 für Effekt %3. Schließen Sie andere Programme, die es benutzen, oder nehmen Sie ein Profil mit weniger Effekten (effects = &quot;direction&quot;).</translation>
    </message>
    <message>
        <source>no room</source>
        <translation>keinen Platz</translation>
    </message>
    <message>
        <source>not answered with room</source>
        <translation>nicht mit Platz geantwortet</translation>
    </message>
    <message>
        <source>The %1 cannot show forces by the profile %2: its report descriptor lacks %3.</source>
        <translation>Das Gerät %1 kann mit dem Profil %2 keine Kräfte zeigen: Seiner Report-Beschreibung fehlt %3.</translation>
    </message>
    <message>
        <source>The report descriptor makes no sense at byte %1: %2 The device&apos;s firmware is at fault; Perilymph cannot use it.</source>
        <translation>Die Report-Beschreibung ergibt bei Byte %1 keinen Sinn: %2 Die Firmware des Geräts ist fehlerhaft; Perilymph kann es nicht benutzen.</translation>
    </message>
    <message>
        <source>The report descriptor is %1 bytes long; at most %2 are read.</source>
        <translation>Die Report-Beschreibung ist %1 Bytes lang; höchstens %2 werden gelesen.</translation>
    </message>
    <message>
        <source>The profile %1 does not fit the device: its %2 report %3 should have %4 bytes and has %5. Put right &apos;report&apos; and &apos;bytes&apos; in the profile, or take another one.</source>
        <translation>Das Profil %1 passt nicht zum Gerät: Sein %2-Report %3 sollte %4 Bytes haben und hat %5. Berichtigen Sie &apos;report&apos; und &apos;bytes&apos; im Profil, oder nehmen Sie ein anderes.</translation>
    </message>
    <message>
        <source>The profile %1 finds axes by their usage, but the device&apos;s report descriptor is empty or unreadable. Check that the device may be opened.</source>
        <translation>Das Profil %1 findet Achsen nach ihrer Verwendung, aber die Report-Beschreibung des Geräts ist leer oder unlesbar. Prüfen Sie, ob das Gerät geöffnet werden darf.</translation>
    </message>
    <message>
        <source>%1 If this program dies, only the device&apos;s own watchdog takes the force away.</source>
        <translation>%1 Wenn dieses Programm abstürzt, nimmt nur die eigene Überwachung des Geräts die Kraft weg.</translation>
    </message>
    <message>
        <source>%1 cannot be the input. %2</source>
        <translation>%1 kann nicht das Eingabegerät sein. %2</translation>
    </message>
    <message>
        <source>There is no device &apos;%1&apos;. %2</source>
        <translation>Es gibt kein Gerät &apos;%1&apos;. %2</translation>
    </message>
    <message>
        <source>%1 is not plugged in.</source>
        <translation>%1 ist nicht eingesteckt.</translation>
    </message>
    <message>
        <source>You may not open %1 (%2). Put this line into %3 and plug the device in again: %4</source>
        <translation>Sie dürfen %1 nicht öffnen (%2). Schreiben Sie diese Zeile in %3, und stecken Sie das Gerät noch einmal ein: %4</translation>
    </message>
    <message>
        <source>The HID device %1 cannot be opened. See &apos;perilymph-cli devices&apos; for what it is and who may open it, then plug it in again.</source>
        <translation>Das HID-Gerät %1 kann nicht geöffnet werden. &apos;perilymph-cli devices&apos; sagt, was es ist und wer es öffnen darf; stecken Sie es danach noch einmal ein.</translation>
    </message>
    <message>
        <source>The plug-in %1 is not taken: %2</source>
        <translation>Das Plug-in %1 wird nicht angenommen: %2</translation>
    </message>
    <message>
        <source>The %1 cannot be opened, and its plug-in does not say why.</source>
        <translation>Das Gerät %1 kann nicht geöffnet werden, und sein Plug-in nennt keinen Grund.</translation>
    </message>
    <message>
        <source>it cannot be loaded: %1. Build it for this machine.</source>
        <translation>Es kann nicht geladen werden: %1. Bauen Sie es für diesen Rechner.</translation>
    </message>
    <message>
        <source>%1() gives nothing.</source>
        <translation>%1() ergibt nichts.</translation>
    </message>
    <message>
        <source>one of its functions is missing. Fill in all of PerilymphDeviceV1.</source>
        <translation>Eine seiner Funktionen fehlt. Füllen Sie PerilymphDeviceV1 ganz aus.</translation>
    </message>
    <message>
        <source>it finds no device. Plug the device in and try again.</source>
        <translation>Es findet kein Gerät. Stecken Sie das Gerät ein, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>it does not tell its traits.</source>
        <translation>Es nennt seine Eigenschaften nicht.</translation>
    </message>
    <message>
        <source>no process can be made for it: %1.</source>
        <translation>Für es kann kein Prozess angelegt werden: %1.</translation>
    </message>
    <message>
        <source>the program %1, in which plug-ins run, is not installed. Install the package again.</source>
        <translation>Das Programm %1, in dem Plug-ins laufen, ist nicht installiert. Installieren Sie das Paket neu.</translation>
    </message>
    <message>
        <source>%1 could not be started.</source>
        <translation>%1 konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>%1 is of another version. Install the package again.</source>
        <translation>%1 ist von einer anderen Version. Installieren Sie das Paket neu.</translation>
    </message>
    <message>
        <source>its device has no name.</source>
        <translation>Sein Gerät hat keinen Namen.</translation>
    </message>
    <message>
        <source>its period between samples is %1 s; it must be between 0.0001 and 0.1.</source>
        <translation>Seine Zeit zwischen Messwerten ist %1 s; sie muss zwischen 0,0001 und 0,1 liegen.</translation>
    </message>
    <message>
        <source>its greatest force is %1 N; it must be between 0.01 and 50.</source>
        <translation>Seine größte Kraft ist %1 N; sie muss zwischen 0,01 und 50 liegen.</translation>
    </message>
    <message>
        <source>it counts %1 axes; there are 0 to 3 of a sort.</source>
        <translation>Es zählt %1 Achsen; es gibt 0 bis 3 jeder Art.</translation>
    </message>
    <message>
        <source>it counts %1 buttons; 0 to 32 are known.</source>
        <translation>Es zählt %1 Tasten; 0 bis 32 sind bekannt.</translation>
    </message>
    <message>
        <source>The tape %1 cannot be written. Check that its folder is there and may be written to.</source>
        <translation>Das Band %1 kann nicht geschrieben werden. Prüfen Sie, ob es seinen Ordner gibt und er beschreibbar ist.</translation>
    </message>
    <message>
        <source>%1, line %2: %3 A tape is written by &apos;perilymph-cli devices --capture&apos; or hid-recorder.</source>
        <translation>%1, Zeile %2: %3 Ein Band wird von &apos;perilymph-cli devices --capture&apos; oder hid-recorder geschrieben.</translation>
    </message>
    <message>
        <source>%1 holds no report of a device. A tape is written by &apos;perilymph-cli devices --capture&apos; or hid-recorder.</source>
        <translation>%1 enthält keinen Report eines Geräts. Ein Band wird von &apos;perilymph-cli devices --capture&apos; oder hid-recorder geschrieben.</translation>
    </message>
    <message>
        <source>No profile fits the device on %1 (%2, %3). For a device of a known kind add one (plugins/README.md).</source>
        <translation>Kein Profil passt zum Gerät an %1 (%2, %3). Für ein Gerät bekannter Art legen Sie eines an (plugins/README.md).</translation>
    </message>
    <message>
        <source>The recorded hand has no samples; play a recording that holds at least one tick.</source>
        <translation>Die aufgezeichnete Hand hat keine Messwerte; spielen Sie eine Aufzeichnung ab, die mindestens einen Takt enthält.</translation>
    </message>
    <message>
        <source>Cannot write %1: %2</source>
        <translation>%1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>Cannot read %1: %2</source>
        <translation>%1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>No file is named. Give the path of a file.</source>
        <translation>Es ist keine Datei genannt. Geben Sie den Pfad einer Datei an.</translation>
    </message>
    <message>
        <source>%1 needs more memory than is available. Close other programs and try again.</source>
        <translation>%1 braucht mehr Speicher, als frei ist. Schließen Sie andere Programme, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>%1 failed: %2.</source>
        <translation>%1 ist fehlgeschlagen: %2.</translation>
    </message>
    <message>
        <source>%1 failed for an unknown reason.</source>
        <translation>%1 ist aus unbekanntem Grund fehlgeschlagen.</translation>
    </message>
    <message>
        <source>Out of memory.</source>
        <translation>Der Speicher reicht nicht.</translation>
    </message>
    <message>
        <source>%1 cannot be locked: %2. Copy its folder to another disk.</source>
        <translation>%1 kann nicht gesperrt werden: %2. Kopieren Sie den Ordner auf eine andere Platte.</translation>
    </message>
    <message>
        <source>it did not end within %1 s</source>
        <translation>es endete nicht innerhalb von %1 s</translation>
    </message>
    <message>
        <source>There are several files for the %1 &apos;%2&apos;: %3 and %4. Give the path of one.</source>
        <translation>Es gibt mehrere Dateien für %1 &apos;%2&apos;: %3 und %4. Geben Sie den Pfad einer davon an.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a folder. For the %2, give the name of a file in it.</source>
        <translation>&apos;%1&apos; ist ein Ordner. Nennen Sie für %2 eine Datei darin.</translation>
    </message>
    <message>
        <source>There is no %1 or file &apos;%2&apos;. %3 Give one of these or the path of a TOML file.</source>
        <translation>Es gibt weder %1 noch Datei &apos;%2&apos;. %3 Nennen Sie eines davon oder den Pfad einer TOML-Datei.</translation>
    </message>
    <message>
        <source>%1the key &apos;%2%3&apos; is the old name of &apos;%4&apos;, which is given, too. Remove &apos;%3&apos;.</source>
        <translation>%1Der Schlüssel &apos;%2%3&apos; ist der alte Name von &apos;%4&apos;, der auch angegeben ist. Entfernen Sie &apos;%3&apos;.</translation>
    </message>
    <message>
        <source>%1:%2: this is not UTF-8 text. Check that it is the right file and save it as UTF-8.</source>
        <translation>%1:%2: Das ist kein UTF-8-Text. Prüfen Sie, ob es die richtige Datei ist, und speichern Sie sie als UTF-8.</translation>
    </message>
    <message>
        <source>%1:%2: a key has more than 16 parts between dots; no file of this program nests so deep.</source>
        <translation>%1:%2: Ein Schlüssel hat mehr als 16 Teile zwischen Punkten; keine Datei dieses Programms ist so tief.</translation>
    </message>
    <message>
        <source>%1:%2:%3: this is not TOML: %4</source>
        <translation>%1:%2:%3: Das ist kein TOML: %4</translation>
    </message>
    <message>
        <source>%1: this is not TOML: %2.</source>
        <translation>%1: Das ist kein TOML: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be created: %2 in its folder. Choose another place.</source>
        <translation>%1 kann nicht angelegt werden: %2 in seinem Ordner. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>%1 cannot be created: %2. Choose another place.</source>
        <translation>%1 kann nicht angelegt werden: %2. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>has not ended</source>
        <translation>endeten nicht</translation>
    </message>
    <message>
        <source>reached its full travel</source>
        <translation>erreichten den vollen Vorschub</translation>
    </message>
    <message>
        <source>was stopped because the force reached the limit</source>
        <translation>wurden angehalten, weil die Kraft die Grenze erreichte</translation>
    </message>
    <message>
        <source>buckled in front of the opening</source>
        <translation>knickten vor der Öffnung ein</translation>
    </message>
    <message>
        <source>bowed in front of the opening and slipped out of it</source>
        <translation>bogen sich vor der Öffnung durch und glitten heraus</translation>
    </message>
    <message>
        <source>folded over at its tip</source>
        <translation>schlugen an der Spitze um</translation>
    </message>
    <message>
        <source>jammed</source>
        <translation>blieben stecken</translation>
    </message>
    <message>
        <source>stopped with a fault</source>
        <translation>endeten mit einem Fehler</translation>
    </message>
    <message>
        <source>was refused</source>
        <translation>wurden abgelehnt</translation>
    </message>
    <message>
        <source>%1 does not exist. Check the path.</source>
        <translation>%1 gibt es nicht. Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>%1 is neither a file nor a folder. Give a folder of DICOM files, a DICOMDIR, a DICOM, NIfTI or NRRD file.</source>
        <translation>%1 ist weder eine Datei noch ein Ordner. Wählen Sie einen Ordner mit DICOM-Dateien, ein DICOMDIR, eine DICOM-, NIfTI- oder NRRD-Datei.</translation>
    </message>
    <message>
        <source>%1 holds no DICOM image. Give a folder of DICOM files, a DICOMDIR, a DICOM, NIfTI or NRRD file.</source>
        <translation>%1 enthält kein DICOM-Bild. Wählen Sie einen Ordner mit DICOM-Dateien, ein DICOMDIR, eine DICOM-, NIfTI- oder NRRD-Datei.</translation>
    </message>
    <message>
        <source>%1 holds %2 series of the number %3, of several patients or studies. Choose one of them: %3#1 and so on.</source>
        <translation>%1 enthält %2 Serien der Nummer %3, von mehreren Patienten oder Studien. Wählen Sie eine davon: %3#1 und so weiter.</translation>
    </message>
    <message>
        <source>%1 holds no series %2; it holds %3. &apos;perilymph-cli ct info&apos; lists them.</source>
        <translation>%1 enthält keine Serie %2; sie enthält %3. &apos;perilymph-cli ct info&apos; listet sie auf.</translation>
    </message>
    <message>
        <source>%1 holds %2 series, and none of them can be read; of the first: %3</source>
        <translation>%1 enthält %2 Serien, und keine davon ist lesbar; zur ersten: %3</translation>
    </message>
    <message>
        <source>%1 is one volume and holds no series %2. Leave the series out.</source>
        <translation>%1 ist ein einzelnes Volumen und enthält keine Serie %2. Lassen Sie die Serie weg.</translation>
    </message>
    <message>
        <source>%1 asks for more memory than there is. Export the region of the temporal bone.</source>
        <translation>%1 braucht mehr Speicher, als da ist. Exportieren Sie den Bereich des Felsenbeins.</translation>
    </message>
    <message>
        <source>The haptic surface of %1 could not be brought to %2 triangles; it has %3. Use the surface at full resolution, --surface.</source>
        <translation>Die haptische Oberfläche von %1 konnte nicht auf %2 Dreiecke gebracht werden; sie hat %3. Nehmen Sie die Oberfläche in voller Auflösung, --surface.</translation>
    </message>
    <message>
        <source>%1 gives its points in another unit (coordinateUnits) than mm, um, cm or m. Save the points in millimeters.</source>
        <translation>%1 gibt die Punkte in einer anderen Einheit (coordinateUnits) als mm, um, cm oder m an. Speichern Sie die Punkte in Millimetern.</translation>
    </message>
    <message>
        <source>The scala tympani is built with 2.5 turns, which were not seen in this cochlea, so no patient file is written. Use its measures without the model.</source>
        <translation>Die Scala tympani wird mit 2,5 Windungen gebaut, die in dieser Cochlea nicht gesehen wurden; deshalb wird keine Patientendatei geschrieben. Verwenden Sie ihre Maße ohne das Modell.</translation>
    </message>
    <message>
        <source>%1 does not end in .png, the only format of this picture.</source>
        <translation>%1 endet nicht auf .png, das einzige Format dieses Bilds.</translation>
    </message>
    <message>
        <source>has numbers with a decimal comma, such as &apos;%1&apos;. Export it with points, or replace the commas by points.</source>
        <translation>hat Zahlen mit Dezimalkomma, etwa &apos;%1&apos;. Exportieren Sie sie mit Punkten, oder ersetzen Sie die Kommas durch Punkte.</translation>
    </message>
    <message>
        <source>%1 ends in &apos;%2&apos;; a surface is read from .stl, .ply or .vtp. Export it as one of these.</source>
        <translation>%1 endet auf &apos;%2&apos;; eine Oberfläche wird aus .stl, .ply oder .vtp gelesen. Exportieren Sie sie so.</translation>
    </message>
    <message>
        <source>states %1 elements &apos;%2&apos;; at most 5 million are read. Export the surface of the cochlea alone.</source>
        <translation>gibt %1 Elemente &apos;%2&apos; an; höchstens 5 Millionen werden gelesen. Exportieren Sie nur die Oberfläche der Cochlea.</translation>
    </message>
    <message>
        <source>has no points with x, y and z. Export it again from the segmentation program.</source>
        <translation>hat keine Punkte mit x, y und z. Exportieren Sie sie noch einmal aus dem Segmentierungsprogramm.</translation>
    </message>
    <message>
        <source>has no faces with a list of their corners. Export it again from the segmentation program.</source>
        <translation>hat keine Flächen mit einer Liste ihrer Ecken. Exportieren Sie sie noch einmal aus dem Segmentierungsprogramm.</translation>
    </message>
    <message>
        <source>is not a whole .ply file: it does not hold the points and faces that its header states, one line of numbers each. Export it again from the segmentation program.</source>
        <translation>ist keine vollständige .ply-Datei: Sie enthält nicht die Punkte und Flächen, die ihr Kopf angibt, je eine Zeile mit Zahlen. Exportieren Sie sie noch einmal aus dem Segmentierungsprogramm.</translation>
    </message>
    <message>
        <source>%1 is encrypted. Unpack it with its password, and give the folder.</source>
        <translation>%1 ist verschlüsselt. Entpacken Sie die Datei mit ihrem Kennwort, und geben Sie den Ordner an.</translation>
    </message>
    <message>
        <source>%1 holds more than %2 files. Give the folder of one examination.</source>
        <translation>%1 enthält mehr als %2 Dateien. Wählen Sie den Ordner einer Untersuchung.</translation>
    </message>
    <message>
        <source>%1 unpacks to more than 4 GB, or to more than a hundred times its size. Unpack it, and give the folder of one series.</source>
        <translation>%1 wird entpackt größer als 4 GB oder mehr als hundertmal so groß. Entpacken Sie die Datei, und geben Sie den Ordner einer Serie an.</translation>
    </message>
    <message>
        <source>%1 cannot be unpacked: the folder for temporary files (TMPDIR) is missing, full or not writable. Make space, or unpack it and give the folder.</source>
        <translation>%1 kann nicht entpackt werden: Der Ordner für temporäre Dateien (TMPDIR) fehlt, ist voll oder nicht beschreibbar. Schaffen Sie Platz, oder entpacken Sie die Datei und geben Sie den Ordner an.</translation>
    </message>
    <message>
        <source>%1 is a damaged .zip, or took more than a minute to unpack. Copy it again, or unpack it and give the folder.</source>
        <translation>%1 ist eine beschädigte ZIP-Datei, oder das Entpacken dauerte länger als eine Minute. Kopieren Sie sie noch einmal, oder entpacken Sie sie und geben Sie den Ordner an.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2. Check its name and permissions.</source>
        <translation>%1 kann nicht gelesen werden: %2. Prüfen Sie Namen und Rechte.</translation>
    </message>
    <message>
        <source>%1 is a DICOMDIR, but none of the files it names is there. Copy the whole medium, or give a folder of images.</source>
        <translation>%1 ist ein DICOMDIR, aber keine der Dateien, die es nennt, ist da. Kopieren Sie das ganze Medium, oder wählen Sie einen Ordner mit Bildern.</translation>
    </message>
    <message>
        <source>Reading was canceled.</source>
        <translation>Das Lesen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>sequences are nested deeper than %1, which no image needs. Export the series again.</source>
        <translation>Sequenzen sind tiefer als %1 verschachtelt, was kein Bild braucht. Exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>%1 takes more than 5 minutes to list, because its files are damaged or on a slow drive. Copy the series to a folder of this computer.</source>
        <translation>%1 braucht zum Auflisten mehr als 5 Minuten, weil die Dateien beschädigt sind oder auf einem langsamen Laufwerk liegen. Kopieren Sie die Serie in einen Ordner dieses Rechners.</translation>
    </message>
    <message>
        <source>The file %1 states %2; export the series again as original images.</source>
        <translation>Die Datei %1 gibt %2; exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>The file %1</source>
        <translation>Die Datei %1</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> in %1</translation>
    </message>
    <message>
        <source>Its intensities span less than 100, so they are no Hounsfield units: a mask, a label or a normalized volume. Export the CT itself.</source>
        <translation>Die Intensitäten umfassen weniger als 100, sind also keine Hounsfield-Einheiten: eine Maske, ein Label oder ein normiertes Volumen. Exportieren Sie das CT selbst.</translation>
    </message>
    <message>
        <source>The document is no PDF of at most 64 MiB.</source>
        <translation>Das Dokument ist kein PDF von höchstens 64 MiB.</translation>
    </message>
    <message>
        <source>Title, code and version of a DICOM document have at most 64 ASCII letters.</source>
        <translation>Titel, Code und Version eines DICOM-Dokuments haben höchstens 64 ASCII-Zeichen.</translation>
    </message>
    <message>
        <source>%1 is not the CT in which this was measured: none of its series has the SHA-256 %2... that the document states. Give the folder of that CT, or leave it out.</source>
        <translation>%1 ist nicht das CT, in dem dies gemessen wurde: Keine seiner Serien hat den SHA-256 %2..., den das Dokument angibt. Geben Sie den Ordner dieses CT an, oder lassen Sie ihn weg.</translation>
    </message>
    <message>
        <source>The document states no CT series, so it cannot be compared with %1. Leave the CT out; or, if you know that it is the patient&apos;s, add --ct-not-compared.</source>
        <translation>Das Dokument gibt keine CT-Serie an und kann darum nicht mit %1 verglichen werden. Lassen Sie das CT weg, oder fügen Sie --ct-not-compared hinzu, wenn Sie wissen, dass es das des Patienten ist.</translation>
    </message>
    <message>
        <source>The gray values of slice %1 of %2 (%3) do not join those of the next one: its file states %4, the next one %5. Export the series again as original images.</source>
        <translation>Die Grauwerte von Schicht %1 von %2 (%3) schließen nicht an die der nächsten an: Ihre Datei gibt %4 an, die nächste %5. Exportieren Sie die Serie noch einmal als Originalbilder.</translation>
    </message>
    <message>
        <source>%1 of %2 files were not read: %3</source>
        <translation>%1 von %2 Dateien wurden nicht gelesen: %3</translation>
    </message>
    <message>
        <source>%1 Other files have such faults: %2.</source>
        <translation>%1 Andere Dateien haben solche Fehler: %2.</translation>
    </message>
    <message>
        <source>RescaleType (0028,1054) is %1</source>
        <translation>RescaleType (0028,1054) ist %1</translation>
    </message>
    <message>
        <source>%1 holds series of several studies. Give the folder of the one study that the report belongs to.</source>
        <translation>%1 enthält Serien mehrerer Studien. Geben Sie den Ordner der einen Studie an, zu der der Bericht gehört.</translation>
    </message>
    <message>
        <source>%1 holds no DICOM file that states its study. Give the folder of the patient&apos;s CT, or leave it out.</source>
        <translation>%1 enthält keine DICOM-Datei, die ihre Studie angibt. Geben Sie den Ordner des CT des Patienten an, oder lassen Sie ihn weg.</translation>
    </message>
    <message>
        <source>%1 as %2, where %3</source>
        <translation>%1 als %2 an, wo %3</translation>
    </message>
    <message>
        <source>one number belongs</source>
        <translation>eine Zahl stehen muss</translation>
    </message>
    <message>
        <source>%1 numbers belong</source>
        <translation>%1 Zahlen stehen müssen</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2 belongs</source>
        <translation>eine ganze Zahl von %1 bis %2 stehen muss</translation>
    </message>
    <message>
        <source>The series&apos; slices are too small for a picture.</source>
        <translation>Die Schichten der Serie sind zu klein für ein Bild.</translation>
    </message>
    <message>
        <source>%1 states %2 twice: %3 in %4 and %5 in %6; %7.</source>
        <translation>%1 gibt %2 zweimal an: %3 in %4 und %5 in %6; %7.</translation>
    </message>
    <message>
        <source>pixdim</source>
        <translation>pixdim</translation>
    </message>
    <message>
        <source>datatype</source>
        <translation>datatype</translation>
    </message>
    <message>
        <source>bitpix</source>
        <translation>bitpix</translation>
    </message>
    <message>
        <source>space directions</source>
        <translation>space directions</translation>
    </message>
    <message>
        <source>spacings</source>
        <translation>spacings</translation>
    </message>
    <message>
        <source>space units</source>
        <translation>space units</translation>
    </message>
    <message>
        <source>units</source>
        <translation>units</translation>
    </message>
    <message>
        <source>sizes</source>
        <translation>sizes</translation>
    </message>
    <message>
        <source>number</source>
        <translation>number</translation>
    </message>
    <message>
        <source>space</source>
        <translation>space</translation>
    </message>
    <message>
        <source>space dimension</source>
        <translation>space dimension</translation>
    </message>
    <message>
        <source>%1 of %2 images with its series number are of another %3 and are listed apart. Check which of them belong together.</source>
        <translation>%1 von %2 Bildern mit derselben Seriennummer haben %3 und stehen für sich. Prüfen Sie, welche zusammengehören.</translation>
    </message>
    <message>
        <source>A voxel is %1 mm long; at most 0.65 mm is advised for a cochlea.</source>
        <translation>Ein Voxel ist %1 mm lang; für eine Cochlea werden höchstens 0,65 mm empfohlen.</translation>
    </message>
    <message>
        <source>Small field of view (%1 mm); 25 mm recommended.</source>
        <translation>Kleines Bildfeld (%1 mm); 25 mm empfohlen.</translation>
    </message>
    <message>
        <source>patient or study</source>
        <translation>einen anderen Patienten oder eine andere Studie</translation>
    </message>
    <message>
        <source>frame of reference</source>
        <translation>ein anderes Bezugssystem</translation>
    </message>
    <message>
        <source>%1 cannot be inflated: there is no memory. Close programs.</source>
        <translation>%1 kann nicht entpackt werden: Der Speicher reicht nicht. Schließen Sie Programme.</translation>
    </message>
    <message>
        <source>%1 cannot be read. Check its name and permissions.</source>
        <translation>%1 ist nicht lesbar. Prüfen Sie Namen und Rechte.</translation>
    </message>
    <message>
        <source>%1 is cut off or damaged. Copy or export it again.</source>
        <translation>%1 ist abgeschnitten oder beschädigt. Kopieren oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 %2 Export the CT as MetaImage (.mha) or NRRD.</source>
        <translation>%1 %2 Exportieren Sie das CT als MetaImage (.mha) oder NRRD.</translation>
    </message>
    <message>
        <source>%1 (near)</source>
        <translation>%1 (etwa)</translation>
    </message>
    <message>
        <source>has no TransformMatrix, Offset and ElementSpacing of three dimensions, so left and right or its voxel size are not known.</source>
        <translation>hat nicht TransformMatrix, Offset und ElementSpacing in drei Dimensionen, so dass links und rechts oder die Voxelgröße unbekannt sind.</translation>
    </message>
    <message>
        <source>%1 states its unit of length as %2; millimeters, centimeters, meters and micrometers are read, one for each of three axes. Export it again in millimeters.</source>
        <translation>%1 gibt die Längeneinheit als %2 an; gelesen werden Millimeter, Zentimeter, Meter und Mikrometer, je eine für drei Achsen. Exportieren Sie die Datei noch einmal in Millimetern.</translation>
    </message>
    <message>
        <source>holds no volume of three dimensions.</source>
        <translation>enthält kein Volumen mit drei Dimensionen.</translation>
    </message>
    <message>
        <source>holds voxels that are no gray values.</source>
        <translation>enthält Voxel, die keine Grauwerte sind.</translation>
    </message>
    <message>
        <source>is of the modality %1, not CT.</source>
        <translation>hat die Modalität %1, nicht CT.</translation>
    </message>
    <message>
        <source>does not hold its voxels as binary numbers in a stated order.</source>
        <translation>enthält die Voxel nicht als binäre Zahlen in angegebener Reihenfolge.</translation>
    </message>
    <message>
        <source>scales its gray values by ElementToIntensityFunction, which programs read differently.</source>
        <translation>rechnet die Grauwerte mit ElementToIntensityFunction um, was Programme verschieden lesen.</translation>
    </message>
    <message>
        <source>keeps its voxels in &apos;%1&apos;; they are read from one file in the header&apos;s folder.</source>
        <translation>hat die Voxel in &apos;%1&apos;; gelesen werden sie aus einer Datei im Ordner des Kopfes.</translation>
    </message>
    <message>
        <source>skips a part of its voxels.</source>
        <translation>überspringt einen Teil der Voxel.</translation>
    </message>
    <message>
        <source>is no MetaImage file with a whole header.</source>
        <translation>ist keine MetaImage-Datei mit vollständigem Kopf.</translation>
    </message>
    <message>
        <source>%1 has a QForm that is no rotation: its quaternion is longer than 1, its pixdim[0] not 1 or -1, or a number not finite. Export it again.</source>
        <translation>%1 hat eine QForm, die keine Drehung ist: Das Quaternion ist länger als 1, pixdim[0] nicht 1 oder -1, oder eine Zahl nicht endlich. Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 has neither an SForm nor a QForm in a unit of length, so left and right are not known. Export it with its orientation.</source>
        <translation>%1 hat weder SForm noch QForm in einer Längeneinheit, so dass links und rechts unbekannt sind. Exportieren Sie die Datei mit ihrer Ausrichtung.</translation>
    </message>
    <message>
        <source>%1 has a scl_slope or scl_inter that scales no gray value: the slope must be above 0 and both finite. Export it again.</source>
        <translation>%1 hat ein scl_slope oder scl_inter, das keinen Grauwert umrechnet: Die Steigung muss über 0 und beide müssen endlich sein. Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 holds voxels of the type %2, which are no gray values. Save the CT as 16-bit numbers.</source>
        <translation>%1 enthält Voxel vom Typ %2, die keine Grauwerte sind. Speichern Sie das CT als 16-Bit-Zahlen.</translation>
    </message>
    <message>
        <source>%1 states by its intent_code %2 that its voxels are labels or statistics and no gray values. Save the CT itself, with the code 0.</source>
        <translation>%1 gibt durch intent_code %2 an, dass ihre Voxel Markierungen oder Statistik sind und keine Grauwerte. Speichern Sie den CT selbst, mit dem Code 0.</translation>
    </message>
    <message>
        <source>%1 holds no volume of three dimensions: its dim[0] is %2. Save the CT alone.</source>
        <translation>%1 enthält kein Volumen mit drei Dimensionen: dim[0] ist %2. Speichern Sie das CT allein.</translation>
    </message>
    <message>
        <source>%1 holds more than one volume. Save the CT alone.</source>
        <translation>%1 enthält mehr als ein Volumen. Speichern Sie das CT allein.</translation>
    </message>
    <message>
        <source>%1 is a NIfTI-2 file; NIfTI-1 is read. Save the volume as NIfTI-1 (.nii or .nii.gz) or as NRRD.</source>
        <translation>%1 ist eine NIfTI-2-Datei; gelesen wird NIfTI-1. Speichern Sie das Volumen als NIfTI-1 (.nii oder .nii.gz) oder als NRRD.</translation>
    </message>
    <message>
        <source>%1 is not a NIfTI-1 file with its voxels in it. Save the volume as .nii or .nii.gz.</source>
        <translation>%1 ist keine NIfTI-1-Datei mit ihren Voxeln. Speichern Sie das Volumen als .nii oder .nii.gz.</translation>
    </message>
    <message>
        <source>%1 states its unit of length by the code %2, which is none. Export it again in millimeters.</source>
        <translation>%1 gibt die Längeneinheit durch den Code %2 an, der keine ist. Exportieren Sie die Datei noch einmal in Millimetern.</translation>
    </message>
    <message>
        <source>%1 is damaged: its voxels begin nowhere. Export it again.</source>
        <translation>%1 ist beschädigt: Ihre Voxel haben keinen Anfang. Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 is damaged: a line of its header is no field. Copy or export it again.</source>
        <translation>%1 ist beschädigt: Eine Zeile des Kopfes ist kein Feld. Kopieren oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 %2 Export the CT as NRRD with its voxels in the file.</source>
        <translation>%1 %2 Exportieren Sie das CT als NRRD mit den Voxeln in der Datei.</translation>
    </message>
    <message>
        <source>%1 has a field &apos;%2&apos; that is not one number for each of its three axes: &apos;%3&apos;. Export it again.</source>
        <translation>%1 hat ein Feld &apos;%2&apos;, das nicht eine Zahl für jede der drei Achsen ist: &apos;%3&apos;. Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>has no space, directions and origin in the patient, so left and right are not known.</source>
        <translation>hat weder Raum noch Richtungen und Ursprung im Patienten, so dass links und rechts unbekannt sind.</translation>
    </message>
    <message>
        <source>has an axis of the kind &apos;%1&apos;, which is none in space.</source>
        <translation>hat eine Achse der Art &apos;%1&apos;, die keine räumliche ist.</translation>
    </message>
    <message>
        <source>is encoded as &apos;%1&apos;; raw and gzip are read.</source>
        <translation>ist als „%1“ kodiert; gelesen werden raw und gzip.</translation>
    </message>
    <message>
        <source>is no NRRD file with a whole header.</source>
        <translation>ist keine NRRD-Datei mit vollständigem Kopf.</translation>
    </message>
    <message>
        <source>does not say the order of its bytes.</source>
        <translation>nennt die Reihenfolge ihrer Bytes nicht.</translation>
    </message>
    <message>
        <source>It holds voxels that are not finite numbers. Export the volume as 16-bit Hounsfield units.</source>
        <translation>Es enthält Voxel, die keine endlichen Zahlen sind. Exportieren Sie das Volumen als Hounsfield-Einheiten mit 16 Bits.</translation>
    </message>
    <message>
        <source>%1 voxels lie beyond -32768 to 32767, which 16 bits hold. Export the volume as Hounsfield units.</source>
        <translation>%1 Voxel liegen jenseits von -32768 bis 32767, die 16 Bits fassen. Exportieren Sie das Volumen als Hounsfield-Einheiten.</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Bytes</translation>
    </message>
    <message>
        <source>%1 holds %2 volumes, the first %3. Give one of these files.</source>
        <translation>%1 enthält %2 Volumen, das erste %3. Wählen Sie eine dieser Dateien.</translation>
    </message>
    <message>
        <source>more than %1 bytes</source>
        <translation>mehr als %1 Bytes</translation>
    </message>
    <message>
        <source>at most %1 bytes</source>
        <translation>höchstens %1 Bytes</translation>
    </message>
    <message>
        <source> along %1</source>
        <translation> entlang %1</translation>
    </message>
    <message>
        <source>%1 has a matrix with values that are no finite numbers. Export it again with its orientation.</source>
        <translation>%1 hat eine Matrix mit Werten, die keine endlichen Zahlen sind. Exportieren Sie die Datei noch einmal mit ihrer Ausrichtung.</translation>
    </message>
    <message>
        <source>%1 has voxels of %2 mm%3 where 0.01 to 10 mm are read; its unit of length is %4. Export it again in millimeters.</source>
        <translation>%1 hat Voxel von %2 mm%3, gelesen werden 0,01 bis 10 mm; die Längeneinheit der Datei ist %4. Exportieren Sie die Datei noch einmal in Millimetern.</translation>
    </message>
    <message>
        <source>%1 has axes %2 and %3 that meet at %4 degrees, not at 90 within 0.057. Resample it to right angles, or open the original series.</source>
        <translation>%1 hat Achsen %2 und %3, die sich unter %4 Grad treffen, nicht unter 90 auf 0,057 genau. Rechnen Sie das Volumen auf rechte Winkel um, oder öffnen Sie die Originalserie.</translation>
    </message>
    <message>
        <source>%1 lies more than 1 km from the origin of the patient&apos;s coordinates, where no scanner measures. Export it again with its orientation.</source>
        <translation>%1 liegt mehr als 1 km vom Ursprung der Patientenkoordinaten entfernt, wo kein Gerät misst. Exportieren Sie die Datei noch einmal mit ihrer Lage.</translation>
    </message>
    <message>
        <source>%1 holds no volume: each of its sizes must be 2 to 65535. Export it again.</source>
        <translation>%1 enthält kein Volumen: Jede Größe muss von 2 bis 65535 sein. Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 has %2 million voxels; at most %3 million are read. Export the region of the temporal bone.</source>
        <translation>%1 hat %2 Millionen Voxel; höchstens %3 Millionen werden gelesen. Exportieren Sie den Bereich des Felsenbeins.</translation>
    </message>
    <message>
        <source>%1 has an unknown extension; a CT is written as .nrrd, .nii or .nii.gz.</source>
        <translation>%1 hat eine unbekannte Endung; ein CT wird als .nrrd, .nii oder .nii.gz geschrieben.</translation>
    </message>
    <message>
        <source>A plan of %1 simulations is too short: the lowest and the highest of fewer than %2 hold less than 88 % of the insertions to come. Choose %2 to %3.</source>
        <translation>Ein Plan aus %1 Simulationen ist zu kurz: zwischen dem kleinsten und dem größten Wert von weniger als %2 liegen weniger als 88 % der künftigen Insertionen. Wählen Sie %2 bis %3.</translation>
    </message>
    <message>
        <source>%1 has draws of %2 arrays, not of %3. Delete it or give another folder.</source>
        <translation>%1 hat Simulationen von %2 Trägern, nicht von %3. Löschen Sie die Datei, oder geben Sie einen anderen Ordner an.</translation>
    </message>
    <message>
        <source>it is not JSON</source>
        <translation>es ist kein JSON</translation>
    </message>
    <message>
        <source>a value is missing or has another type</source>
        <translation>ein Wert fehlt oder hat einen anderen Typ</translation>
    </message>
    <message>
        <source>the draws of a plan of Perilymph</source>
        <translation>die Simulationen eines Plans von Perilymph</translation>
    </message>
    <message>
        <source>Choose a draws.sqlite that &apos;perilymph-cli plan&apos; wrote.</source>
        <translation>Wählen Sie eine draws.sqlite, die &apos;perilymph-cli plan&apos; geschrieben hat.</translation>
    </message>
    <message>
        <source>Delete it and make the plan again.</source>
        <translation>Löschen Sie sie, und erstellen Sie den Plan noch einmal.</translation>
    </message>
    <message>
        <source>draws</source>
        <translation>Simulationen</translation>
    </message>
    <message>
        <source>draw %1 is not readable: %2</source>
        <translation>Simulation %1 ist nicht lesbar: %2</translation>
    </message>
    <message>
        <source>draw %1 is not readable: it is another one</source>
        <translation>Simulation %1 ist nicht lesbar: es ist eine andere</translation>
    </message>
    <message>
        <source>its draws are not consecutive</source>
        <translation>ihre Simulationen folgen nicht aufeinander</translation>
    </message>
    <message>
        <source>its last draw is not whole</source>
        <translation>ihre letzte Simulation ist nicht vollständig</translation>
    </message>
    <message>
        <source>%1 is of a newer program (format %2). Open it with that one.</source>
        <translation>%1 ist von einem neueren Programm (Format %2). Öffnen Sie ihn mit diesem.</translation>
    </message>
    <message>
        <source>The array %1 starts at its full depth. Lower start_inside_mm.</source>
        <translation>Der Träger %1 beginnt in voller Tiefe. Verringern Sie start_inside_mm.</translation>
    </message>
    <message>
        <source>The patient %1 has no A and B, which a plan needs. Measure them, or use &apos;simulate&apos;.</source>
        <translation>Dem Patienten %1 fehlen A und B, die ein Plan braucht. Messen Sie sie, oder verwenden Sie &apos;simulate&apos;.</translation>
    </message>
    <message>
        <source>A plan needs at least one array. Name one.</source>
        <translation>Ein Plan braucht mindestens einen Träger. Nennen Sie einen.</translation>
    </message>
    <message>
        <source>A plan of %1 draws is not possible; 1 to %2 are.</source>
        <translation>Ein Plan mit %1 Simulationen ist nicht möglich; möglich sind 1 bis %2.</translation>
    </message>
    <message>
        <source>A cochlea of %1 cannot be built: %2. Check A and B and their errors.</source>
        <translation>Eine Cochlea von %1 kann nicht aufgebaut werden: %2. Prüfen Sie A und B und ihre Fehler.</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>An array, the scenario, a distribution or the program was changed since the plan of %1 was made. Make it again.</source>
        <translation>Ein Träger, das Szenario, eine Verteilung oder das Programm wurde geändert, seit der Plan von %1 erstellt wurde. Erstellen Sie ihn noch einmal.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>dt_ms is %1; with %2, which renders force, it must be at most %3, so that a stop removes the force within 5 ms. Set dt_ms = 1.</source>
        <translation>dt_ms ist %1; mit %2, das Kräfte zeigt, darf es höchstens %3 sein, damit ein Halt die Kraft innerhalb von 5 ms wegnimmt. Setzen Sie dt_ms = 1.</translation>
    </message>
    <message>
        <source>The insertion of %1 stopped with a fault at tick %2, %3 mm of travel (%4). Try a smaller dt_ms, a lower speed_mm_s or a softer wall.</source>
        <translation>Die Insertion von %1 endete mit einem Fehler bei Takt %2, nach %3 mm Vorschub (%4). Versuchen Sie ein kleineres dt_ms, ein kleineres speed_mm_s oder eine weichere Wand.</translation>
    </message>
    <message>
        <source>The loop takes no requests: eight are waiting. Run a tick first.</source>
        <translation>Die Schleife nimmt keine Anforderungen an: acht warten. Lassen Sie zuerst einen Takt laufen.</translation>
    </message>
    <message>
        <source>%1 cannot be run: %2</source>
        <translation>%1 kann nicht ausgeführt werden: %2</translation>
    </message>
    <message>
        <source>%1 contains no samples and cannot be replayed: the insertion was never started.</source>
        <translation>%1 enthält keine Messwerte und kann nicht abgespielt werden: Die Insertion wurde nie gestartet.</translation>
    </message>
    <message>
        <source>Stopped after %1 of %2 ticks.</source>
        <translation>Nach %1 von %2 Takten angehalten.</translation>
    </message>
    <message>
        <source>Recorded by build %1, replayed by build %2.</source>
        <translation>Aufgezeichnet vom Programmstand %1, abgespielt vom Stand %2.</translation>
    </message>
    <message>
        <source>The file of the array &apos;%1&apos; has changed since the recording was made.</source>
        <translation>Die Datei des Trägers &apos;%1&apos; hat sich seit der Aufzeichnung geändert.</translation>
    </message>
    <message>
        <source>Recorded in format 1, which has no hash: that nothing was changed is shown by counts, columns, events and the replay alone.</source>
        <translation>Aufgezeichnet im Format 1, das keinen Hash hat: Dass nichts geändert wurde, zeigen nur Anzahlen, Spalten, Ereignisse und die Wiedergabe.</translation>
    </message>
    <message>
        <source>Stopped after %1 of %2 ticks; %3 is not verified.</source>
        <translation>Nach %1 von %2 Takten angehalten; %3 ist nicht geprüft.</translation>
    </message>
    <message>
        <source>A version was saved at &quot;%1&quot;, which is no date like 2026-11-20T09:30:00Z.</source>
        <translation>Eine Version wurde um „%1“ gespeichert, was kein Datum wie 2026-11-20T09:30:00Z ist.</translation>
    </message>
    <message>
        <source>The landmark %1 lies beyond any scanner. Correct it.</source>
        <translation>Die Landmarke %1 liegt außerhalb jedes Scanners. Berichtigen Sie sie.</translation>
    </message>
    <message>
        <source>An outcome of the series &quot;%1&quot; has no hash or no date.</source>
        <translation>Ein Ergebnis der Serie „%1“ hat keinen Hash oder kein Datum.</translation>
    </message>
    <message>
        <source>The scan &quot;%1&quot; of &quot;%2&quot; is not possible: it has up to 64 hexadecimal digits and a date like 2026-11-20T09:30:00Z. Correct or remove it.</source>
        <translation>Der Scan „%1“ von „%2“ ist nicht möglich: Er hat bis zu 64 hexadezimale Ziffern und ein Datum wie 2026-11-20T09:30:00Z. Berichtigen oder entfernen Sie ihn.</translation>
    </message>
    <message>
        <source>The library has %1, %2, already. Rename or remove that patient first.</source>
        <translation>Die Bibliothek hat %1, %2, schon. Benennen Sie diesen Patienten zuerst um, oder entfernen Sie ihn.</translation>
    </message>
    <message>
        <source>left ear</source>
        <translation>linkes Ohr</translation>
    </message>
    <message>
        <source>right ear</source>
        <translation>rechtes Ohr</translation>
    </message>
    <message>
        <source>%1 exists already in %2. Choose another name.</source>
        <translation>%1 gibt es schon in %2. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1 cannot be moved to %2: %3. Check that you may write into both folders.</source>
        <translation>%1 kann nicht nach %2 verschoben werden: %3. Prüfen Sie, ob Sie in beide Ordner schreiben dürfen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid recording name. Use 1–120 characters, no slash, no leading period.</source>
        <translation>&apos;%1&apos; ist kein gültiger Name einer Aufzeichnung. Verwenden Sie 1 bis 120 Zeichen, keinen Schrägstrich und keinen Punkt am Anfang.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2. Nothing was deleted.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden: %2. Nichts wurde gelöscht.</translation>
    </message>
    <message>
        <source>%1 is not a folder of the library but a link or a file. Nothing was deleted; move it away first.</source>
        <translation>%1 ist kein Ordner der Bibliothek, sondern ein Verweis oder eine Datei. Nichts wurde gelöscht; verschieben Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>The folder of recordings %1 cannot be read: %2. Check its permissions.</source>
        <translation>Der Ordner der Aufzeichnungen %1 kann nicht gelesen werden: %2. Prüfen Sie die Rechte.</translation>
    </message>
    <message>
        <source>its rows are not in order after %1</source>
        <translation>ihre Zeilen sind nach %1 nicht in Reihenfolge</translation>
    </message>
    <message>
        <source>a fact about it is not text</source>
        <translation>eine Angabe zu ihr ist kein Text</translation>
    </message>
    <message>
        <source>it says more about itself than a recording does</source>
        <translation>sie enthält mehr Angaben als eine Aufzeichnung</translation>
    </message>
    <message>
        <source>a fact about it is there twice</source>
        <translation>eine Angabe zu ihr steht zweimal da</translation>
    </message>
    <message>
        <source>facts about it are missing</source>
        <translation>Angaben zu ihr fehlen</translation>
    </message>
    <message>
        <source>its format has no hash, and there is one</source>
        <translation>ihr Format hat keinen Hash, und es ist einer da</translation>
    </message>
    <message>
        <source>its hash is missing</source>
        <translation>ihr Hash fehlt</translation>
    </message>
    <message>
        <source>it does not say whether it was closed</source>
        <translation>sie gibt nicht an, ob sie geschlossen wurde</translation>
    </message>
    <message>
        <source>the record of tick %1 cannot be read</source>
        <translation>der Datensatz des Takts %1 kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>%1 is a folder; name a file to record into.</source>
        <translation>%1 ist ein Ordner; nennen Sie eine Datei für die Aufzeichnung.</translation>
    </message>
    <message>
        <source>%1 exists already; a recording is never overwritten. Choose another name or move the file away.</source>
        <translation>%1 gibt es schon; eine Aufzeichnung wird nie überschrieben. Wählen Sie einen anderen Namen, oder verschieben Sie die Datei.</translation>
    </message>
    <message>
        <source>The folder %1 does not exist, so %2 cannot be recorded there. Create it first.</source>
        <translation>Den Ordner %1 gibt es nicht, so dass %2 dort nicht aufgezeichnet werden kann. Legen Sie ihn zuerst an.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose a folder you may write to.</source>
        <translation>%1 kann nicht geschrieben werden: %2. Wählen Sie einen Ordner, in den Sie schreiben dürfen.</translation>
    </message>
    <message>
        <source>%1 can no longer be recorded (%2). What is in it stays readable; make space on the disk and start a new recording.</source>
        <translation>%1 kann nicht weiter aufgezeichnet werden (%2). Was darin steht, bleibt lesbar; schaffen Sie Platz auf der Platte, und beginnen Sie eine neue Aufzeichnung.</translation>
    </message>
    <message>
        <source>%1 was moved or deleted while it was recorded, so nothing more is recorded. Start a new recording, and move recordings only after the insertion.</source>
        <translation>%1 wurde während der Aufzeichnung verschoben oder gelöscht; darum wird nichts mehr aufgezeichnet. Beginnen Sie eine neue Aufzeichnung, und verschieben Sie Aufzeichnungen erst nach der Insertion.</translation>
    </message>
    <message>
        <source>%1 cannot be begun: %2. Is there space on the disk?</source>
        <translation>%1 kann nicht begonnen werden: %2. Ist Platz auf der Platte?</translation>
    </message>
    <message>
        <source>%1 is complete, but in several files, because another program reads it. Close that program; the recording is one file when it has been opened once more.</source>
        <translation>%1 ist vollständig, aber in mehreren Dateien, weil ein anderes Programm sie liest. Beenden Sie dieses Programm; die Aufzeichnung ist eine Datei, sobald sie noch einmal geöffnet wurde.</translation>
    </message>
    <message>
        <source>a recording of Perilymph</source>
        <translation>eine Aufzeichnung von Perilymph</translation>
    </message>
    <message>
        <source>Choose an .insertion file.</source>
        <translation>Wählen Sie eine .insertion-Datei.</translation>
    </message>
    <message>
        <source>Use another copy of the recording.</source>
        <translation>Verwenden Sie eine andere Kopie der Aufzeichnung.</translation>
    </message>
    <message>
        <source>a value in %1 has another type</source>
        <translation>ein Wert in %1 hat einen anderen Typ</translation>
    </message>
    <message>
        <source>the rows of %1 are not in order</source>
        <translation>die Zeilen von %1 sind nicht in Reihenfolge</translation>
    </message>
    <message>
        <source>%1 cannot be continued: %2.</source>
        <translation>%1 kann nicht fortgesetzt werden: %2.</translation>
    </message>
    <message>
        <source>a fact about it is not readable</source>
        <translation>eine Angabe zu ihr ist nicht lesbar</translation>
    </message>
    <message>
        <source>%1 %2 Delete it or give another folder.</source>
        <translation>%1 %2 Löschen Sie sie, oder geben Sie einen anderen Ordner an.</translation>
    </message>
    <message>
        <source>rows of %1 belong to no insertion</source>
        <translation>Zeilen von %1 gehören zu keiner Insertion</translation>
    </message>
    <message>
        <source>%1 cannot be closed: %2.</source>
        <translation>%1 kann nicht geschlossen werden: %2.</translation>
    </message>
    <message>
        <source>%1: technique is &apos;%2&apos;, but the array %3 %4. Set technique to &apos;standard&apos;.</source>
        <translation>%1: technique ist &apos;%2&apos;, aber der Träger %3 %4. Setzen Sie technique auf &apos;standard&apos;.</translation>
    </message>
    <message>
        <source>names no depth at which its stylet is held</source>
        <translation>nennt keine Tiefe, in der sein Stilett gehalten wird</translation>
    </message>
    <message>
        <source>has no stylet</source>
        <translation>hat kein Stilett</translation>
    </message>
    <message>
        <source>%1: start_inside_mm + stop_travel_mm is %2; the array %3 may go in %4 mm at most. Lower stop_travel_mm.</source>
        <translation>%1: start_inside_mm + stop_travel_mm ist %2; der Träger %3 darf höchstens %4 mm hinein. Verringern Sie stop_travel_mm.</translation>
    </message>
    <message>
        <source>%1: %2 is %3, and the published model of points has %4 only. Set model to &apos;rod&apos;, or %2 to %5.</source>
        <translation>%1: %2 ist %3, und das veröffentlichte Punktmodell hat nur %4. Setzen Sie model auf &apos;rod&apos; oder %2 auf %5.</translation>
    </message>
    <message>
        <source>The calibration %1 was fitted for the array %2, not for %3. Set calibration to &quot;&quot; or name one of this array.</source>
        <translation>Die Kalibrierung %1 wurde für den Träger %2 angepasst, nicht für %3. Setzen Sie calibration auf &quot;&quot;, oder nennen Sie eine für diesen Träger.</translation>
    </message>
    <message>
        <source>The model of %1 cannot be built: %2</source>
        <translation>Das Modell von %1 kann nicht aufgebaut werden: %2</translation>
    </message>
    <message>
        <source>%1: passage_mm is %2, but only a drilled opening has a passage. Set passage_mm to 0 or opening to &apos;cochleostomy&apos;.</source>
        <translation>%1: passage_mm ist %2, aber nur eine gebohrte Öffnung hat einen Durchgang. Setzen Sie passage_mm auf 0 oder opening auf &apos;cochleostomy&apos;.</translation>
    </message>
    <message>
        <source>%1: passage_mm is %2; the passage lies in the straight stretch before the spiral, whose lead_in_mm is %3. Lower passage_mm or raise lead_in_mm.</source>
        <translation>%1: passage_mm ist %2; der Durchgang liegt im geraden Stück vor der Spirale, dessen lead_in_mm %3 ist. Verringern Sie passage_mm, oder erhöhen Sie lead_in_mm.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, with a line break, another control character or a byte that is not UTF-8, which a batch script cannot hold. Rename it.</source>
        <translation>%1 ist „%2“, mit einem Zeilenumbruch, einem anderen Steuerzeichen oder einem Byte, das kein UTF-8 ist, was ein Batch-Skript nicht fassen kann. Benennen Sie es um.</translation>
    </message>
    <message>
        <source>--out is &quot;%1&quot;, whose backslash Slurm does not take in the name of a log. Rename the folder.</source>
        <translation>--out ist „%1“; den Rückstrich darin nimmt Slurm im Namen eines Protokolls nicht. Benennen Sie den Ordner um.</translation>
    </message>
    <message>
        <source>--partition is &quot;%1&quot;; it has letters, digits and _ . , + - only. sinfo lists partitions.</source>
        <translation>--partition ist „%1“; erlaubt sind nur Buchstaben, Ziffern und _ . , + -. sinfo listet die Partitionen auf.</translation>
    </message>
    <message>
        <source>--time is &quot;%1&quot;; Slurm writes it as 30 (minutes), 02:00:00 or 1-12:00:00. Correct it.</source>
        <translation>--time ist „%1“; Slurm schreibt sie als 30 (Minuten), 02:00:00 oder 1-12:00:00. Berichtigen Sie sie.</translation>
    </message>
    <message>
        <source>--sbatch-option is &quot;%1&quot;; it begins with a hyphen, such as --sbatch-option=--mem=2G.</source>
        <translation>--sbatch-option ist „%1“; sie beginnt mit einem Bindestrich, etwa --sbatch-option=--mem=2G.</translation>
    </message>
    <message>
        <source>This Slurm takes no job arrays (MaxArraySize=%1). Ask its administrator, or run the parts by `study shard`.</source>
        <translation>Dieses Slurm nimmt keine Job-Arrays an (MaxArraySize=%1). Fragen Sie seinen Verwalter, oder führen Sie die Teile mit `study shard` aus.</translation>
    </message>
    <message>
        <source>--shards is %1, which with the merge are more jobs than this Slurm keeps at a time (MaxJobCount=%2). Give fewer parts.</source>
        <translation>--shards ist %1; das sind mit dem Zusammenführen mehr Jobs, als dieses Slurm auf einmal hält (MaxJobCount=%2). Nennen Sie weniger Teile.</translation>
    </message>
    <message>
        <source>`scontrol show config` names no %1, so that the parts cannot be dealt out. Is it Slurm&apos;s? --dry-run prints the scripts.</source>
        <translation>`scontrol show config` nennt kein %1, so dass die Teile nicht verteilt werden können. Ist es das von Slurm? --dry-run gibt die Skripte aus.</translation>
    </message>
    <message>
        <source>sbatch answered &quot;%1&quot;, which is no number of a job. `squeue --me` lists whether it made one.</source>
        <translation>sbatch antwortete „%1“, was keine Nummer eines Jobs ist. `squeue --me` zeigt, ob es einen angelegt hat.</translation>
    </message>
    <message>
        <source>%1 was changed while the study ran. The results before are kept: put the file back to continue, or run the study into another folder.</source>
        <translation>%1 wurde geändert, während die Studie lief. Die Ergebnisse davor bleiben: Legen Sie die Datei zurück, um fortzufahren, oder rechnen Sie die Studie in einen anderen Ordner.</translation>
    </message>
    <message>
        <source>The array %1 is %2 mm long and would start %3 mm inside. Lower start_inside_mm.</source>
        <translation>Der Träger %1 ist %2 mm lang und würde %3 mm innen beginnen. Verringern Sie start_inside_mm.</translation>
    </message>
    <message>
        <source>The study in %1 cannot be read again: %2 Put the files it names beside it.</source>
        <translation>Die Studie in %1 kann nicht noch einmal gelesen werden: %2 Legen Sie die Dateien, die sie nennt, daneben.</translation>
    </message>
    <message>
        <source>The study in %1 names files that differ from those it was run with. Put those beside it.</source>
        <translation>Die Studie in %1 nennt Dateien, die sich von denen unterscheiden, mit denen sie gerechnet wurde. Legen Sie jene daneben.</translation>
    </message>
    <message>
        <source>Insertion %1 is not in the study, which has %2 of them, counted from 0.</source>
        <translation>Insertion %1 ist nicht in der Studie, die %2 davon hat, ab 0 gezählt.</translation>
    </message>
    <message>
        <source>is_inserted is %1; it must be 0 or 1</source>
        <translation>is_inserted ist %1; es muss 0 oder 1 sein</translation>
    </message>
    <message>
        <source>its settings or its ending cannot be read</source>
        <translation>ihre Einstellungen oder ihr Ende sind nicht lesbar</translation>
    </message>
    <message>
        <source>its ticks are fewer than none</source>
        <translation>sie hat weniger als null Takte</translation>
    </message>
    <message>
        <source>a study of Perilymph</source>
        <translation>eine Studie von Perilymph</translation>
    </message>
    <message>
        <source>Choose a .sqlite file that &apos;perilymph-cli study&apos; wrote.</source>
        <translation>Wählen Sie eine .sqlite-Datei, die &apos;perilymph-cli study&apos; geschrieben hat.</translation>
    </message>
    <message>
        <source>Delete it and run its shard again.</source>
        <translation>Löschen Sie sie, und rechnen Sie ihren Teil noch einmal.</translation>
    </message>
    <message>
        <source>it does not say which insertions it is for</source>
        <translation>sie gibt nicht an, für welche Insertionen sie ist</translation>
    </message>
    <message>
        <source>%1 does not say which insertions it is for. Delete it and run its shard again.</source>
        <translation>%1 gibt nicht an, für welche Insertionen sie ist. Löschen Sie sie, und rechnen Sie ihren Teil noch einmal.</translation>
    </message>
    <message>
        <source>insertion %1 is not readable: %2</source>
        <translation>Insertion %1 ist nicht lesbar: %2</translation>
    </message>
    <message>
        <source>its insertions are not consecutive</source>
        <translation>ihre Insertionen folgen nicht aufeinander</translation>
    </message>
    <message>
        <source>%1 has no shards. Run &apos;perilymph-cli study run&apos; or &apos;study shard&apos; into it first.</source>
        <translation>%1 hat keine Teile. Führen Sie zuerst &apos;perilymph-cli study run&apos; oder &apos;study shard&apos; dorthin aus.</translation>
    </message>
    <message>
        <source>%1 was changed after the program wrote it. Delete it and run its shard again.</source>
        <translation>%1 wurde geändert, nachdem das Programm sie geschrieben hatte. Löschen Sie sie, und rechnen Sie ihren Teil noch einmal.</translation>
    </message>
    <message>
        <source>%1 carries no seal: it is of an earlier version. Delete it and run its shard again.</source>
        <translation>%1 trägt kein Siegel: sie ist von einer früheren Version. Löschen Sie sie, und rechnen Sie ihren Teil noch einmal.</translation>
    </message>
    <message>
        <source>%1 is of another study or another build of the program than %2. Remove the one that does not belong here.</source>
        <translation>%1 ist von einer anderen Studie oder einem anderen Programmstand als %2. Entfernen Sie die, die nicht hierher gehört.</translation>
    </message>
    <message>
        <source>%1 is not complete (%2 of %3 insertions). Run its shard again.</source>
        <translation>%1 ist nicht vollständig (%2 von %3 Insertionen). Rechnen Sie den Teil noch einmal.</translation>
    </message>
    <message>
        <source>%1 has insertions that another shard has, too (from number %2). Remove the shards of one of the two divisions.</source>
        <translation>%1 hat Insertionen, die ein anderer Teil auch hat (ab Nummer %2). Entfernen Sie die Teile einer der beiden Aufteilungen.</translation>
    </message>
    <message>
        <source>The insertions %1 to %2 are missing in %3. Run their shard.</source>
        <translation>Die Insertionen %1 bis %2 fehlen in %3. Rechnen Sie ihren Teil.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2. Check the name.</source>
        <translation>%1 kann nicht gelesen werden: %2. Prüfen Sie den Namen.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be read: it is no folder. Check the name.</source>
        <translation>%1 kann nicht gelesen werden: es ist kein Ordner. Prüfen Sie den Namen.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be created: %2. Give another folder.</source>
        <translation>%1 kann nicht angelegt werden: %2. Geben Sie einen anderen Ordner an.</translation>
    </message>
    <message>
        <source>There is no scala tympani to draw. Name a scenario, a patient or a preset.</source>
        <translation>Es gibt keine Scala tympani zu zeichnen. Nennen Sie ein Szenario, einen Patienten oder eine Vorlage.</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels cannot be drawn; each must be 64 to 8192.</source>
        <translation>Ein Bild von %1 x %2 Pixeln kann nicht gezeichnet werden; beides muss 64 bis 8192 sein.</translation>
    </message>
    <message>
        <source>The picture %1 must end in .png.</source>
        <translation>Das Bild %1 muss auf .png enden.</translation>
    </message>
    <message>
        <source>There is no display to draw with, and no file could be opened for a private one. Close other programs.</source>
        <translation>Es gibt keine Anzeige zum Zeichnen, und für eine eigene konnte keine Datei geöffnet werden. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>There is no display to draw with, and Xvfb, which could stand in for one, is not installed. Install the package xvfb or set DISPLAY.</source>
        <translation>Es gibt keine Anzeige zum Zeichnen, und Xvfb, das eine ersetzen könnte, ist nicht installiert. Installieren Sie das Paket xvfb, oder setzen Sie DISPLAY.</translation>
    </message>
    <message>
        <source>There is no display to draw with, and Xvfb did not start within 10 s. Try `Xvfb -displayfd 1` by hand or set DISPLAY.</source>
        <translation>Es gibt keine Anzeige zum Zeichnen, und Xvfb startete nicht innerhalb von 10 s. Versuchen Sie `Xvfb -displayfd 1` von Hand, oder setzen Sie DISPLAY.</translation>
    </message>
    <message>
        <source>There is no display to draw with: DISPLAY is not set.</source>
        <translation>Es gibt keine Anzeige zum Zeichnen: DISPLAY ist nicht gesetzt.</translation>
    </message>
    <message>
        <source>The display %1 does not answer. Check DISPLAY and that its server is running.</source>
        <translation>Die Anzeige %1 antwortet nicht. Prüfen Sie DISPLAY und ob ihr Server läuft.</translation>
    </message>
    <message>
        <source>The display %1 offers no OpenGL 3.2. Install Mesa&apos;s drivers (libgl1-mesa-dri) or use another.</source>
        <translation>Die Anzeige %1 bietet kein OpenGL 3.2. Installieren Sie die Treiber von Mesa (libgl1-mesa-dri), oder nehmen Sie eine andere.</translation>
    </message>
    <message>
        <source>Clinical and Experimental Otorhinolaryngology, nine neurotologists in cadaver heads: 0.66 +- 0.31 mm/s; a robot&apos;s 0.1 as the lower limit.</source>
        <translation>Clinical and Experimental Otorhinolaryngology, neun Neurootologen an Kopfpräparaten: 0,66 +- 0,31 mm/s; die 0,1 eines Roboters als untere Grenze.</translation>
    </message>
    <message>
        <source>Microsurgeons: 0.038 mm in vivo, 0.049 at rest, 0.133 while actuating; that these are distances in three axes is an assumption. 8.1 Hz: otosurgery (Muerbe 2001).</source>
        <translation>Mikrochirurgen: 0,038 mm in vivo, 0,049 in Ruhe, 0,133 beim Betätigen; dass es Abstände in drei Achsen sind, ist eine Annahme. 8,1 Hz: Ohrchirurgie (Muerbe 2001).</translation>
    </message>
    <message>
        <source>Peak forces in vivo, 44.8 to 102.4 mN (Rau et al. 2024, Front Neurol 15:1400455), read as the forces at which surgeons stop: the predicted peak rests on it.</source>
        <translation>Maximalkräfte in vivo, 44,8 bis 102,4 mN (Rau et al. 2024, Front Neurol 15:1400455), gelesen als die Kräfte, bei denen Chirurgen anhalten: Die vorhergesagte Maximalkraft beruht darauf.</translation>
    </message>
    <message>
        <source>Choice: a bow of 1.1 mm on 4 mm.</source>
        <translation>Wahl: ein Bogen von 1,1 mm auf 4 mm.</translation>
    </message>
    <message>
        <source>Schuster et al. 2015, Otol Neurotol 36:657, fresh human partition: 42 to 122 mN, mean 88, as recalled, not read; the standard deviation is a choice.</source>
        <translation>Schuster et al. 2015, Otol Neurotol 36:657, frische menschliche cochleäre Trennwand: 42 bis 122 mN, Mittel 88, aus der Erinnerung, nicht gelesen; die Standardabweichung ist eine Wahl.</translation>
    </message>
    <message>
        <source>Soap 10 %: speed-independent</source>
        <translation>Seife 10 %: geschwindigkeitsunabhängig</translation>
    </message>
    <message>
        <source>Soap 50 %: decreases with speed</source>
        <translation>Seife 50 %: sinkt mit der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Soap 90 %: increases with speed</source>
        <translation>Seife 90 %: steigt mit der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Best speech recognition is quoted at 70 to 75 % (cited in Breitsprecher et al. 2021, Eur Radiol); the band is widened to 65 to 80 % because studies differ: in 154 ears coverage affected speech recognition (Weller et al. 2023, PLoS One, e0287450), six of seven reviewed studies found no effect of the angular depth (Heutink et al. 2019, Otol Neurotol 40:900).</source>
        <translation>Das beste Sprachverstehen wird bei 70 bis 75 % angegeben (zitiert in Breitsprecher et al. 2021, Eur Radiol); das Band ist auf 65 bis 80 % erweitert, weil Studien sich unterscheiden: In 154 Ohren wirkte sich die Abdeckung auf das Sprachverstehen aus (Weller et al. 2023, PLoS One, e0287450), sechs von sieben ausgewerteten Studien fanden keinen Einfluss der Winkeltiefe (Heutink et al. 2019, Otol Neurotol 40:900).</translation>
    </message>
    <message>
        <source>70 to 8500 Hz on 12 channels, the default of MAESTRO for fine-structure strategies, as listed in public fitting-research code that cites the MAESTRO user manual.</source>
        <translation>70 bis 8500 Hz auf 12 Kanälen, die Vorgabe von MAESTRO für Feinstruktur-Strategien, wie in öffentlichem Forschungscode zur Anpassung, der das Handbuch von MAESTRO zitiert.</translation>
    </message>
    <message>
        <source>188 to 7938 Hz on 22 channels: CI Select App manual (NYU Langone) and PMC11493529, as listed in public fitting-research code that cites both.</source>
        <translation>188 bis 7938 Hz auf 22 Kanälen: Handbuch der CI Select App (NYU Langone) und PMC11493529, wie in öffentlichem Forschungscode zur Anpassung, der beide zitiert.</translation>
    </message>
    <message>
        <source>250 to 8700 Hz on 16 channels (extended low): SoundWave 2.2 quick reference, as listed in public fitting-research code that cites it.</source>
        <translation>250 bis 8700 Hz auf 16 Kanälen (extended low): Kurzanleitung von SoundWave 2,2, wie in öffentlichem Forschungscode zur Anpassung, der sie zitiert.</translation>
    </message>
    <message>
        <source>Avci et al. 2014, J Comp Neurol 522:3245, 16 cochleae: relative standard deviation of the section&apos;s diameter 9 to 15 %; the middle, less in squares the 5 % that go with A and B. Correlation along the scala: measured on the labels of ten bony lumens (Wimmer et al. 2019, Data Brief 25:104782), 0.83, 0.69 and 0.41 over a quarter, a half and three quarters of a turn.</source>
        <translation>Avci et al. 2014, J Comp Neurol 522:3245, 16 Cochleae: relative Standardabweichung des Querschnittsdurchmessers 9 bis 15 %; die Mitte, quadratisch vermindert um die 5 %, die mit A und B gehen. Korrelation entlang der Scala: an den Labels von zehn knöchernen Lumina gemessen (Wimmer et al. 2019, Data Brief 25:104782), 0,83, 0,69 und 0,41 über eine viertel, eine halbe und drei viertel Windung.</translation>
    </message>
    <message>
        <source>Dips, jumps and peaks differ between cochleae (Avci et al. 2014). Measured on the labels of ten bony lumens (Wimmer et al. 2019), 40 to 400 degrees: beside rise and tilt of the whole, 0.037 to 0.054 mm of the center line&apos;s height are left, with correlations of -0.6, -0.7 and 0.6 over 60, 90 and 180 degrees; a course correlated over 60 degrees leaves them, and 28 % of its deviation: 0.13 to 0.19 mm.</source>
        <translation>Senken, Sprünge und Gipfel unterscheiden sich zwischen Cochleae (Avci et al. 2014). An den Labels von zehn knöchernen Lumina gemessen (Wimmer et al. 2019), 40 bis 400 Grad: Neben Anstieg und Neigung des Ganzen bleiben 0,037 bis 0,054 mm der Höhe der Mittellinie, mit Korrelationen von -0,6, -0,7 und 0,6 über 60, 90 und 180 Grad; ein über 60 Grad korrelierter Verlauf lässt sie übrig, und 28 % seiner Abweichung: 0,13 bis 0,19 mm.</translation>
    </message>
    <message>
        <source>Measured on the labels of ten bony lumens (Wimmer et al. 2019), 40 to 400 degrees: the population&apos;s spiral leaves 1.3 % of the outer wall&apos;s radius, and 1 % is common to neighbors 10 degrees apart; an upper limit, since a voxel is 4 %.</source>
        <translation>An den Labels von zehn knöchernen Lumina gemessen (Wimmer et al. 2019), 40 bis 400 Grad: Die Spirale der Population lässt 1,3 % des Radius der Außenwand übrig, und 1 % ist Nachbarn im Abstand von 10 Grad gemeinsam; eine obere Grenze, da ein Voxel 4 % ist.</translation>
    </message>
    <message>
        <source>H 3.26 mm, standard deviation 0.24 mm, in 36 ears (Medan, PMC6449142): the relative deviation alone, because definitions of H differ.</source>
        <translation>H 3,26 mm, Standardabweichung 0,24 mm, in 36 Ohren (Medan, PMC6449142): nur die relative Abweichung, weil H verschieden definiert wird.</translation>
    </message>
    <message>
        <source>Choice: half to twice the scenario&apos;s 0.08 mm. No stiffness of the lining under an array is published.</source>
        <translation>Wahl: das Halbe bis Doppelte der 0,08 mm des Szenarios. Eine Steifigkeit der Auskleidung unter einem Träger ist nicht veröffentlicht.</translation>
    </message>
    <message>
        <source>Reported point stiffnesses, 0.6 to 9 N/m, as in the scenario.</source>
        <translation>Berichtete Punktsteifigkeiten, 0,6 bis 9 N/m, wie im Szenario.</translation>
    </message>
    <message>
        <source>see each range</source>
        <translation>siehe jeden Bereich</translation>
    </message>
    <message>
        <source>Majdani 2010, Acta Otolaryngol 130:31: Contour Advance class, stylet held back, 3-D model, 26 insertions by surgeons, mean 0.004 ± 0.001 N</source>
        <translation>Majdani 2010, Acta Otolaryngol 130:31: Klasse Contour Advance, Stilett zurückgehalten, 3-D-Modell, 26 Insertionen durch Chirurgen, Mittel 0,004 ± 0,001 N</translation>
    </message>
    <message>
        <source>Majdani 2010, Acta Otolaryngol 130:31: the same, 8 insertions by a robot, mean 0.005 ± 0.014 N</source>
        <translation>Majdani 2010, Acta Otolaryngol 130:31: dasselbe, 8 Insertionen durch einen Roboter, Mittel 0,005 ± 0,014 N</translation>
    </message>
    <message>
        <source>Mirsalehi 2017, Eur Arch Otorhinolaryngol: 10 temporal bones, by hand, mean 0.003 ± 0.005 N</source>
        <translation>Mirsalehi 2017, Eur Arch Otorhinolaryngol: 10 Felsenbeine, von Hand, Mittel 0,003 ± 0,005 N</translation>
    </message>
    <message>
        <source>Published experiment: Nucleus 24 Contour, 2 mm/s, soap</source>
        <translation>Veröffentlichter Versuch: Nucleus 24 Contour, 2 mm/s, Seife</translation>
    </message>
    <message>
        <source>Mean scala tympani: Nucleus 24 Contour, 2 mm/s, soap</source>
        <translation>Mittlere Scala tympani: Nucleus 24 Contour, 2 mm/s, Seife</translation>
    </message>
    <message>
        <source>Mean scala tympani: FLEX28, 0.5 mm/s, soap 10 %</source>
        <translation>Mittlere Scala tympani: FLEX28, 0,5 mm/s, Seife 10 %</translation>
    </message>
    <message>
        <source>Array length and cochlear size</source>
        <translation>Länge des Trägers und Größe der Cochlea</translation>
    </message>
    <message>
        <source>Choice: the tweezers hold 3 mm behind the greatest depth.</source>
        <translation>Wahl: Die Pinzette greift 3 mm hinter der größten Tiefe.</translation>
    </message>
    <message>
        <source>18.5 mm: general literature; contacts 3 to 18 mm deep as listed in public research code.</source>
        <translation>18,5 mm: allgemeine Literatur; Kontakte in 3 bis 18 mm Tiefe laut öffentlichem Forschungscode.</translation>
    </message>
    <message>
        <source>Tip 0.5 mm, base 0.7 mm: general literature, not measured. Between them a straight line, a choice.</source>
        <translation>Spitze 0,5 mm, Basis 0,7 mm: allgemeine Literatur, nicht gemessen. Dazwischen eine Gerade (Wahl).</translation>
    </message>
    <message>
        <source>Estimate by the model of plugins/README.md: silicone of 2 MPa and N(s) platinum-iridium wires of 25 um, one for each contact nearer to the tip, EI = E_s I + E_w I_w (N + c N^2) with c = 1.2. Order of the published moduli of a straight array (Kha et al. 2004).</source>
        <translation>Schätzung nach dem Modell in plugins/README.md: Silikon mit 2 MPa und N(s) Platin-Iridium-Drähte von 25 µm, einer je Kontakt näher an der Spitze, EI = E_s I + E_w I_w (N + c N^2) mit c = 1,2. Größenordnung der veröffentlichten Moduln eines geraden Trägers (Kha et al. 2004).</translation>
    </message>
    <message>
        <source>Estimate: a curl that holds the array in the middle of the scala, wider than that of a perimodiolar array: radius 3.3 mm behind, 1.8 mm near the tip; the tip and what lies behind the active part are straight: choices.</source>
        <translation>Schätzung: eine Krümmung, die den Träger in der Mitte der Skala hält, weiter als bei einem perimodiolaren Träger: Radius 3,3 mm hinten, 1,8 mm nahe der Spitze; Spitze und Bereich hinter dem aktiven Teil gerade (Wahl).</translation>
    </message>
    <message>
        <source>EI = E pi d^4 / 64 of a platinum wire, E = 168 GPa, d = 0.11 mm, as estimated for the Contour. Where it ends and the hold depth, about the straight stretch from the round window to the outer wall of the basal turn, are choices.</source>
        <translation>EI = E pi d^4 / 64 eines Platindrahts, E = 168 GPa, d = 0,11 mm, wie für den Contour geschätzt. Sein Ende und die Haltetiefe, etwa die gerade Strecke vom runden Fenster zur Außenwand der basalen Windung, sind Wahl.</translation>
    </message>
    <message>
        <source>23 mm: general literature, not measured.</source>
        <translation>23 mm: allgemeine Literatur, nicht gemessen.</translation>
    </message>
    <message>
        <source>Tip 0.25 mm, base 0.7 mm: general literature, not measured. Between them a straight line, a choice.</source>
        <translation>Spitze 0,25 mm, Basis 0,7 mm: allgemeine Literatur, nicht gemessen. Dazwischen eine Gerade (Wahl).</translation>
    </message>
    <message>
        <source>Array of 18 to 19 mm, as listed in public research code; its most apical contact lies 18 mm deep there, 1 mm behind the tip.</source>
        <translation>Träger von 18 bis 19 mm laut öffentlichem Forschungscode; der apikalste Kontakt liegt dort 18 mm tief, 1 mm hinter der Spitze.</translation>
    </message>
    <message>
        <source>Tip 0.5 mm and base 0.8 mm as the Contour: general literature, not measured. Between them the Contour&apos;s quarter sine, a choice.</source>
        <translation>Spitze 0,5 mm und Basis 0,8 mm wie beim Contour: allgemeine Literatur, nicht gemessen. Dazwischen die Viertelsinuskurve des Contour (Wahl).</translation>
    </message>
    <message>
        <source>Estimate: 1.1 times the curvature of implanted arrays, from the mean angles between neighboring contacts (Landsberger et al. 2015, as tabulated in public research code) and the pitch below: a carrier that hugs the modiolus curls at least as tightly when free. The tip and what lies behind the active part are straight: choices.</source>
        <translation>Schätzung: das 1,1-Fache der Krümmung implantierter Träger aus den mittleren Winkeln zwischen benachbarten Kontakten (Landsberger et al. 2015, Tabelle in öffentlichem Forschungscode) und dem Abstand unten: Ein Träger, der am Modiolus anliegt, krümmt sich frei mindestens so eng. Spitze und Bereich hinter dem aktiven Teil gerade (Wahl).</translation>
    </message>
    <message>
        <source>Three marker ribs at the end of the array: general literature; that the last is at the opening at full depth, their distance of 1 mm, height and length are choices.</source>
        <translation>Drei Markierungsrippen am Ende des Trägers: allgemeine Literatur; dass die letzte bei voller Tiefe an der Öffnung liegt, ihr Abstand von 1 mm, Höhe und Länge sind Wahl.</translation>
    </message>
    <message>
        <source>EI = E pi d^4 / 64 of a platinum wire, E = 168 GPa, d = 0.11 mm, as estimated for the Contour. It ends 1.2 mm behind the tip, before the soft tip: a choice. Hold depth: a choice of the length of the straight stretch from the round window to the outer wall of the basal turn.</source>
        <translation>EI = E pi d^4 / 64 eines Platindrahts, E = 168 GPa, d = 0,11 mm, wie für den Contour geschätzt. Er endet 1,2 mm hinter der Spitze, vor der weichen Spitze (Wahl). Haltetiefe: gewählt als Länge der geraden Strecke vom runden Fenster zur Außenwand der basalen Windung.</translation>
    </message>
    <message>
        <source>Todd and Naghdy, Real-time haptic modeling and simulation for prosthetic insertion: greatest depth 22 mm.</source>
        <translation>Todd und Naghdy, Real-time haptic modeling and simulation for prosthetic insertion: größte Tiefe 22 mm.</translation>
    </message>
    <message>
        <source>Tip: Todd and Naghdy, radius 0.25 mm as measured. Base 0.8 mm: general literature, not measured. Between them a quarter sine, a choice.</source>
        <translation>Spitze: Todd und Naghdy, Radius 0,25 mm, gemessen. Basis 0,8 mm: allgemeine Literatur, nicht gemessen. Dazwischen eine Viertelsinuskurve (Wahl).</translation>
    </message>
    <message>
        <source>Estimate: 0.2e-6 to 2e-6, growing tenfold from tip to base by exp(2.3 s / 25 mm), chosen for the order of the published insertion forces. Physical bounds 0.2e-6 to 3e-6 N m2, from moduli of the order reported for a straight array (Kha et al. 2004) and a diameter of 0.4 to 0.6 mm.</source>
        <translation>Schätzung: 0,2e-6 bis 2e-6, von der Spitze zur Basis auf das Zehnfache wachsend nach exp(2,3 s / 25 mm), gewählt nach der Größenordnung der veröffentlichten Insertionskräfte. Physikalische Grenzen 0,2e-6 bis 3e-6 N m2 aus Moduln der für einen geraden Träger berichteten Größenordnung (Kha et al. 2004) und einem Durchmesser von 0,4 bis 0,6 mm.</translation>
    </message>
    <message>
        <source>Estimate: a perimodiolar curl of radius 2.5 mm that closes to 1.5 mm near the tip; the tip itself and what lies behind the active part are straight.</source>
        <translation>Schätzung: eine perimodiolare Krümmung mit Radius 2,5 mm, die sich nahe der Spitze auf 1,5 mm schließt; die Spitze selbst und der Bereich hinter dem aktiven Teil sind gerade.</translation>
    </message>
    <message>
        <source>Todd and Naghdy: the second rib is at the opening at full insertion, 16.5 mm of travel after a start 1 to 3 mm inside, so it touches 17.5 to 19.5 mm from the tip; with the latest start of the validation, 2.3 mm, at 18.8 mm, its middle 0.2 mm behind. The first rib touches where the forces rise between 12.6 and 14.6 mm of travel: 16.4 to 17.5 mm from the tip. Height above the carrier: chosen such that entering a passage 1 mm wide takes the 81 mN by which the raw record rises at the first rib; length along it: a choice. Low confidence.</source>
        <translation>Todd und Naghdy: Die zweite Rippe liegt bei voller Insertion an der Öffnung, 16,5 mm Vorschub nach einem Beginn 1 bis 3 mm innen; sie berührt also 17,5 bis 19,5 mm hinter der Spitze; beim spätesten Beginn der Validierung, 2,3 mm, bei 18,8 mm, ihre Mitte 0,2 mm dahinter. Die erste Rippe berührt, wo die Kräfte zwischen 12,6 und 14,6 mm Vorschub steigen: 16,4 bis 17,5 mm hinter der Spitze. Höhe über dem Träger: so gewählt, dass der Eintritt in einen 1 mm weiten Kanal die 81 mN braucht, um die die Rohaufzeichnung an der ersten Rippe steigt; Länge: Wahl. Geringe Konfidenz.</translation>
    </message>
    <message>
        <source>EI = E pi d^4 / 64 of a platinum wire, E = 168 GPa, d = 0.11 mm (estimate; 0.10 to 0.15 mm gives 0.82e-6 to 4.2e-6). That the carrier is straight where it is, is a choice; the published experiment saw a slight curvature. That it ends 2 mm behind the tip is a choice made with a look at the experiment: with 0.8 mm the peak at the basal turn comes 1 mm earlier and stands higher; the forces behind it hardly depend on it. Hold depth: a choice, about the straight stretch from the round window to the outer wall of the basal turn; the published experiment used the standard technique.</source>
        <translation>EI = E pi d^4 / 64 eines Platindrahts, E = 168 GPa, d = 0,11 mm (Schätzung; 0,10 bis 0,15 mm ergeben 0,82e-6 bis 4,2e-6). Dass der Träger dort gerade ist, ist Wahl; im veröffentlichten Experiment war er leicht gekrümmt. Dass er 2 mm hinter der Spitze endet, wurde mit Blick auf das Experiment gewählt: Mit 0,8 mm kommt das Maximum an der basalen Windung 1 mm früher und ist höher; die Kräfte danach hängen kaum davon ab. Haltetiefe: Wahl, etwa die gerade Strecke vom runden Fenster zur Außenwand der basalen Windung; das veröffentlichte Experiment verwendete die Standardtechnik.</translation>
    </message>
    <message>
        <source>16 mm, as listed in public research code.</source>
        <translation>16 mm laut öffentlichem Forschungscode.</translation>
    </message>
    <message>
        <source>Tip 0.25 by 0.35 mm, base 0.40 by 0.55 mm: general literature, not measured. That the smaller one lies within the plane of curl, and the straight line between, are choices.</source>
        <translation>Spitze 0,25 × 0,35 mm, Basis 0,40 × 0,55 mm: allgemeine Literatur, nicht gemessen. Dass das kleinere Maß in der Krümmungsebene liegt und die Gerade dazwischen sind Wahl.</translation>
    </message>
    <message>
        <source>25 mm, as listed in public research code.</source>
        <translation>25 mm laut öffentlichem Forschungscode.</translation>
    </message>
    <message>
        <source>Tip 0.4 mm, base 0.6 mm: general literature, not measured. Between them a straight line over the contacts, a choice.</source>
        <translation>Spitze 0,4 mm, Basis 0,6 mm: allgemeine Literatur, nicht gemessen. Dazwischen eine Gerade über die Kontakte (Wahl).</translation>
    </message>
    <message>
        <source>17 to 18 mm: general literature; its most apical contact lies 17 mm deep as listed in public research code, 1 mm behind the tip.</source>
        <translation>17 bis 18 mm: allgemeine Literatur; der apikalste Kontakt liegt laut öffentlichem Forschungscode 17 mm tief, 1 mm hinter der Spitze.</translation>
    </message>
    <message>
        <source>Tip 0.35 by 0.40 mm, base 0.475 by 0.50 mm: general literature, not measured. That the smaller one lies within the plane of curl, and the straight line between tip and base, are choices.</source>
        <translation>Spitze 0,35 × 0,40 mm, Basis 0,475 × 0,50 mm: allgemeine Literatur, nicht gemessen. Dass das kleinere Maß in der Krümmungsebene liegt und die Gerade zwischen Spitze und Basis sind Wahl.</translation>
    </message>
    <message>
        <source>Estimate: a perimodiolar curl of radius 3.0 mm behind that closes to 1.1 mm near the tip, at least as tight as implanted perimodiolar arrays (angles of contacts in Landsberger et al. 2015); the tip and what lies behind the active part are straight: choices.</source>
        <translation>Schätzung: eine perimodiolare Krümmung mit Radius 3,0 mm hinten, die sich nahe der Spitze auf 1,1 mm schließt, mindestens so eng wie implantierte perimodiolare Träger (Kontaktwinkel in Landsberger et al. 2015); Spitze und Bereich hinter dem aktiven Teil gerade (Wahl).</translation>
    </message>
    <message>
        <source>EI = E pi (D^4 - d^4) / 64 of a polyimide tube, E = 2.5 GPa, 0.72 mm outside and 0.60 mm inside: an estimate. It reaches 5 mm past the opening, where the basal turn begins, and is held there: a choice.</source>
        <translation>EI = E pi (D^4 - d^4) / 64 eines Polyimidrohrs, E = 2,5 GPa, außen 0,72 mm, innen 0,60 mm (Schätzung). Es reicht 5 mm hinter die Öffnung, wo die basale Windung beginnt, und wird dort gehalten (Wahl).</translation>
    </message>
    <message>
        <source>20 to 25 mm: 25 mm possible, 20 mm recommended, as reported in clinical studies of the CI422.</source>
        <translation>20 bis 25 mm: 25 mm möglich, 20 mm empfohlen, berichtet in klinischen Studien zum CI422.</translation>
    </message>
    <message>
        <source>Tip 0.3 mm, base 0.6 mm: reported in clinical studies of the CI422. Between them a straight line over 20 mm, a choice.</source>
        <translation>Spitze 0,3 mm, Basis 0,6 mm: berichtet in klinischen Studien zum CI422. Dazwischen eine Gerade über 20 mm (Wahl).</translation>
    </message>
    <message>
        <source>20 mm: reported in clinical studies of the device.</source>
        <translation>20 mm: berichtet in klinischen Studien zum Gerät.</translation>
    </message>
    <message>
        <source>Tip 0.5 by 0.3 mm, base 0.8 mm: general literature, not measured. That the smaller one lies within the plane of curl, and the straight line to a round base, are choices.</source>
        <translation>Spitze 0,5 × 0,3 mm, Basis 0,8 mm: allgemeine Literatur, nicht gemessen. Dass das kleinere Maß in der Krümmungsebene liegt und die Gerade zu einer runden Basis sind Wahl.</translation>
    </message>
    <message>
        <source>Estimate by the model of plugins/README.md: silicone of 2 MPa and N(s) platinum-iridium wires of 25 um, one for each contact nearer to the tip, EI = E_s I + E_w I_w (N + c N^2) with c = 0.06, where the others have 1.2: a waved wire stretches by straightening. Below the published moduli of a straight array (Kha et al. 2004), whose wires are straight.</source>
        <translation>Schätzung nach dem Modell in plugins/README.md: Silikon mit 2 MPa und N(s) Platin-Iridium-Drähte von 25 µm, einer je Kontakt näher an der Spitze, EI = E_s I + E_w I_w (N + c N^2) mit c = 0,06, wo die anderen 1,2 haben: Ein gewellter Draht dehnt sich, indem er sich streckt. Unter den veröffentlichten Moduln eines geraden Trägers (Kha et al. 2004), dessen Drähte gerade sind.</translation>
    </message>
    <message>
        <source>24 mm: reported in clinical studies of the device.</source>
        <translation>24 mm: berichtet in klinischen Studien zum Gerät.</translation>
    </message>
    <message>
        <source>26 mm: reported in clinical studies of the device.</source>
        <translation>26 mm: berichtet in klinischen Studien zum Gerät.</translation>
    </message>
    <message>
        <source>28 mm: reported in clinical studies of the device.</source>
        <translation>28 mm: berichtet in klinischen Studien zum Gerät.</translation>
    </message>
    <message>
        <source>Tip 0.5 by 0.4 mm, base 0.8 mm: general literature, not measured. That the smaller one lies within the plane of curl, and the straight line to a round base, are choices.</source>
        <translation>Spitze 0,5 × 0,4 mm, Basis 0,8 mm: allgemeine Literatur, nicht gemessen. Dass das kleinere Maß in der Krümmungsebene liegt und die Gerade zu einer runden Basis sind Wahl.</translation>
    </message>
    <message>
        <source>31.5 mm: reported in clinical studies of the device.</source>
        <translation>31,5 mm: berichtet in klinischen Studien zum Gerät.</translation>
    </message>
    <message>
        <source>Tip 0.5 by 0.4 mm, base 1.3 mm: general literature, not measured. That the smaller one lies within the plane of curl, and the straight line to a round base, are choices.</source>
        <translation>Spitze 0,5 × 0,4 mm, Basis 1,3 mm: allgemeine Literatur, nicht gemessen. Dass das kleinere Maß in der Krümmungsebene liegt und die Gerade zu einer runden Basis sind Wahl.</translation>
    </message>
    <message>
        <source>15 mm: reported in clinical studies of the device.</source>
        <translation>15 mm: berichtet in klinischen Studien zum Gerät.</translation>
    </message>
    <message>
        <source>24 mm: general literature, not measured.</source>
        <translation>24 mm: allgemeine Literatur, nicht gemessen.</translation>
    </message>
    <message>
        <source>Tip 0.5 mm, base 0.8 mm: general literature, not measured. Between them a straight line, a choice.</source>
        <translation>Spitze 0,5 mm, Basis 0,8 mm: allgemeine Literatur, nicht gemessen. Dazwischen eine Gerade (Wahl).</translation>
    </message>
    <message>
        <source>About 31 to 31.5 mm: reported in clinical studies of the device.</source>
        <translation>Etwa 31 bis 31,5 mm: berichtet in klinischen Studien zum Gerät.</translation>
    </message>
    <message>
        <source>Tip 0.5 mm, base 1.3 mm: general literature, not measured. Between them a straight line, a choice.</source>
        <translation>Spitze 0,5 mm, Basis 1,3 mm: allgemeine Literatur, nicht gemessen. Dazwischen eine Gerade (Wahl).</translation>
    </message>
    <message>
        <source>25 mm: general literature, not measured.</source>
        <translation>25 mm: allgemeine Literatur, nicht gemessen.</translation>
    </message>
    <message>
        <source>Tip 0.4 mm, base 0.5 mm: general literature, not measured. Between them a straight line, a choice.</source>
        <translation>Spitze 0,4 mm, Basis 0,5 mm: allgemeine Literatur, nicht gemessen. Dazwischen eine Gerade (Wahl).</translation>
    </message>
    <message>
        <source>20 contacts, pitch 1.2 mm (24 mm with the last pitch counted): general literature, not measured. The first contact&apos;s place and the contact&apos;s length are choices.</source>
        <translation>20 Kontakte, Abstand 1,2 mm (24 mm mit dem letzten Abstand): allgemeine Literatur, nicht gemessen. Lage des ersten Kontakts und Kontaktlänge sind Wahl.</translation>
    </message>
    <message>
        <source>%1 mm, %2 standard deviations %3 the mean of %4 mm (SD %5, n = 138, Pietsch et al. 2017)</source>
        <translation>%1 mm, %2 Standardabweichungen %3 dem Mittel von %4 mm (SD %5, n = 138, Pietsch et al. 2017)</translation>
    </message>
    <message>
        <source>below</source>
        <translation>unter</translation>
    </message>
    <message>
        <source>above</source>
        <translation>über</translation>
    </message>
    <message>
        <source>Whether middle and apical turn are one cavity (incomplete partition) could not be judged: the modiolus is faint, the CT too coarse or too noisy, or the middle turn not empty. Look for the septum between both turns in a section through the axis, or take a finer series.</source>
        <translation>Ob mittlere und apikale Windung ein Hohlraum sind (inkomplette Partition), war nicht zu beurteilen: Der Modiolus ist schwach, die CT zu grob oder zu verrauscht, oder die mittlere Windung nicht leer. In einem Schnitt durch die Achse das Septum zwischen beiden Windungen suchen oder eine feinere Serie verwenden.</translation>
    </message>
    <message>
        <source>%1 between the landmarks is %2 mm, outside the 95 % interval of the fitted one, %3 to %4 mm. The fitted one is used: check the landmarks in the images.</source>
        <translation>%1 zwischen den Landmarken ist %2 mm, außerhalb des 95-%-Intervalls des angepassten, %3 bis %4 mm. Verwendet wird das angepasste: Die Landmarken in den Bildern prüfen.</translation>
    </message>
    <message>
        <source>angle of the most apical contact of an array that lies along the lateral wall in its whole length</source>
        <translation>Winkel des apikalsten Kontakts eines Trägers, der in ganzer Länge an der lateralen Wand liegt</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; has %2 specimens with a curve in soap; one is needed, whose array stands for all.</source>
        <translation>Der Ordner „%1“ hat %2 Präparate mit einer Kurve in Seife; genau eines wird gebraucht, dessen Elektrodenträger für alle steht.</translation>
    </message>
    <message>
        <source>PTFE, soap</source>
        <translation>PTFE, Seife</translation>
    </message>
    <message>
        <source>PTFE, Healon in air</source>
        <translation>PTFE, Healon in Luft</translation>
    </message>
    <message>
        <source>PTFE, saline and Healon</source>
        <translation>PTFE, Kochsalzlösung und Healon</translation>
    </message>
    <message>
        <source>PTFE, saline</source>
        <translation>PTFE, Kochsalzlösung</translation>
    </message>
    <message>
        <source>PTFE, artificial perilymph</source>
        <translation>PTFE, künstliche Perilymphe</translation>
    </message>
    <message>
        <source>fresh cochlea</source>
        <translation>frische Cochlea</translation>
    </message>
    <message>
        <source>Friction from one array in one channel</source>
        <translation>Reibung aus einem Elektrodenträger in einem Kanal</translation>
    </message>
    <message>
        <source>coefficient of friction</source>
        <translation>Reibungszahl</translation>
    </message>
    <message>
        <source>posterior in steps of a tenth of ln friction</source>
        <translation>A-posteriori-Dichte je Zehntel von ln Reibung</translation>
    </message>
    <message>
        <source>Measured forces from 8 to 14 mm; the method: the guide&apos;s page friction.md.</source>
        <translation>Gemessene Kräfte von 8 bis 14 mm; das Verfahren: Seite friction.md des Handbuchs.</translation>
    </message>
    <message>
        <source>No friction in a living ear is known. The default is an estimate from pig tissue, median %1; 95 % of what is drawn for the simulations lie from %2 to %3. A second inversion of the same curves gives %4. Frictions chosen by name are drawn about their own values.</source>
        <translation>Eine Reibung im lebenden Ohr ist nicht bekannt. Voreingestellt ist eine Schätzung aus Schweinegewebe, Median %1; 95 % dessen, was für die Simulationen gezogen wird, liegen von %2 bis %3. Eine zweite Auswertung derselben Kurven ergibt %4. Namentlich gewählte Reibungen werden um ihre eigenen Werte gezogen.</translation>
    </message>
    <message>
        <source>Estimate from pig tissue</source>
        <translation>Schätzung aus Schweinegewebe</translation>
    </message>
    <message>
        <source>packing of the wires</source>
        <translation>Packung der Drähte</translation>
    </message>
    <message>
        <source>Where the friction&apos;s file states no spread: Dohr et al. 2021, Appl. Sci. 11:5162: 0.59 +- 0.12 and 0.45 +- 0.11, a fifth to a quarter; 0.24 +- 0.13 at 0.1 mm/s is wider.</source>
        <translation>Wo die Datei der Reibung keine Streuung angibt: Dohr et al. 2021, Appl. Sci. 11:5162: 0,59 +- 0,12 und 0,45 +- 0,11, ein Fünftel bis ein Viertel; 0,24 +- 0,13 bei 0,1 mm/s ist breiter.</translation>
    </message>
    <message>
        <source>H is %1 mm, which its error allows to be within %2 to %3 mm, the heights of whole cochleae: %4 mm is used.</source>
        <translation>H ist %1 mm; sein Fehler lässt %2 bis %3 mm zu, die Höhen ganzer Cochleae: Verwendet wird %4 mm.</translation>
    </message>
    <message>
        <source>H is %1 mm, outside %2 to %3 mm, the heights of whole cochleae: it is not used, and plans draw H from the population.</source>
        <translation>H ist %1 mm, außerhalb von %2 bis %3 mm, den Höhen ganzer Cochleae: Es wird nicht verwendet; Pläne nehmen H aus der Population.</translation>
    </message>
    <message>
        <source>%1: %2 is %3, and the file of the array %4 states %5 to %6. Set it within them.</source>
        <translation>%1: %2 ist %3, und die Datei des Trägers %4 nennt %5 bis %6. Wählen Sie einen Wert dazwischen.</translation>
    </message>
    <message>
        <source>%1: %2 is given, and the file of the array %3 has no table [wires]. State its wires there, or leave the key out.</source>
        <translation>%1: %2 ist angegeben, und die Datei des Trägers %3 hat keine Tabelle [wires]. Geben Sie dort seine Drähte an, oder lassen Sie den Schlüssel weg.</translation>
    </message>
    <message>
        <source>%1: %2 is given, and the array %3 has no stylet. Leave the key out.</source>
        <translation>%1: %2 ist angegeben, und der Träger %3 hat kein Stilett. Lassen Sie den Schlüssel weg.</translation>
    </message>
    <message>
        <source>%1: the array %2 yields, and the calibration &apos;%3&apos; was fitted with an elastic one: together they count one softness twice. Set calibration to &quot;&quot;, and stiffness_scale to a value fitted with the yield.</source>
        <translation>%1: Der Träger %2 fließt, und die Kalibrierung &apos;%3&apos; wurde mit einem elastischen angepasst: Zusammen zählen sie dieselbe Nachgiebigkeit doppelt. Setzen Sie calibration auf &quot;&quot; und stiffness_scale auf einen Wert, der mit dem Fließen angepasst ist.</translation>
    </message>
    <message>
        <source>Number, diameter, modulus and c of [bending]. Yield stress: no source was read; the range is recalled for annealed platinum-iridium.</source>
        <translation>Zahl, Durchmesser, Elastizitätsmodul und c von [bending]. Fließspannung: keine Quelle wurde gelesen; der Bereich ist für geglühtes Platin-Iridium erinnert.</translation>
    </message>
    <message>
        <source>grip</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>intended depth</source>
        <translation>beabsichtigte Tiefe</translation>
    </message>
    <message>
        <source>1 simulation</source>
        <translation>1 Simulation</translation>
    </message>
    <message>
        <source>%1 at one friction</source>
        <translation>%1 bei einer Reibung</translation>
    </message>
    <message>
        <source>%1 over friction %2 to %3</source>
        <translation>%1 über Reibung %2 bis %3</translation>
    </message>
    <message>
        <source>%1 at friction %2</source>
        <translation>%1 bei Reibung %2</translation>
    </message>
    <message>
        <source>%1 at friction %2 to %3</source>
        <translation>%1 bei Reibung %2 bis %3</translation>
    </message>
    <message>
        <source>Choice: how deep surgeons mean to push is published for no array. Made after the modeled FLEX24 was seen to have the published 408 degrees where its last contact is inside (21.9 mm), and 479 at its full 24 mm.</source>
        <translation>Festlegung: Wie tief Operateure schieben wollen, ist für keinen Elektrodenträger veröffentlicht. Getroffen, nachdem bekannt war, dass der modellierte FLEX24 die veröffentlichten 408 Grad hat, wo sein letzter Kontakt innen ist (21,9 mm), und 479 bei seinen vollen 24 mm.</translation>
    </message>
    <message>
        <source>Only %1 of %2 repetitions can be fitted; a comparison needs at least %3. Widen the ranges or ask for more draws.</source>
        <translation>Nur %1 von %2 Wiederholungen lassen sich anpassen; ein Vergleich braucht mindestens %3. Erweitern Sie die Bereiche, oder verlangen Sie mehr Simulationen.</translation>
    </message>
    <message>
        <source>The reference &apos;%1&apos; has no force at %2 mm, or does not say of how many.</source>
        <translation>Die Referenz &apos;%1&apos; hat keine Kraft bei %2 mm oder nennt die Zahl der Insertionen nicht.</translation>
    </message>
    <message>
        <source>A record gave too few samples for its spline.</source>
        <translation>Eine Aufzeichnung hat zu wenige Messwerte für ihren Spline.</translation>
    </message>
    <message>
        <source>The reference &apos;%1&apos; has no force to fit.</source>
        <translation>Die Referenz &apos;%1&apos; hat keine Kraft, an die angepasst werden kann.</translation>
    </message>
    <message>
        <source>rib %1 at the opening</source>
        <translation>Rippe %1 an der Öffnung</translation>
    </message>
    <message>
        <source>%1, mean ± SD, n = %2</source>
        <translation>%1, Mittelwert ± SD, n = %2</translation>
    </message>
    <message>
        <source>insertion depth, mm</source>
        <translation>Insertionstiefe, mm</translation>
    </message>
    <message>
        <source>tip angle, °</source>
        <translation>Winkel der Spitze, °</translation>
    </message>
    <message>
        <source>Recorded insertions: insertion force</source>
        <translation>Aufgezeichnete Insertionen: Insertionskraft</translation>
    </message>
    <message>
        <source>peak insertion force</source>
        <translation>maximale Insertionskraft</translation>
    </message>
    <message>
        <source>peak without ribs at the opening</source>
        <translation>Maximum ohne Rippen an der Öffnung</translation>
    </message>
    <message>
        <source>end force</source>
        <translation>Endkraft</translation>
    </message>
    <message>
        <source>insertion work</source>
        <translation>Insertionsarbeit</translation>
    </message>
    <message>
        <source>insertion depth at the end</source>
        <translation>Insertionstiefe am Ende</translation>
    </message>
    <message>
        <source>tip angle</source>
        <translation>Winkel der Spitze</translation>
    </message>
    <message>
        <source>score</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>first palpable resistance</source>
        <translation>erster fühlbarer Widerstand</translation>
    </message>
    <message>
        <source>stylet withdrawal begins</source>
        <translation>Beginn des Stilettrückzugs</translation>
    </message>
    <message>
        <source>rupture of the partition</source>
        <translation>Ruptur der Trennwand</translation>
    </message>
    <message>
        <source>translocation</source>
        <translation>Translokation</translation>
    </message>
    <message>
        <source>stopped by resistance</source>
        <translation>durch Widerstand gestoppt</translation>
    </message>
    <message>
        <source>out of the opening</source>
        <translation>aus der Öffnung</translation>
    </message>
    <message>
        <source>tip fold-over</source>
        <translation>Umschlagen der Spitze</translation>
    </message>
    <message>
        <source>end of the insertion</source>
        <translation>Ende der Insertion</translation>
    </message>
    <message>
        <source>withdrawal begins</source>
        <translation>Beginn des Rückzugs</translation>
    </message>
    <message>
        <source>full score at 0, half at 18.6</source>
        <translation>volle Punkte bei 0, die Hälfte bei 18,6</translation>
    </message>
    <message>
        <source>without ribs at the opening: full score at 0 mN, half at %1 mN, the middle of the peaks in patients</source>
        <translation>ohne Rippen an der Öffnung: volle Punkte bei 0 mN, die Hälfte bei %1 mN, der Mitte der Maximalkräfte bei Patienten</translation>
    </message>
    <message>
        <source>full score at 0 %, half at 15.7 %</source>
        <translation>volle Punkte bei 0 %, die Hälfte bei 15,7 %</translation>
    </message>
    <message>
        <source>taper of the array</source>
        <translation>Verjüngung des Trägers</translation>
    </message>
    <message>
        <source>The recording stopped: %1.</source>
        <translation>Die Aufzeichnung hat angehalten: %1.</translation>
    </message>
    <message>
        <source>The recording could not be closed: %1.</source>
        <translation>Die Aufzeichnung ließ sich nicht schließen: %1.</translation>
    </message>
    <message>
        <source>No drawing was read. At its most basal contact the array is at least as thick as the base of FLEX28, 0.8 mm, which holds the same 12 wires, and at most as its own base, 1.3 mm; the straight line has 1.2 mm there. Uniform. The silicone is that of [bending].</source>
        <translation>Es wurde keine Zeichnung gelesen. Am basalsten Kontakt ist der Träger mindestens so dick wie die Basis des FLEX28, 0,8 mm, die dieselben 12 Drähte enthält, und höchstens so dick wie seine eigene Basis, 1,3 mm; die Gerade hat dort 1,2 mm. Gleichverteilt. Das Silikon ist das von [bending].</translation>
    </message>
    <message>
        <source>insertion</source>
        <translation>Insertion</translation>
    </message>
    <message>
        <source>not known, because the scenario can no longer be read</source>
        <translation>nicht bekannt, weil das Szenario nicht mehr gelesen werden kann</translation>
    </message>
    <message>
        <source>%1 of %2 mm</source>
        <translation>%1 von %2 mm</translation>
    </message>
    <message>
        <source>travel that the scenario sets</source>
        <translation>Vorschub, den das Szenario vorgibt</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
    <message>
        <source>simulated, at the median friction</source>
        <translation>simuliert, bei der mittleren Reibung</translation>
    </message>
    <message>
        <source>clinics report</source>
        <translation>Kliniken berichten</translation>
    </message>
    <message>
        <source>The report would replace %1, a file of the CT. Give the report another name.</source>
        <translation>Der Bericht würde %1 ersetzen, eine Datei des CT. Bitte einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>No temporary folder can be made for the report. Check the space on the disk.</source>
        <translation>Für den Bericht lässt sich kein temporärer Ordner anlegen. Bitte den freien Speicherplatz prüfen.</translation>
    </message>
    <message>
        <source>The report states no CT series for which a seal vouches, so it cannot be compared with %1. Save it without a CT.</source>
        <translation>Der Bericht nennt keine CT-Serie, für die ein Siegel bürgt, und lässt sich daher nicht mit %1 vergleichen. Bitte ohne CT speichern.</translation>
    </message>
    <message>
        <source>Schuster et al. 2015, Otol Neurotol 36:657: fresh human cochlear partition, mean 88 mN (assumption: original not available); force normal to the partition, not the insertion force</source>
        <translation>Schuster et al. 2015, Otol Neurotol 36:657: frische menschliche cochleäre Trennwand, Mittel 88 mN (Annahme: Original nicht verfügbar); Kraft senkrecht zur Trennwand, nicht die Insertionskraft</translation>
    </message>
    <message>
        <source>The DICOM dictionary of DCMTK is not there, so no server can be asked. Install the package of libdcmtk again; DCMDICTPATH must not be set.</source>
        <translation>Das DICOM-Wörterbuch von DCMTK fehlt, so dass kein Server gefragt werden kann. Installieren Sie das Paket libdcmtk noch einmal; DCMDICTPATH darf nicht gesetzt sein.</translation>
    </message>
    <message>
        <source>Port %1 of this machine cannot be listened at: %2. End what uses it, or enter another own port, which the archive must know.</source>
        <translation>An Port %1 dieses Rechners kann nicht gelauscht werden: %2. Beenden Sie, was ihn benutzt, oder geben Sie einen anderen eigenen Port an, den das Archiv kennen muss.</translation>
    </message>
    <message>
        <source>%1 offers none of the services that this needs. Ask its administrator to enable them for %2.</source>
        <translation>%1 bietet keinen der Dienste an, die dafür nötig sind. Bitten Sie den Administrator, sie für %2 freizugeben.</translation>
    </message>
    <message>
        <source>%1 does not offer %2 to %3. Ask its administrator to enable it.</source>
        <translation>%1 bietet %3 dies nicht an: %2. Bitten Sie den Administrator, es freizugeben.</translation>
    </message>
    <message>
        <source>%1: no machine of this name is known. Check the host.</source>
        <translation>%1: Kein Rechner dieses Namens ist bekannt. Prüfen Sie den Host.</translation>
    </message>
    <message>
        <source>%1 cannot be reached: %2. Check host and port, that the server runs, and that no firewall is between.</source>
        <translation>%1 ist nicht erreichbar: %2. Prüfen Sie Host und Port, ob der Server läuft und ob keine Firewall dazwischen ist.</translation>
    </message>
    <message>
        <source>%1: TLS failed: %2. Check that the server speaks TLS at this port, and the files of certificates.</source>
        <translation>%1: TLS ist fehlgeschlagen: %2. Prüfen Sie, ob der Server an diesem Port TLS spricht, und die Dateien der Zertifikate.</translation>
    </message>
    <message>
        <source>%1 accepted the connection but no association within %2 s. Check that a DICOM server is at this port.</source>
        <translation>%1 hat die Verbindung angenommen, aber innerhalb von %2 s keine Assoziation. Prüfen Sie, ob an diesem Port ein DICOM-Server ist.</translation>
    </message>
    <message>
        <source>%1 closed the connection before it agreed on an association. Check that a DICOM server is at this port, and whether it demands TLS.</source>
        <translation>%1 hat die Verbindung geschlossen, bevor eine Assoziation bestand. Prüfen Sie, ob an diesem Port ein DICOM-Server ist und ob er TLS verlangt.</translation>
    </message>
    <message>
        <source>%1: no association: %2.</source>
        <translation>%1: keine Assoziation: %2.</translation>
    </message>
    <message>
        <source>%1 is not called %2: it does not know this AE title. Check the server&apos;s AE title.</source>
        <translation>%1 heißt nicht %2: Er kennt diesen AE-Titel nicht. Prüfen Sie den AE-Titel des Servers.</translation>
    </message>
    <message>
        <source>%1 does not know this workstation as %2. Ask its administrator to enter this AE title with the address of this machine.</source>
        <translation>%1 kennt diese Workstation nicht als %2. Bitten Sie den Administrator, diesen AE-Titel mit der Adresse dieses Rechners einzutragen.</translation>
    </message>
    <message>
        <source>%1 has too many connections. Try again later.</source>
        <translation>%1 hat zu viele Verbindungen. Versuchen Sie es später noch einmal.</translation>
    </message>
    <message>
        <source>%1 refused the association without a reason. Ask its administrator whether %2 is allowed.</source>
        <translation>%1 hat die Assoziation ohne Begründung abgelehnt. Fragen Sie den Administrator, ob %2 erlaubt ist.</translation>
    </message>
    <message>
        <source>The exchange with %1 was canceled.</source>
        <translation>Der Austausch mit %1 wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 sent less than 64 KiB in %2 s. Try again when the network is faster.</source>
        <translation>%1 hat in %2 s weniger als 64 KiB gesendet. Versuchen Sie es noch einmal, wenn das Netz schneller ist.</translation>
    </message>
    <message>
        <source>%1 sent more bytes than a CT of a temporal bone has. Choose another series.</source>
        <translation>%1 hat mehr Bytes gesendet, als ein CT eines Felsenbeins hat. Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>%1 did not answer within %2 s. Try again; ask its administrator if it stays so.</source>
        <translation>%1 hat innerhalb von %2 s nicht geantwortet. Versuchen Sie es noch einmal; fragen Sie den Administrator, wenn es so bleibt.</translation>
    </message>
    <message>
        <source>%1 ended the connection in the middle of an answer. Try again.</source>
        <translation>%1 hat die Verbindung mitten in einer Antwort beendet. Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The exchange with %1 failed: %2.</source>
        <translation>Der Austausch mit %1 ist fehlgeschlagen: %2.</translation>
    </message>
    <message>
        <source>%1 refused the request: %2 (status %3).</source>
        <translation>%1 hat die Anfrage abgelehnt: %2 (Status %3).</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The series %1 has more than %2 images, which is no CT of a temporal bone. Choose another series.</source>
        <translation>Die Serie %1 hat mehr als %2 Bilder und ist kein CT eines Felsenbeins. Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>%1 has no series %2 in the study %3. &apos;perilymph-cli archive find&apos; lists the series of a study.</source>
        <translation>%1 hat keine Serie %2 in der Studie %3. &apos;perilymph-cli archive find&apos; nennt die Serien einer Studie.</translation>
    </message>
    <message>
        <source>retrieval by C-GET</source>
        <translation>Abruf mit C-GET</translation>
    </message>
    <message>
        <source>retrieval by C-MOVE</source>
        <translation>Abruf mit C-MOVE</translation>
    </message>
    <message>
        <source>%1 does not know where %2 is. Ask its administrator to enter this AE title with the address of this machine and port %3.</source>
        <translation>%1 weiß nicht, wo %2 ist. Bitten Sie den Administrator, diesen AE-Titel mit der Adresse dieses Rechners und Port %3 einzutragen.</translation>
    </message>
    <message>
        <source>The images for %1 came from another machine or another AE title than %2, and were refused. Enter the archive&apos;s own AE title and host.</source>
        <translation>Die Bilder für %1 kamen von einem anderen Rechner oder unter einem anderen AE-Titel als %2 und wurden abgelehnt. Geben Sie den eigenen AE-Titel und Host des Archivs an.</translation>
    </message>
    <message>
        <source>%1 Ask its administrator whether %2 is entered with the address of this machine and port %3.</source>
        <translation>%1 Fragen Sie den Administrator, ob %2 mit der Adresse dieses Rechners und Port %3 eingetragen ist.</translation>
    </message>
    <message>
        <source>%1 did not send %2 of the images that it lists. It may hold them in a form that cannot be read here; ask its administrator.</source>
        <translation>%1 hat %2 der Bilder nicht gesendet, die er aufführt. Vielleicht hat er sie in einer Form, die hier nicht gelesen werden kann; fragen Sie den Administrator.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden: %2.</translation>
    </message>
    <message>
        <source>%1 is in the way and is no folder. Move it away.</source>
        <translation>%1 ist im Weg und kein Ordner. Verschieben Sie es.</translation>
    </message>
    <message>
        <source>%1 belongs to somebody else. Choose another place.</source>
        <translation>%1 gehört jemand anderem. Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>%1 exists already. Name a new folder.</source>
        <translation>%1 gibt es schon. Nennen Sie einen neuen Ordner.</translation>
    </message>
    <message>
        <source>%1 %2 of %3 images are in %4: fetch the series again to request the others.</source>
        <translation>%1 %2 von %3 Bildern sind in %4: Holen Sie die Serie noch einmal, um die übrigen anzufordern.</translation>
    </message>
    <message>
        <source>%1 cannot get the name %2: %3.</source>
        <translation>%1 kann den Namen %2 nicht bekommen: %3.</translation>
    </message>
    <message>
        <source>%1 holds more than %2 files. Give the folder of the one CT.</source>
        <translation>%1 enthält mehr als %2 Dateien. Geben Sie den Ordner des einen CT an.</translation>
    </message>
    <message>
        <source>%1 holds no file of the series that was measured. Give the folder of that CT.</source>
        <translation>%1 enthält keine Datei der gemessenen Serie. Geben Sie den Ordner dieses CT an.</translation>
    </message>
    <message>
        <source>A report without measures is not written.</source>
        <translation>Ein Bericht ohne Messwerte wird nicht geschrieben.</translation>
    </message>
    <message>
        <source>The version of a report has at most 64 ASCII letters.</source>
        <translation>Die Version eines Berichts hat höchstens 64 ASCII-Zeichen.</translation>
    </message>
    <message>
        <source>The measures cannot be written as a structured report of %1: %2.</source>
        <translation>Die Messwerte können nicht als strukturierter Bericht zu %1 geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>The %1 of a query has at most 64 bytes of UTF-8 without \ and control characters. Shorten it with *.</source>
        <translation>Bei einer Anfrage hat dies höchstens 64 Bytes UTF-8 ohne \ und Steuerzeichen: %1. Kürzen Sie es mit *.</translation>
    </message>
    <message>
        <source>patient number</source>
        <translation>Patientennummer</translation>
    </message>
    <message>
        <source>patient name</source>
        <translation>Patientenname</translation>
    </message>
    <message>
        <source>A date of a query is no date of the calendar. Write YYYYMMDD, as in 20260131.</source>
        <translation>Ein Datum der Anfrage ist kein Kalenderdatum. Schreiben Sie JJJJMMTT wie in 20260131.</translation>
    </message>
    <message>
        <source>The study dates of the query end before they begin. Exchange them.</source>
        <translation>Der Zeitraum der Anfrage endet, bevor er beginnt. Vertauschen Sie die beiden Daten.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no modality. Write its code, as in CT.</source>
        <translation>&apos;%1&apos; ist keine Modalität. Schreiben Sie deren Code wie in CT.</translation>
    </message>
    <message>
        <source>The query has no condition and would list the whole archive. Give a patient number, a name, a date or a modality.</source>
        <translation>Die Anfrage hat keine Bedingung und würde das ganze Archiv aufführen. Geben Sie Patientennummer, Namen, Datum oder Modalität an.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no UID of a %2: digits and dots, at most 64. Take it from &apos;perilymph-cli archive find&apos;.</source>
        <translation>&apos;%1&apos; ist keine UID (%2): höchstens 64 Ziffern und Punkte. Nehmen Sie sie aus &apos;perilymph-cli archive find&apos;.</translation>
    </message>
    <message>
        <source>queries (C-FIND)</source>
        <translation>Anfragen (C-FIND)</translation>
    </message>
    <message>
        <source>The server sent an object that is no DICOM. Ask its administrator.</source>
        <translation>Der Server hat ein Objekt gesendet, das kein DICOM ist. Fragen Sie den Administrator.</translation>
    </message>
    <message>
        <source>The server sent an object of another series, which was deleted. Ask its administrator.</source>
        <translation>Der Server hat ein Objekt einer anderen Serie gesendet, das gelöscht wurde. Fragen Sie den Administrator.</translation>
    </message>
    <message>
        <source>The server sent an object that it had not listed, which was deleted. Fetch the series again.</source>
        <translation>Der Server hat ein Objekt gesendet, das er nicht aufgeführt hatte und das gelöscht wurde. Holen Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>The server sent objects of several patients under one series, and the last was deleted. Ask its administrator.</source>
        <translation>Der Server hat unter einer Serie Objekte mehrerer Patienten gesendet; das letzte wurde gelöscht. Fragen Sie den Administrator.</translation>
    </message>
    <message>
        <source>A file in %1 could not be written: %2. Free some space, and fetch again.</source>
        <translation>Eine Datei in %1 konnte nicht geschrieben werden: %2. Schaffen Sie Platz und holen Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>%1 is no file of at most 128 MiB. Give a DICOM file that this program wrote.</source>
        <translation>%1 ist keine Datei von höchstens 128 MiB. Geben Sie eine DICOM-Datei an, die dieses Programm geschrieben hat.</translation>
    </message>
    <message>
        <source>%1 is no DICOM file: %2. Give one that this program wrote.</source>
        <translation>%1 ist keine DICOM-Datei: %2. Geben Sie eine an, die dieses Programm geschrieben hat.</translation>
    </message>
    <message>
        <source>%1 is no result of this program: only those are sent. Give a report that it wrote as DICOM.</source>
        <translation>%1 ist kein Ergebnis dieses Programms: Nur solche werden gesendet. Geben Sie einen Bericht an, den es als DICOM geschrieben hat.</translation>
    </message>
    <message>
        <source>object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>%1 has no study %2, of which %3 is a part. Write the report with the CT of the archive&apos;s study, or send it to the archive that has it.</source>
        <translation>%1 hat keine Studie %2, zu der %3 gehört. Schreiben Sie den Bericht mit dem CT aus der Studie des Archivs, oder senden Sie ihn an das Archiv, das sie hat.</translation>
    </message>
    <message>
        <source>%1 has the study %2 under another patient number or birth date than %3 states: nothing was sent. Compare both before you send it again.</source>
        <translation>%1 hat die Studie %2 unter einer anderen Patientennummer oder einem anderen Geburtsdatum, als %3 angibt: Es wurde nichts gesendet. Vergleichen Sie beides, bevor Sie noch einmal senden.</translation>
    </message>
    <message>
        <source>storage of this kind of object</source>
        <translation>Speichern von Objekten dieser Art</translation>
    </message>
    <message>
        <source>The server stored it with a change of its own: %1.</source>
        <translation>Der Server hat es mit einer eigenen Änderung gespeichert: %1.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no AE title: 1 to 16 ASCII letters, digits and signs, without \ and &apos;. Enter the one that the archive&apos;s administrator states.</source>
        <translation>&apos;%1&apos; ist kein AE-Titel: 1 bis 16 ASCII-Buchstaben, Ziffern und Zeichen, ohne \ und &apos;. Geben Sie den an, den der Administrator des Archivs nennt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no absolute path without quotation marks. Enter the whole path of the PEM file.</source>
        <translation>&apos;%1&apos; ist kein absoluter Pfad ohne Anführungszeichen. Geben Sie den ganzen Pfad der PEM-Datei an.</translation>
    </message>
    <message>
        <source>TLS needs the certificate of the authority that signed the server&apos;s. Enter its PEM file.</source>
        <translation>TLS braucht das Zertifikat der Stelle, die das des Servers unterschrieben hat. Geben Sie dessen PEM-Datei an.</translation>
    </message>
    <message>
        <source>A certificate of this workstation and its key belong together. Enter both, or none.</source>
        <translation>Ein Zertifikat dieser Workstation und sein Schlüssel gehören zusammen. Geben Sie beide an oder keines.</translation>
    </message>
    <message>
        <source>%1 is no port; a port is 1 to 65535.</source>
        <translation>%1 ist kein Port; ein Port ist 1 bis 65535.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no name of a server: 1 to 64 letters, without &apos;.</source>
        <translation>&apos;%1&apos; ist kein Name eines Servers: 1 bis 64 Buchstaben, ohne &apos;.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no name or IPv4 address of a machine. Enter one such as pacs.hospital.example or 10.1.2.3.</source>
        <translation>&apos;%1&apos; ist kein Name und keine IPv4-Adresse eines Rechners. Geben Sie etwas wie pacs.hospital.example oder 10.1.2.3 an.</translation>
    </message>
    <message>
        <source>%1 is not changed. %2: %3</source>
        <translation>%1 ist unverändert. %2: %3</translation>
    </message>
    <message>
        <source>%1 is not changed: two servers would be called &apos;%2&apos;. Give each a name of its own.</source>
        <translation>%1 ist unverändert: Zwei Server hießen &apos;%2&apos;. Geben Sie jedem einen eigenen Namen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the name of another server, too. Give each its own.</source>
        <translation>&apos;%1&apos; heißt auch ein anderer Server. Geben Sie jedem einen eigenen Namen.</translation>
    </message>
    <message>
        <source>There is no server &apos;%1&apos;: %2 has none. Add it with &apos;perilymph-cli archive servers --add&apos;.</source>
        <translation>Es gibt keinen Server &apos;%1&apos;: %2 hat keinen. Fügen Sie ihn mit &apos;perilymph-cli archive servers --add&apos; hinzu.</translation>
    </message>
    <message>
        <source>There is no server &apos;%1&apos; in %2. There are: %3.</source>
        <translation>Es gibt keinen Server &apos;%1&apos; in %2. Es gibt: %3.</translation>
    </message>
    <message>
        <source>The file %1 cannot be used for TLS: %2. Check that it is a PEM file of this kind.</source>
        <translation>Die Datei %1 kann nicht für TLS verwendet werden: %2. Prüfen Sie, ob sie eine PEM-Datei dieser Art ist.</translation>
    </message>
    <message>
        <source>The key %1 is not that of the certificate %2. Enter the pair that belongs together.</source>
        <translation>Der Schlüssel %1 ist nicht der des Zertifikats %2. Geben Sie das Paar an, das zusammengehört.</translation>
    </message>
    <message>
        <source>TLS cannot be set up as DICOM&apos;s profile BCP 195 demands: %1.</source>
        <translation>TLS kann nicht so eingerichtet werden, wie es das DICOM-Profil BCP 195 verlangt: %1.</translation>
    </message>
    <message>
        <source>belongs to another plan, or the patient, an array, the scenario, resources/planning/uncertainty.toml, resources/planning/frequency-allocation.toml, resources/clinical/hand.toml, resources/clinical/wires.toml or resources/reference/surgeons.toml was changed since.</source>
        <translation>gehört zu einem anderen Plan, oder der Patient, ein Träger, das Szenario, resources/planning/uncertainty.toml, resources/planning/frequency-allocation.toml, resources/clinical/hand.toml, resources/clinical/wires.toml oder resources/reference/surgeons.toml wurde seitdem geändert.</translation>
    </message>
    <message>
        <source>One range for all makers, none of whom publishes it: 0.06 is derived for waved wires, 1.2 gives packed wires the order of published moduli (Kha et al. 2004); the files take one end or the other. A Slim Straight dummy in a channel with soap has the forces of 0.4 to 0.5 (Salcher et al. 2019). Where it is drawn, the factor of the stiffness has at most the deviation of a medium confidence.</source>
        <translation>Ein Bereich für alle Hersteller, von denen keiner den Wert veröffentlicht: 0,06 ist für gewellte Drähte hergeleitet, 1,2 gibt gepackten Drähten die Größenordnung veröffentlichter Moduln (Kha et al. 2004); die Dateien nehmen das eine oder das andere Ende. Ein Slim-Straight-Muster in einem Kanal mit Seife hat die Kräfte von 0,4 bis 0,5 (Salcher et al. 2019). Wo der Wert gezogen wird, hat der Faktor der Steifigkeit höchstens die Streuung eines mittleren Vertrauens.</translation>
    </message>
    <message>
        <source>The array %1 is named twice. Name it once.</source>
        <translation>Der Träger %1 ist zweimal genannt. Nennen Sie ihn einmal.</translation>
    </message>
    <message>
        <source>Seed %1 is given twice: its cochleae would count double. Give it once.</source>
        <translation>Der Startwert %1 ist zweimal angegeben: Seine Cochleae zählten doppelt. Geben Sie ihn einmal an.</translation>
    </message>
    <message>
        <source>The plan has no simulation %1 of array %2; it has %3 of each of %4 arrays. Choose one of them.</source>
        <translation>Der Plan hat keine Simulation %1 des Trägers %2; er hat %3 von jedem von %4 Trägern. Wählen Sie eine davon.</translation>
    </message>
    <message>
        <source>Can be compared but not replayed: %1</source>
        <translation>Kann verglichen, aber nicht wiedergegeben werden: %1</translation>
    </message>
    <message>
        <source>Empty: the program ended before the insertion began; delete it.</source>
        <translation>Leer: Das Programm endete, bevor die Insertion begann; löschen Sie sie.</translation>
    </message>
    <message>
        <source>Incomplete: the program was interrupted.</source>
        <translation>Unvollständig: Das Programm wurde unterbrochen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no date. Type it as 1970-01-31 or 31.1.1970.</source>
        <translation>&apos;%1&apos; ist kein Datum. Geben Sie es als 1970-01-31 oder 31.1.1970 ein.</translation>
    </message>
    <message>
        <source>Type a patient number, a name, a birth date or a study date: without one the whole archive would be listed.</source>
        <translation>Geben Sie eine Patientennummer, einen Namen, ein Geburtsdatum oder ein Untersuchungsdatum ein: ohne sie würde das ganze Archiv aufgelistet.</translation>
    </message>
    <message>
        <source>No temporary folder can be made for what is sent. Check the space on the disk.</source>
        <translation>Für das, was gesendet wird, kann kein temporärer Ordner angelegt werden. Prüfen Sie den Platz auf der Festplatte.</translation>
    </message>
    <message>
        <source>The sending was canceled.</source>
        <translation>Das Senden wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 of %2 objects were stored, as series %3. Then: %4</source>
        <translation>%1 von %2 Objekten wurden gespeichert, als Serie %3. Dann: %4</translation>
    </message>
    <message>
        <source>Stored in the study of the CT, as series %1. %2</source>
        <translation>In der Studie des CT gespeichert, als Serie %1. %2</translation>
    </message>
    <message>
        <source>Stored in the study of the CT, as series %1.</source>
        <translation>In der Studie des CT gespeichert, als Serie %1.</translation>
    </message>
    <message>
        <source>The report states no CT series for which a seal vouches, so it cannot be filed in the study of a CT. Save it without a CT.</source>
        <translation>Der Bericht nennt keine CT-Serie, für die ein Siegel bürgt, und kann daher nicht in der Studie eines CT abgelegt werden. Speichern Sie ihn ohne CT.</translation>
    </message>
    <message>
        <source>A key image has three bytes for each of its pixels, at most 8192 a side, and a description of at most 1024 ASCII letters.</source>
        <translation>Ein Schlüsselbild hat drei Bytes je Pixel, höchstens 8192 Pixel je Seite und eine Beschreibung aus höchstens 1024 ASCII-Zeichen.</translation>
    </message>
    <message>
        <source>The picture cannot be written as a key image of %1: %2.</source>
        <translation>Das Bild kann nicht als Schlüsselbild von %1 geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>A segmentation is written for a series of one slice a file, and %1 holds another. Save the surface instead.</source>
        <translation>Eine Segmentation wird für eine Serie mit einer Schicht je Datei geschrieben, und %1 enthält eine andere. Speichern Sie stattdessen die Oberfläche.</translation>
    </message>
    <message>
        <source>The slices in %1 differ in size, direction or frame of reference. Save the surface instead.</source>
        <translation>Die Schichten in %1 unterscheiden sich in Größe, Richtung oder Bezugssystem. Speichern Sie stattdessen die Oberfläche.</translation>
    </message>
    <message>
        <source>The series in %1 states no frame of reference, so a segmentation would lie nowhere. Save the surface instead.</source>
        <translation>Die Serie in %1 nennt kein Bezugssystem (Frame of Reference), eine Segmentation läge daher nirgends. Speichern Sie stattdessen die Oberfläche.</translation>
    </message>
    <message>
        <source>A lumen has at least two whole rings of at least three points.</source>
        <translation>Ein Lumen hat mindestens zwei ganze Ringe aus mindestens drei Punkten.</translation>
    </message>
    <message>
        <source>The lumen lies in no slice of %1. Give the folder of the CT that was measured.</source>
        <translation>Das Lumen liegt in keiner Schicht von %1. Geben Sie den Ordner des gemessenen CT an.</translation>
    </message>
    <message>
        <source>The lumen cannot be written as a segmentation of %1: %2.</source>
        <translation>Das Lumen kann nicht als Segmentation von %1 geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>mean speed</source>
        <translation>mittlere Geschwindigkeit</translation>
    </message>
    <message>
        <source>The reference &apos;in-vivo&apos; has no [[range]] of the quantity &apos;peak&apos;.</source>
        <translation>Die Referenz „in-vivo“ hat keine [[range]] der Größe „peak“.</translation>
    </message>
    <message>
        <source>the score counts by this fraction</source>
        <translation>die Bewertung zählt mit diesem Anteil</translation>
    </message>
    <message>
        <source>full score within 0.1–2.0 mm/s, half at twice or half of these, in proportion beyond</source>
        <translation>volle Punkte bei 0,1–2,0 mm/s, die Hälfte beim Doppelten oder der Hälfte davon, außerhalb im Verhältnis</translation>
    </message>
    <message>
        <source>B (b_mm) is %1 mm and A (a_mm) %2 mm; A is the longer of the two. Exchange them or measure again.</source>
        <translation>B (b_mm) ist %1 mm und A (a_mm) %2 mm; A ist das längere von beiden. Vertauschen Sie sie oder messen Sie erneut.</translation>
    </message>
    <message>
        <source>lowest to highest of %1 simulations</source>
        <translation>kleinster bis größter Wert von %1 Simulationen</translation>
    </message>
    <message>
        <source>5 to 95 % of %1 simulations</source>
        <translation>5 bis 95 % von %1 Simulationen</translation>
    </message>
    <message>
        <source>There are no bench curves in &apos;%1&apos;. Give slim-straight, or a folder with a TOML file for each specimen.</source>
        <translation>In „%1“ sind keine Prüfstandkurven. Geben Sie slim-straight an, oder einen Ordner mit einer TOML-Datei je Präparat.</translation>
    </message>
    <message>
        <source>set speed</source>
        <translation>eingestellte Geschwindigkeit</translation>
    </message>
    <message>
        <source>approach</source>
        <translation>Zugang</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>cochlea</source>
        <translation>Cochlea</translation>
    </message>
    <message>
        <source>ending</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>insertion time</source>
        <translation>Insertionsdauer</translation>
    </message>
    <message>
        <source>The sending to %1 was canceled while an object was under way: it may have stored it. Look there before you send it again.</source>
        <translation>Das Senden an %1 wurde abgebrochen, während ein Objekt unterwegs war: es kann dort gespeichert sein. Sehen Sie dort nach, bevor Sie es noch einmal senden.</translation>
    </message>
    <message>
        <source>The registry was canceled.</source>
        <translation>Die Tabelle wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 is left out: its label is no code of letters, digits and hyphens, and may be a name. Give the patient a code.</source>
        <translation>%1 ist ausgelassen: die Bezeichnung ist kein Code aus Buchstaben, Ziffern und Bindestrichen und kann ein Name sein. Geben Sie dem Patienten einen Code.</translation>
    </message>
    <message>
        <source>%1, %2 ear: %3</source>
        <translation>%1, Ohr „%2“: %3</translation>
    </message>
    <message>
        <source>%1: the plan&apos;s simulations cannot be run again as they were made, so that its length tells nothing about resistance.</source>
        <translation>%1: Die Simulationen des Plans lassen sich nicht so wiederholen, wie sie gemacht wurden; seine Länge sagt deshalb nichts über den Widerstand.</translation>
    </message>
    <message>
        <source>The outcomes were canceled.</source>
        <translation>Die Ergebnisse wurden abgebrochen.</translation>
    </message>
    <message>
        <source>%1 is left out: no plan of %2 was made for it before the surgery.</source>
        <translation>%1 ist ausgelassen: Vor der Operation wurde dafür kein Plan mit %2 gemacht.</translation>
    </message>
    <message>
        <source>%1 is left out: %2</source>
        <translation>%1 ist ausgelassen: %2</translation>
    </message>
    <message>
        <source>%1 of %2 is %3; %4 to %5 is allowed. Check the contacts found in the CT.</source>
        <translation>%1 von %2 ist %3; erlaubt ist %4 bis %5. Prüfen Sie die im CT gefundenen Kontakte.</translation>
    </message>
    <message>
        <source>The plan of %1 has no simulation of %2. Plan that array.</source>
        <translation>Der Plan von %1 hat keine Simulation von %2. Planen Sie diesen Träger.</translation>
    </message>
    <message>
        <source>%1 of %2 outcomes are informative about resistance: the shipped resistance stays.</source>
        <translation>%1 von %2 Ergebnissen sagen etwas über den Widerstand: der mitgelieferte Widerstand bleibt.</translation>
    </message>
    <message>
        <source>%1 of %2 outcomes are informative about resistance, %3 ended by it: the clinic&apos;s resistance can be used, its gain in ln p is %4.</source>
        <translation>%1 von %2 Ergebnissen sagen etwas über den Widerstand, %3 endeten durch ihn: der Widerstand der Klinik kann verwendet werden, sein Gewinn an ln p ist %4.</translation>
    </message>
    <message>
        <source>%1 of %2 outcomes are informative about resistance, %3 ended by it; the clinic&apos;s resistance is not offered yet: that needs %4 that ended by it and a gain in ln p of %5, which is %6.</source>
        <translation>%1 von %2 Ergebnissen sagen etwas über den Widerstand, %3 endeten durch ihn; der Widerstand der Klinik wird noch nicht angeboten: dazu müssen %4 durch ihn geendet haben und der Gewinn an ln p mindestens %5 sein; er ist %6.</translation>
    </message>
    <message>
        <source>Insertion depth: planned and measured</source>
        <translation>Insertionstiefe: geplant und gemessen</translation>
    </message>
    <message>
        <source>median, 5 to 95 % of the plan</source>
        <translation>Median, 5 bis 95 % des Plans</translation>
    </message>
    <message>
        <source>measured depth, mm</source>
        <translation>gemessene Tiefe, mm</translation>
    </message>
    <message>
        <source>planned depth, mm</source>
        <translation>geplante Tiefe, mm</translation>
    </message>
    <message>
        <source>equal</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>Percentiles of the measured depths in their plans</source>
        <translation>Perzentile der gemessenen Tiefen in ihren Plänen</translation>
    </message>
    <message>
        <source>ears</source>
        <translation>Ohren</translation>
    </message>
    <message>
        <source>Dashed: as many in each tenth, to which the numbers tend if the bands hold.</source>
        <translation>Gestrichelt: gleich viele je Zehntel, wohin es strebt, wenn die Bänder gelten.</translation>
    </message>
    <message>
        <source>percentile</source>
        <translation>Perzentil</translation>
    </message>
    <message>
        <source>number of ears</source>
        <translation>Anzahl der Ohren</translation>
    </message>
    <message>
        <source>the stop lengths of a plan of Perilymph</source>
        <translation>die Stopplängen eines Plans von Perilymph</translation>
    </message>
    <message>
        <source>Choose a stops file that &apos;perilymph-cli outcomes&apos; wrote.</source>
        <translation>Wählen Sie eine Datei mit Stopplängen, die „perilymph-cli outcomes“ geschrieben hat.</translation>
    </message>
    <message>
        <source>Delete it; it is computed again.</source>
        <translation>Löschen Sie sie; sie wird neu berechnet.</translation>
    </message>
    <message>
        <source>belongs to another plan, or its patient, array, scenario or distributions were changed since.</source>
        <translation>gehört zu einem anderen Plan, oder dessen Patient, Träger, Szenario oder Verteilungen wurden seither geändert.</translation>
    </message>
    <message>
        <source>stop lengths</source>
        <translation>Stopplängen</translation>
    </message>
    <message>
        <source>its curve has gaps</source>
        <translation>ihre Kurve hat Lücken</translation>
    </message>
    <message>
        <source>its values are not possible</source>
        <translation>ihre Werte sind nicht möglich</translation>
    </message>
    <message>
        <source>its simulations are not consecutive</source>
        <translation>ihre Simulationen folgen nicht aufeinander</translation>
    </message>
    <message>
        <source>simulation %1 is not readable: %2</source>
        <translation>Simulation %1 ist nicht lesbar: %2</translation>
    </message>
    <message>
        <source>The plan has no array %1; it has %2. Choose one of them.</source>
        <translation>Der Plan hat keinen Träger %1; er hat %2. Wählen Sie einen davon.</translation>
    </message>
    <message>
        <source>Depths in this clinic rest on its resistance, number %1: %2 outcomes that ended by resistance, %3 that ended before, %4 that tell nothing, %5 to %6. They move neither forces nor ruptures.</source>
        <translation>Tiefen in dieser Klinik beruhen auf ihrem Widerstand, Nummer %1: %2 Ergebnisse, die durch Widerstand endeten, %3, die vorher endeten, %4, die nichts sagen, %5 bis %6. Kräfte und Rupturen ändern sie nicht.</translation>
    </message>
    <message>
        <source>The friction of this plan states no spread, so that %1 cannot be used. Choose a friction with a spread, or plan without the clinic&apos;s resistance.</source>
        <translation>Die Reibung dieses Plans nennt keine Streuung, so dass %1 nicht verwendet werden kann. Wählen Sie eine Reibung mit Streuung, oder planen Sie ohne den Widerstand der Klinik.</translation>
    </message>
    <message>
        <source>%1 counts from the friction %2, and this plan has %3. Choose the friction that the clinic&apos;s plans had.</source>
        <translation>%1 zählt von der Reibung %2 an, und dieser Plan hat %3. Wählen Sie die Reibung, die die Pläne der Klinik hatten.</translation>
    </message>
    <message>
        <source>%1 is not the resistance of a clinic: %2. Give a file that &apos;perilymph-cli outcomes --resistance&apos; wrote.</source>
        <translation>%1 ist nicht der Widerstand einer Klinik: %2. Geben Sie eine Datei an, die „perilymph-cli outcomes --resistance“ geschrieben hat.</translation>
    </message>
    <message>
        <source>%1 is of a newer program (format %2). Use it with that one.</source>
        <translation>%1 ist von einem neueren Programm (Format %2). Verwenden Sie sie mit jenem.</translation>
    </message>
    <message>
        <source>%1 was changed after the program wrote it, so that it is not used. Write it again with &apos;perilymph-cli outcomes --resistance&apos;.</source>
        <translation>%1 wurde geändert, nachdem das Programm sie geschrieben hatte, und wird nicht verwendet. Schreiben Sie sie mit „perilymph-cli outcomes --resistance“ neu.</translation>
    </message>
    <message>
        <source>The CT before surgery is no longer in %1.</source>
        <translation>Das CT vor der Operation ist nicht mehr in %1.</translation>
    </message>
    <message>
        <source>The search was canceled.</source>
        <translation>Die Suche wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The CT shows no bone. Choose a CT of the temporal bone.</source>
        <translation>Das CT zeigt keinen Knochen. Wählen Sie ein CT des Felsenbeins.</translation>
    </message>
    <message>
        <source>Another assignment of the contacts explains the metal nearly as well: check the number of the most apical contact.</source>
        <translation>Eine andere Zuordnung der Kontakte erklärt das Metall fast ebenso gut: Prüfen Sie die Nummer des apikalsten Kontakts.</translation>
    </message>
    <message>
        <source>Some contacts were not seen and are placed by the array&apos;s spacings: check them in the images.</source>
        <translation>Einige Kontakte waren nicht zu sehen und sind nach den Abständen des Trägers gesetzt: Prüfen Sie sie in den Bildern.</translation>
    </message>
    <message>
        <source>There is more metal in the ear than this array explains, such as an old lead: check which is the array.</source>
        <translation>Im Ohr ist mehr Metall, als dieser Träger erklärt, etwa ein altes Kabel: Prüfen Sie, was der Träger ist.</translation>
    </message>
    <message>
        <source>The contacts merge in these voxels: they are placed by the array&apos;s spacings along its course.</source>
        <translation>Die Kontakte verschmelzen in diesen Voxeln: Sie sind nach den Abständen des Trägers entlang seines Verlaufs gesetzt.</translation>
    </message>
    <message>
        <source>The angle turns back toward the tip: possible fold of the tip.</source>
        <translation>Der Winkel kehrt zur Spitze hin um: mögliche Umknickung der Spitze.</translation>
    </message>
    <message>
        <source>The array bends more sharply than in any cochlea: possible kink, or a contact in the wrong place.</source>
        <translation>Der Träger biegt sich stärker als in jeder Cochlea: möglicher Knick oder ein Kontakt am falschen Ort.</translation>
    </message>
    <message>
        <source>Possible translocation: contacts lie above the place of the basilar membrane, which no CT shows.</source>
        <translation>Mögliche Translokation: Kontakte liegen oberhalb der Lage der Basilarmembran, die kein CT zeigt.</translation>
    </message>
    <message>
        <source>Contacts lie outside the cochlea.</source>
        <translation>Kontakte liegen außerhalb der Cochlea.</translation>
    </message>
    <message>
        <source>The CTs before and after surgery agree badly around the cochlea: check the outline of the cochlea in the images.</source>
        <translation>Die CTs vor und nach der Operation stimmen um die Cochlea schlecht überein: Prüfen Sie den Umriss der Cochlea in den Bildern.</translation>
    </message>
    <message>
        <source>The cochlea was measured in the CT after surgery, beside the metal: angles and depths have wider errors. Give the CT before surgery if there is one.</source>
        <translation>Die Cochlea wurde im CT nach der Operation neben dem Metall gemessen: Winkel und Tiefen haben größere Fehler. Geben Sie das CT vor der Operation an, wenn es eines gibt.</translation>
    </message>
    <message>
        <source>Side, A or B differ from the patient&apos;s by more than their errors: check that this CT is of the same patient and ear.</source>
        <translation>Seite, A oder B weichen um mehr als ihre Fehler von denen des Patienten ab: Prüfen Sie, ob dieses CT von demselben Patienten und Ohr ist.</translation>
    </message>
    <message>
        <source>A part of the array lies outside the CT.</source>
        <translation>Ein Teil des Trägers liegt außerhalb des CTs.</translation>
    </message>
    <message>
        <source>A voxel is longer than 0.65 mm, the coarsest that was tested: take a finer series if there is one.</source>
        <translation>Ein Voxel ist länger als 0,65 mm, das gröbste geprüfte: Nehmen Sie eine feinere Serie, wenn es eine gibt.</translation>
    </message>
    <message>
        <source>%1: %2 is %3; %4 is needed.</source>
        <translation>%1: %2 ist %3; nötig ist %4.</translation>
    </message>
    <message>
        <source>%1 is no outcome: it is not JSON. Make it by perilymph-cli ct contacts.</source>
        <translation>%1 ist kein Ergebnis: Es ist kein JSON. Erzeugen Sie es mit perilymph-cli ct contacts.</translation>
    </message>
    <message>
        <source>%1 has format %2; this program reads %3. Use a newer program.</source>
        <translation>%1 hat das Format %2; dieses Programm liest %3. Verwenden Sie ein neueres Programm.</translation>
    </message>
    <message>
        <source>The CT before surgery shows too little around the cochlea to be compared with that after it. Choose the series in which the cochlea was measured.</source>
        <translation>Das CT vor der Operation zeigt zu wenig um die Cochlea, um mit dem danach verglichen zu werden. Wählen Sie die Serie, in der die Cochlea gemessen wurde.</translation>
    </message>
    <message>
        <source>The registration was canceled.</source>
        <translation>Die Registrierung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The two CTs show no common surroundings of the cochlea. Check that both are of the same patient and ear.</source>
        <translation>Die beiden CTs zeigen keine gemeinsame Umgebung der Cochlea. Prüfen Sie, ob beide von demselben Patienten und Ohr sind.</translation>
    </message>
    <message>
        <source>%1 is %2; %3 to %4 is allowed.</source>
        <translation>%1 ist %2; erlaubt ist %3 bis %4.</translation>
    </message>
    <message>
        <source>The lot is “%1”; up to 24 letters, digits and hyphens are allowed.</source>
        <translation>Die Charge ist „%1“; erlaubt sind bis zu 24 Buchstaben, Ziffern und Bindestriche.</translation>
    </message>
    <message>
        <source>The lubricant has %1 characters; up to 40 are allowed.</source>
        <translation>Das Gleitmittel hat %1 Zeichen; erlaubt sind bis zu 40.</translation>
    </message>
    <message>
        <source>The array %1 has %2 contacts; 4 or more are needed. Choose an array with contacts.</source>
        <translation>Der Träger %1 hat %2 Kontakte; nötig sind 4 oder mehr. Wählen Sie einen Träger mit Kontakten.</translation>
    </message>
    <message>
        <source>The search for contacts was canceled.</source>
        <translation>Die Suche nach den Kontakten wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The contacts cannot be found: the metal in this ear forms no array&apos;s course. Place contacts by hand, or check side and array.</source>
        <translation>Die Kontakte sind nicht zu finden: Das Metall in diesem Ohr bildet keinen Verlauf eines Trägers. Setzen Sie Kontakte von Hand oder prüfen Sie Seite und Träger.</translation>
    </message>
    <message>
        <source>The CTs before and after surgery do not agree around the cochlea.</source>
        <translation>Die CTs vor und nach der Operation stimmen um die Cochlea nicht überein.</translation>
    </message>
    <message>
        <source>A is %1 mm in this CT, and %2 mm for the patient.</source>
        <translation>A ist in dieser CT %1 mm und beim Patienten %2 mm.</translation>
    </message>
    <message>
        <source>B is %1 mm in this CT, and %2 mm for the patient.</source>
        <translation>B ist in dieser CT %1 mm und beim Patienten %2 mm.</translation>
    </message>
    <message>
        <source>There is no array in this ear: %1 cubic millimeters of metal lie in or near the cochlea, at least 0.3 are expected. Choose a CT after surgery, and check the side.</source>
        <translation>In diesem Ohr liegt kein Elektrodenträger: %1 Kubikmillimeter Metall liegen in oder an der Cochlea, erwartet sind mindestens 0,3. Wählen Sie ein CT nach der Operation und prüfen Sie, ob es dieses Ohr zeigt.</translation>
    </message>
    <message>
        <source>This CT shows the %1, and the patient&apos;s is the %2.</source>
        <translation>Dieses CT zeigt: %1. Das Ohr des Patienten: %2.</translation>
    </message>
    <message>
        <source>%1 is %2°; %3° to %4° is allowed.</source>
        <translation>%1 ist %2°; erlaubt ist %3° bis %4°.</translation>
    </message>
    <message>
        <source>%1 is %2 mm; 0 to %3 mm is allowed.</source>
        <translation>%1 ist %2 mm; erlaubt ist 0 bis %3 mm.</translation>
    </message>
    <message>
        <source>Tilt of the approach</source>
        <translation>Neigung des Zugangs</translation>
    </message>
    <message>
        <source>Turn of the approach</source>
        <translation>Drehung des Zugangs</translation>
    </message>
    <message>
        <source>Intended depth</source>
        <translation>Vorgesehene Tiefe</translation>
    </message>
    <message>
        <source>Length outside</source>
        <translation>Länge außen</translation>
    </message>
    <message>
        <source>Contacts intended inside</source>
        <translation>Vorgesehene Kontakte innen</translation>
    </message>
    <message>
        <source>Contacts outside</source>
        <translation>Kontakte außen</translation>
    </message>
    <message>
        <source>Contact at first resistance</source>
        <translation>Kontakt beim ersten Widerstand</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Pull-backs</source>
        <translation>Rückzüge</translation>
    </message>
    <message>
        <source>Days from surgery to CT</source>
        <translation>Tage von der OP bis zum CT</translation>
    </message>
    <message>
        <source>%1 shows metal in the cochlea, so that it is no CT before surgery: the ear is measured in the CT after it.</source>
        <translation>%1 zeigt Metall in der Cochlea und ist damit kein CT vor der Operation: Das Ohr wird im CT danach gemessen.</translation>
    </message>
    <message>
        <source>A plan cannot be read, and no outcome is compared with it. %1</source>
        <translation>Ein Plan ist nicht lesbar; kein Ergebnis wird mit ihm verglichen. %1</translation>
    </message>
    <message>
        <source>%1 is left out: its plan %2 with %3 is not there as it was made before the surgery. Restore the plan&apos;s folder.</source>
        <translation>%1 ist ausgelassen: Der zugehörige Plan %2 mit %3 ist nicht so vorhanden, wie er vor der Operation erstellt wurde. Stellen Sie den Ordner des Plans wieder her.</translation>
    </message>
    <message>
        <source>%1 was found in the CT and %2 was implanted as the surgeon says. Find the contacts again with the array that was implanted.</source>
        <translation>%1 wurde im CT gefunden, und %2 wurde nach Angabe des Operateurs implantiert. Suchen Sie die Kontakte erneut mit dem implantierten Elektrodenträger.</translation>
    </message>
    <message>
        <source>the record and its outcome name different CT series, %1 and %2. Find the contacts again.</source>
        <translation>Akte und Ergebnis nennen verschiedene CT-Serien, %1 und %2. Suchen Sie die Kontakte erneut.</translation>
    </message>
    <message>
        <source>its angular insertion depth is %1 degrees, and its most apical contact inside lies at %2. Find the contacts again.</source>
        <translation>die Winkel-Insertionstiefe ist %1 Grad, und der apikalste Kontakt in der Cochlea liegt bei %2. Suchen Sie die Kontakte erneut.</translation>
    </message>
    <message>
        <source>its outcome was saved on &quot;%1&quot;, which is no day. Find the contacts again.</source>
        <translation>das Ergebnis wurde am „%1“ gespeichert, was kein Tag ist. Suchen Sie die Kontakte erneut.</translation>
    </message>
    <message>
        <source>its outcome was saved on %1, which is still to come. Set the clock, and find the contacts again.</source>
        <translation>das Ergebnis wurde am %1 gespeichert, der noch kommt. Stellen Sie die Uhr, und suchen Sie die Kontakte erneut.</translation>
    </message>
    <message>
        <source>%1 of %2 is left out: the same ear is in %3. Give one of them another code.</source>
        <translation>%1 aus %2 ist ausgelassen: Dasselbe Ohr steht in %3. Geben Sie einem von beiden einen anderen Code.</translation>
    </message>
    <message>
        <source>%1 is left out: its CT after surgery (%2) is also that of %3. Remove the CT that is not this patient&apos;s and find the contacts again.</source>
        <translation>%1 ist ausgelassen: Das CT nach der Operation (%2) ist auch das von %3. Entfernen Sie das CT, das nicht zu diesem Patienten gehört, und suchen Sie die Kontakte erneut.</translation>
    </message>
    <message>
        <source>%1 was changed by hand; its outcome is compared as it stands there.</source>
        <translation>%1 wurde von Hand geändert; das Ergebnis wird so verglichen, wie es dort steht.</translation>
    </message>
    <message>
        <source>%1 or the plan.json beside it was changed after the program wrote it, and is no prediction any more. Restore the plan&apos;s folder.</source>
        <translation>%1 oder die plan.json daneben wurde geändert, nachdem das Programm sie schrieb, und ist keine Vorhersage mehr. Stellen Sie den Ordner des Plans wieder her.</translation>
    </message>
    <message>
        <source>Stop lengths were computed again, for %1 plans: those that were there are of another build of the program or of another plan, or were changed or damaged.</source>
        <translation>Die Stopplängen von %1 Plänen wurden neu berechnet: Die vorhandenen stammen von einer anderen Version des Programms oder einem anderen Plan, oder sie wurden geändert oder beschädigt.</translation>
    </message>
    <message>
        <source>%1 of %2 has the standard deviation %3; 0 to %4 is allowed. Check the contacts found in the CT.</source>
        <translation>%1 von %2 hat die Standardabweichung %3; erlaubt ist 0 bis %4. Prüfen Sie die im CT gefundenen Kontakte.</translation>
    </message>
    <message>
        <source>its values are nested more than %1 deep</source>
        <translation>seine Werte sind mehr als %1-fach verschachtelt</translation>
    </message>
    <message>
        <source>it states &quot;%1&quot; twice</source>
        <translation>es nennt „%1“ zweimal</translation>
    </message>
    <message>
        <source>%1 is no outcome: %2. Make it by perilymph-cli ct contacts.</source>
        <translation>%1 ist kein Ergebnis: %2. Erzeugen Sie es mit perilymph-cli ct contacts.</translation>
    </message>
    <message>
        <source>%1 is in use: another program works on it. Wait until that program has ended.</source>
        <translation>%1 ist in Gebrauch: Ein anderes Programm arbeitet daran. Warten Sie, bis dieses beendet ist.</translation>
    </message>
    <message>
        <source>%1 cannot be removed: %2.</source>
        <translation>%1 kann nicht entfernt werden: %2.</translation>
    </message>
    <message>
        <source>its outcome is of the %1. Find the contacts in the CT of this ear again.</source>
        <translation>das Ergebnis gehört zum anderen Ohr (%1). Suchen Sie die Kontakte im CT dieses Ohrs erneut.</translation>
    </message>
    <message>
        <source>%1 is left out: the day of its CT is not known, so that no plan is known to be made before surgery. Open the outcome on the page Outcome, state Day of the CT, and save it again.</source>
        <translation>%1 ist ausgelassen: Der Tag des CT ist nicht bekannt, sodass von keinem Plan bekannt ist, dass er vor der Operation erstellt wurde. Öffnen Sie das Ergebnis auf der Seite Ergebnis, geben Sie den Tag des CT an und speichern Sie es erneut.</translation>
    </message>
    <message>
        <source>%1 is left out: the days from surgery to its CT are not known, so that no plan is known to be made before surgery. Open the outcome on the page Outcome, state them, and save it again.</source>
        <translation>%1 ist ausgelassen: Die Tage von der OP bis zum CT sind nicht bekannt, sodass von keinem Plan bekannt ist, dass er vor der Operation erstellt wurde. Öffnen Sie das Ergebnis auf der Seite Ergebnis, geben Sie sie an und speichern Sie es erneut.</translation>
    </message>
    <message>
        <source>The inserted length [mm]</source>
        <translation>Die inserierte Länge [mm]</translation>
    </message>
    <message>
        <source>The angular insertion depth [degrees]</source>
        <translation>Der Insertionswinkel [Grad]</translation>
    </message>
    <message>
        <source>ear %1</source>
        <translation>Ohr %1</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a text of up to %1 characters</source>
        <translation>ein Text von bis zu %1 Zeichen</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>drei Zahlen</translation>
    </message>
    <message>
        <source>three numbers up to 10,000 mm</source>
        <translation>drei Zahlen bis 10.000 mm</translation>
    </message>
    <message>
        <source>an object with value and sd</source>
        <translation>ein Objekt mit value und sd</translation>
    </message>
    <message>
        <source>an object with value and ci95</source>
        <translation>ein Objekt mit value und ci95</translation>
    </message>
    <message>
        <source>%1: %2 is missing; %3 is needed.</source>
        <translation>%1: %2 fehlt; nötig ist %3.</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a list of flags that the guide names</source>
        <translation>eine Liste von Hinweisen, die der Leitfaden nennt</translation>
    </message>
    <message>
        <source>a list of 1 to 64 contacts</source>
        <translation>eine Liste von 1 bis 64 Kontakten</translation>
    </message>
    <message>
        <source>a number above that of the contact before</source>
        <translation>eine Nummer über der des vorigen Kontakts</translation>
    </message>
    <message>
        <source>%1, the number of contacts that are inside,</source>
        <translation>%1, die Zahl der Kontakte innen,</translation>
    </message>
    <message>
        <source>a list of up to 4,000 points</source>
        <translation>eine Liste von bis zu 4.000 Punkten</translation>
    </message>
    <message>
        <source>this ear</source>
        <translation>diesem Ohr</translation>
    </message>
    <message>
        <source>The inserted length of %1 is %2 mm, and %3 is %4 mm long. Check that the CT is of this ear, and the contacts found in it.</source>
        <translation>Die inserierte Länge von %1 ist %2 mm, und %3 ist %4 mm lang. Prüfen Sie, ob das CT dieses Ohr zeigt, und die darin gefundenen Kontakte.</translation>
    </message>
    <message>
        <source>%1 is %2, and %3 has %4 contacts. Correct the answer or choose the array.</source>
        <translation>%1 ist %2, und %3 hat %4 Kontakte. Berichtigen Sie die Angabe oder wählen Sie den Elektrodenträger.</translation>
    </message>
    <message>
        <source>%1 is %2 mm, and %3 goes %4 mm deep. Correct the answer or choose the array.</source>
        <translation>%1 ist %2 mm, und %3 reicht %4 mm tief. Berichtigen Sie die Angabe oder wählen Sie den Elektrodenträger.</translation>
    </message>
    <message>
        <source>Spacing, number or place of the contacts contradict the array named or this ear: check the contacts in the images, and the array&apos;s name.</source>
        <translation>Abstand, Anzahl oder Lage der Kontakte widersprechen dem genannten Träger oder diesem Ohr: Prüfen Sie die Kontakte in den Bildern und den Namen des Trägers.</translation>
    </message>
    <message>
        <source>16 contacts over 15 mm (3 to 18 mm of depth), pitch about 1.0 mm, as listed in public research code. The first contact&apos;s place and the contact&apos;s length are choices. The numbers that the fitting software gives them, 1 at the tip: general literature, medium confidence.</source>
        <translation>16 Kontakte auf 15 mm (3 bis 18 mm Tiefe), Abstand etwa 1,0 mm, laut öffentlichem Forschungscode. Lage des ersten Kontakts und Kontaktlänge sind Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 1 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>16 contacts, pitch 1.3 mm, 20 mm over all: general literature; public research code has 18 mm from the first to the last (4 to 22 mm of depth). The first contact&apos;s place and the contact&apos;s length are choices. The numbers that the fitting software gives them, 1 at the tip: general literature, medium confidence.</source>
        <translation>16 Kontakte, Abstand 1,3 mm, insgesamt 20 mm: allgemeine Literatur; öffentlicher Forschungscode hat 18 mm vom ersten bis zum letzten (4 bis 22 mm Tiefe). Lage des ersten Kontakts und Kontaktlänge sind Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 1 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>22 contacts over 15 mm (3 to 18 mm of depth), as listed in public research code. The law of the pitch is the Contour&apos;s, a choice. The numbers that the fitting software gives them, 22 at the tip: general literature, medium confidence.</source>
        <translation>22 Kontakte auf 15 mm (3 bis 18 mm Tiefe) laut öffentlichem Forschungscode. Der Verlauf der Abstände ist der des Contour (Wahl). Die Nummern, die ihnen die Anpasssoftware gibt, 22 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>22 contacts over 14.5 mm, as listed in public research code. The first contact&apos;s place and the contact&apos;s length are choices. The numbers that the fitting software gives them, 22 at the tip: general literature, medium confidence.</source>
        <translation>22 Kontakte auf 14,5 mm laut öffentlichem Forschungscode. Lage des ersten Kontakts und Kontaktlänge sind Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 22 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>22 full bands, 0.3 mm wide, pitch 0.75 mm, as listed in public research code. The first contact&apos;s place is a choice. The numbers that the fitting software gives them, 22 at the tip: general literature, medium confidence.</source>
        <translation>22 Vollbänder, 0,3 mm breit, Abstand 0,75 mm, laut öffentlichem Forschungscode. Die Lage des ersten Kontakts ist Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 22 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>22 contacts over 14 mm (3 to 17 mm of depth), pitch about 0.67 mm, as listed in public research code. The contact&apos;s length is a choice. The numbers that the fitting software gives them, 22 at the tip: general literature, medium confidence.</source>
        <translation>22 Kontakte auf 14 mm (3 bis 17 mm Tiefe), Abstand etwa 0,67 mm, laut öffentlichem Forschungscode. Die Kontaktlänge ist Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 22 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>22 half-band contacts over 19.1 mm, pitch about 0.9 mm, as listed in public research code. The first contact&apos;s place and the contact&apos;s length are choices. The numbers that the fitting software gives them, 22 at the tip: general literature, medium confidence.</source>
        <translation>22 Halbbandkontakte auf 19,1 mm, Abstand etwa 0,9 mm, laut öffentlichem Forschungscode. Lage des ersten Kontakts und Kontaktlänge sind Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 22 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>12 channels with a pitch of 1.4 mm, 15.4 mm from the first to the last: general literature and clinical studies of the device. The first contact&apos;s place and the contact&apos;s length are choices. The numbers that the fitting software gives them, 1 at the tip: general literature, medium confidence.</source>
        <translation>12 Kanäle im Abstand von 1,4 mm, 15,4 mm vom ersten bis zum letzten: allgemeine Literatur und klinische Studien zum Gerät. Lage des ersten Kontakts und Kontaktlänge sind Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 1 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>12 channels with a pitch of 1.9 mm, 20.9 mm from the first to the last: general literature and clinical studies of the device. The first contact&apos;s place and the contact&apos;s length are choices. The numbers that the fitting software gives them, 1 at the tip: general literature, medium confidence.</source>
        <translation>12 Kanäle im Abstand von 1,9 mm, 20,9 mm vom ersten bis zum letzten: allgemeine Literatur und klinische Studien zum Gerät. Lage des ersten Kontakts und Kontaktlänge sind Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 1 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>12 channels with a pitch of 2.1 mm, 23.1 mm from the first to the last: general literature and clinical studies of the device. The first contact&apos;s place and the contact&apos;s length are choices. The numbers that the fitting software gives them, 1 at the tip: general literature, medium confidence.</source>
        <translation>12 Kanäle im Abstand von 2,1 mm, 23,1 mm vom ersten bis zum letzten: allgemeine Literatur und klinische Studien zum Gerät. Lage des ersten Kontakts und Kontaktlänge sind Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 1 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>12 channels with a pitch of 2.4 mm, 26.4 mm from the first to the last: general literature and clinical studies of the device. The first contact&apos;s place and the contact&apos;s length are choices. The numbers that the fitting software gives them, 1 at the tip: general literature, medium confidence.</source>
        <translation>12 Kanäle im Abstand von 2,4 mm, 26,4 mm vom ersten bis zum letzten: allgemeine Literatur und klinische Studien zum Gerät. Lage des ersten Kontakts und Kontaktlänge sind Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 1 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>12 channels with a pitch of 1.1 mm, 12.1 mm from the first to the last: general literature and clinical studies of the device. The first contact&apos;s place and the contact&apos;s length are choices. The numbers that the fitting software gives them, 1 at the tip: general literature, medium confidence.</source>
        <translation>12 Kanäle im Abstand von 1,1 mm, 12,1 mm vom ersten bis zum letzten: allgemeine Literatur und klinische Studien zum Gerät. Lage des ersten Kontakts und Kontaktlänge sind Wahl. Die Nummern, die ihnen die Anpasssoftware gibt, 1 an der Spitze: allgemeine Literatur, mittlere Sicherheit.</translation>
    </message>
    <message>
        <source>22 half-band contacts over an active length of 15 mm, pitch 0.4 to 0.8 mm growing from the tip: general literature, not measured. The first contact&apos;s place, the law of the pitch and the contact&apos;s length are choices.</source>
        <translation>22 Halbbandkontakte auf einer aktiven Länge von 15 mm, Abstand von der Spitze an von 0,4 auf 0,8 mm wachsend: allgemeine Literatur, nicht gemessen. Lage des ersten Kontakts, Verlauf der Abstände und Kontaktlänge sind Wahl.</translation>
    </message>
    <message>
        <source>The cochlea was fitted badly to its images: angles may be wrong by more than their intervals. Check the outline of the cochlea, or give another CT before surgery.</source>
        <translation>Die Cochlea passt schlecht zu ihren Bildern: Winkel können weiter abweichen als ihre Intervalle. Prüfen Sie den Umriss der Cochlea oder geben Sie ein anderes CT vor der Operation an.</translation>
    </message>
    <message>
        <source>The markup %1 has %2 points; it needs %3 to %4. Place it again.</source>
        <translation>Die Markierung %1 hat %2 Punkte; nötig sind %3 bis %4. Setzen Sie sie neu.</translation>
    </message>
    <message>
        <source>The markup %1 has a point that is not finite or beyond 10 m from the scanner&apos;s origin. Place it again.</source>
        <translation>Die Markierung %1 hat einen Punkt, der nicht endlich ist oder mehr als 10 m vom Ursprung des Scanners entfernt liegt. Setzen Sie sie neu.</translation>
    </message>
    <message>
        <source>The markup %1 has two points at one place. Move one of them.</source>
        <translation>Die Markierung %1 hat zwei Punkte an derselben Stelle. Verschieben Sie einen davon.</translation>
    </message>
    <message>
        <source>A note has no text. Write one, or remove it.</source>
        <translation>Eine Notiz hat keinen Text. Schreiben Sie einen oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>The text of a markup %1 has %2 bytes; at most %3 are kept. Shorten it.</source>
        <translation>Der Text einer Markierung %1 hat %2 Bytes; gespeichert werden höchstens %3. Kürzen Sie ihn.</translation>
    </message>
    <message>
        <source>The text of a markup %1 has a line break, a control character or a character that is no UTF-8. Write it in one line.</source>
        <translation>Der Text einer Markierung %1 hat einen Zeilenumbruch, ein Steuerzeichen oder ein Zeichen, das kein UTF-8 ist. Schreiben Sie ihn in einer Zeile.</translation>
    </message>
    <message>
        <source>Markups are of the CT series &quot;%1&quot;, which is no SHA-256 of 64 hexadecimal digits. Place them in an open CT.</source>
        <translation>Markierungen gehören zur CT-Serie „%1“; das ist keine SHA-256 aus 64 hexadezimalen Ziffern. Setzen Sie sie in einem geöffneten CT.</translation>
    </message>
    <message>
        <source>Markups are of voxels whose edges are not 0.001 to 100 mm long or lie in one plane. Place them in an open CT.</source>
        <translation>Markierungen gehören zu Voxeln, deren Kanten nicht 0,001 bis 100 mm lang sind oder in einer Ebene liegen. Setzen Sie sie in einem geöffneten CT.</translation>
    </message>
    <message>
        <source>A CT has %1 markups; at most %2 are kept. Remove some.</source>
        <translation>Ein CT hat %1 Markierungen; gespeichert werden höchstens %2. Entfernen Sie einige.</translation>
    </message>
    <message>
        <source>%1 of %2 markups have a point outside the CT, which is not shown. Remove them or place them again.</source>
        <translation>%1 von %2 Markierungen haben einen Punkt außerhalb des CTs, der nicht angezeigt wird. Entfernen Sie sie oder setzen Sie sie neu.</translation>
    </message>
    <message>
        <source>There are markups of %1 scans; those of %2 are kept at most. Remove some.</source>
        <translation>Es gibt Markierungen von %1 Scans; gespeichert werden die von höchstens %2. Entfernen Sie einige.</translation>
    </message>
    <message>
        <source>Markups of the CT series %1 stand twice. Remove one of the lists.</source>
        <translation>Die Markierungen der CT-Serie %1 stehen doppelt. Entfernen Sie eine der Listen.</translation>
    </message>
    <message>
        <source>%1 states in &quot;%2&quot; of a markup what this program does not know. Restore it from a backup, or remove the markup.</source>
        <translation>%1 gibt in „%2“ einer Markierung etwas an, das dieses Programm nicht kennt. Stellen Sie die Datei aus einer Sicherung wieder her oder entfernen Sie die Markierung.</translation>
    </message>
    <message>
        <source>The CT has no series that a key image could be kept with. Open it from its files.</source>
        <translation>Das CT hat keine Serie, zu der ein Schlüsselbild behalten werden könnte. Öffnen Sie es aus seinen Dateien.</translation>
    </message>
    <message>
        <source>The CT has %1 key images; no more are kept. Remove one.</source>
        <translation>Das CT hat %1 Schlüsselbilder; mehr werden nicht behalten. Entfernen Sie eines.</translation>
    </message>
    <message>
        <source>%1 is no Slicer markups file with lines, angles, points or curves in LPS or RAS. Save them in Slicer as Markups JSON (.mrk.json).</source>
        <translation>%1 ist keine Markups-Datei von Slicer mit Linien, Winkeln, Punkten oder Kurven in LPS oder RAS. Speichern Sie sie in Slicer als Markups JSON (.mrk.json).</translation>
    </message>
    <message>
        <source>There are %1 devices &apos;%2&apos;. Give the place of one: %3.</source>
        <translation>Es gibt %1 Geräte „%2“. Geben Sie den Ort von einem an: %3.</translation>
    </message>
    <message>
        <source>there is no such file. Check the path.</source>
        <translation>die Datei gibt es nicht. Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>it is not a file. Give the path of its library.</source>
        <translation>es ist keine Datei. Geben Sie den Pfad der Bibliothek an.</translation>
    </message>
    <message>
        <source>you may not read it. Give yourself the right: chmod u+r %1</source>
        <translation>Sie dürfen die Datei nicht lesen. Geben Sie sich das Recht: chmod u+r %1</translation>
    </message>
    <message>
        <source>every user of this machine may change it, and it would run with your rights. Take that right away: chmod o-w %1</source>
        <translation>jeder Benutzer dieses Rechners darf die Datei ändern, und sie liefe mit Ihren Rechten. Entziehen Sie dieses Recht: chmod o-w %1</translation>
    </message>
    <message>
        <source>every user of this machine may replace it, and it would run with your rights. Take that right away: chmod o-w %1</source>
        <translation>jeder Benutzer dieses Rechners darf die Datei ersetzen, und sie liefe mit Ihren Rechten. Entziehen Sie dieses Recht: chmod o-w %1</translation>
    </message>
    <message>
        <source>it is not a shared library of this machine. Build it, and give the .so file.</source>
        <translation>es ist keine dynamische Bibliothek für diesen Rechner. Übersetzen Sie das Plug-in und geben Sie die .so-Datei an.</translation>
    </message>
    <message>
        <source>it exports no %1. It is not a device plug-in.</source>
        <translation>%1 wird nicht exportiert. Es ist kein Geräte-Plug-in.</translation>
    </message>
    <message>
        <source>it is built for version %1 of PluginApi.h, this program for version %2. Build it with the header of this program.</source>
        <translation>es ist für Version %1 von PluginApi.h übersetzt, dieses Programm für Version %2. Übersetzen Sie es mit dem Header dieses Programms.</translation>
    </message>
    <message>
        <source>its greatest torque is %1 N.m; it must be 0 (no torque) or between 0.0001 and 10.</source>
        <translation>sein größtes Drehmoment ist %1 N.m; zulässig sind 0 (kein Drehmoment) oder 0.0001 bis 10.</translation>
    </message>
    <message>
        <source>its axes %1 do not match its counts: %2 axes that it pushes along and %3 that it turns about.</source>
        <translation>seine Achsen %1 passen nicht zu den angegebenen Anzahlen: %2 Achsen mit Kraft und %3 mit Drehmoment.</translation>
    </message>
    <message>
        <source>%1 belongs to a file that had the name %2 before, and would spoil a new one. Move it away, or choose another name.</source>
        <translation>%1 gehört zu einer Datei, die vorher %2 hieß, und würde eine neue verderben. Verschieben Sie sie, oder wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The file of the array %1 was changed since the scenario %2 was read. Read the scenario again.</source>
        <translation>Die Datei des Arrays %1 wurde geändert, seit das Szenario %2 gelesen wurde. Lesen Sie das Szenario erneut.</translation>
    </message>
    <message>
        <source>With %1 nodes a time step can take %2 ms on this machine, longer than %3 ms, so that the force at the device could be late. Set nodes to at most %4.</source>
        <translation>Mit %1 Knoten kann ein Zeitschritt auf diesem Rechner %2 ms dauern, länger als %3 ms, sodass die Kraft am Gerät zu spät kommen könnte. Setzen Sie „nodes“ auf höchstens %4.</translation>
    </message>
    <message>
        <source>Of the %1 MB of memory in which the haptic loop works %2 MB are locked in RAM; the system allows %3 MB. If ticks are late while memory is short, add the line &apos;@audio - memlock unlimited&apos; to /etc/security/limits.d/audio.conf, join the group audio and log in again.</source>
        <translation>Von den %1 MB Speicher, in denen die haptische Schleife arbeitet, sind %2 MB im RAM gesperrt; das System erlaubt %3 MB. Wenn Zeitschritte bei knappem Speicher zu spät kommen, fügen Sie die Zeile „@audio - memlock unlimited“ in /etc/security/limits.d/audio.conf ein, treten Sie der Gruppe audio bei und melden Sie sich neu an.</translation>
    </message>
    <message>
        <source>the block of tick %1 cannot be read</source>
        <translation>der Block des Takts %1 kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>%1 is not that of %2 and would spoil it. Move it to another folder.</source>
        <translation>%1 gehört nicht zu %2 und würde die Datei verderben. Verschieben Sie sie in einen anderen Ordner.</translation>
    </message>
    <message>
        <source>%1 plug-ins are named %2: %3. Give the path of one of them.</source>
        <translation>%1 Plug-ins heißen %2: %3. Geben Sie den Pfad eines davon an.</translation>
    </message>
    <message>
        <source>%1 may replace it, because the folder %2 is theirs, and it would run with your rights. Copy it to a folder of your own.</source>
        <translation>%1 darf die Datei ersetzen, da der Ordner %2 diesem Benutzer gehört, und sie liefe mit Ihren Rechten. Kopieren Sie sie in einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>%1 may change it, because it is theirs, and it would run with your rights. Copy it to a folder of your own.</source>
        <translation>%1 darf die Datei ändern, da sie diesem Benutzer gehört, und sie liefe mit Ihren Rechten. Kopieren Sie sie in einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>It did not answer within %1 s while it was opened, and its plug-in was ended. The force is off. Check its power and its cable; if that recurs, tell the maker of the plug-in.</source>
        <translation>Das Gerät antwortete beim Öffnen nicht innerhalb von %1 s, und sein Plug-in wurde beendet. Die Kraft ist aus. Prüfen Sie Stromversorgung und Kabel; kommt das wieder vor, melden Sie es dem Hersteller des Plug-ins.</translation>
    </message>
    <message>
        <source>it did not answer within %1 s while it was loaded, and was ended. Tell its maker.</source>
        <translation>es antwortete beim Laden nicht innerhalb von %1 s und wurde beendet. Melden Sie es seinem Hersteller.</translation>
    </message>
    <message>
        <source>the name of its device has a line break or another control character.</source>
        <translation>der Name seines Geräts enthält einen Zeilenumbruch oder ein anderes Steuerzeichen.</translation>
    </message>
    <message>
        <source>its %1 is %2 %3; it must be between 0 and %4.</source>
        <translation>es gibt als %1 %2 %3 an; zulässig ist 0 bis %4.</translation>
    </message>
    <message>
        <source>it renders force and has no button: a force is only rendered while a button is held, and goes to zero when it is let go. State at least 1.</source>
        <translation>es gibt Kraft aus und hat keine Taste: Kraft wird nur ausgegeben, solange eine Taste gehalten wird, und geht auf null, wenn sie losgelassen wird. Geben Sie mindestens 1 an.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Make space on its disk, or name a file on another one.</source>
        <translation>%1 kann nicht geschrieben werden: %2. Schaffen Sie Platz auf dem Datenträger, oder nennen Sie eine Datei auf einem anderen.</translation>
    </message>
    <message>
        <source>%1 is not a file: a table of SQLite cannot go into a folder, a pipe or a device. Name a file.</source>
        <translation>%1 ist keine Datei: Eine SQLite-Tabelle kann nicht in einen Ordner, eine Pipe oder ein Gerät geschrieben werden. Nennen Sie eine Datei.</translation>
    </message>
    <message>
        <source>workspace radius</source>
        <translation>Radius des Arbeitsraums</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>position quantum</source>
        <translation>Auflösung der Position</translation>
    </message>
    <message>
        <source>force quantum</source>
        <translation>Auflösung der Kraft</translation>
    </message>
    <message>
        <source>transport delay</source>
        <translation>Übertragungsverzögerung</translation>
    </message>
    <message>
        <source>watchdog</source>
        <translation>Watchdog-Zeit</translation>
    </message>
    <message>
        <source>its pages contradict one another</source>
        <translation>ihre Seiten widersprechen einander</translation>
    </message>
    <message>
        <source>%1 has a %2 but no %3, which &apos;perilymph-cli plan&apos; did not write in former versions. Make the plan again, into another folder.</source>
        <translation>%1 hat eine %2, aber keine %3, die „perilymph-cli plan“ in früheren Versionen nicht geschrieben hat. Erstellen Sie den Plan neu, in einem anderen Ordner.</translation>
    </message>
</context>
<context>
    <name>Display</name>
    <message>
        <source>not supported by this display</source>
        <translation>von dieser Anzeige nicht unterstützt</translation>
    </message>
</context>
<context>
    <name>ForceLevel</name>
    <message>
        <source>gentle</source>
        <translation>sanft</translation>
    </message>
    <message>
        <source>firm</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>too much</source>
        <translation>zu viel</translation>
    </message>
    <message>
        <source>Gentle: below the forces measured in patients.</source>
        <translation>Sanft: unter den an Patienten gemessenen Kräften.</translation>
    </message>
    <message>
        <source>Firm: like the forces measured in patients.</source>
        <translation>Fest: wie an Patienten gemessene Kräfte.</translation>
    </message>
    <message>
        <source>Too much: above the forces measured in patients.</source>
        <translation>Zu viel: über den an Patienten gemessenen Kräften.</translation>
    </message>
    <message>
        <source>Peak forces measured in patients: %1–%2 mN (Rau et al. 2024). This comparison is not a safety assessment.</source>
        <translation>An Patienten gemessene Maximalkräfte: %1–%2 mN (Rau et al. 2024). Der Vergleich ist keine Bewertung der Sicherheit.</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild ab</translation>
    </message>
</context>
<context>
    <name>ReportParameters</name>
    <message>
        <source>Anatomy</source>
        <translation>Anatomie</translation>
    </message>
    <message>
        <source>Ear</source>
        <translation>Ohr</translation>
    </message>
    <message>
        <source>Organ of Corti length</source>
        <translation>Länge des Corti-Organs</translation>
    </message>
    <message>
        <source>Scala width at round window</source>
        <translation>Skalenbreite am runden Fenster</translation>
    </message>
    <message>
        <source>Scala height at round window</source>
        <translation>Skalenhöhe am runden Fenster</translation>
    </message>
    <message>
        <source>A: basal-turn diameter</source>
        <translation>A: Durchmesser der Basalwindung</translation>
    </message>
    <message>
        <source>B: basal-turn width</source>
        <translation>B: Breite der Basalwindung</translation>
    </message>
    <message>
        <source>H: cochlear height</source>
        <translation>H: Höhe der Cochlea</translation>
    </message>
    <message>
        <source>Straight lead-in before the round window</source>
        <translation>Gerader Vorlauf vor dem runden Fenster</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>Cochleostomy diameter</source>
        <translation>Durchmesser der Cochleostomie</translation>
    </message>
    <message>
        <source>Approach angle, tilt</source>
        <translation>Zugangswinkel, Neigung</translation>
    </message>
    <message>
        <source>Approach angle, rotation</source>
        <translation>Zugangswinkel, Drehung</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Speed of the scripted insertion</source>
        <translation>Geschwindigkeit der automatischen Insertion</translation>
    </message>
    <message>
        <source>Insertion depth at the start</source>
        <translation>Insertionstiefe zu Beginn</translation>
    </message>
    <message>
        <source>Travel at which the insertion stops</source>
        <translation>Vorschub, bei dem die Insertion endet</translation>
    </message>
    <message>
        <source>Speed of stylet withdrawal</source>
        <translation>Geschwindigkeit des Stilettrückzugs</translation>
    </message>
    <message>
        <source>Static friction coefficient</source>
        <translation>Haftreibungskoeffizient</translation>
    </message>
    <message>
        <source>Kinetic friction coefficient</source>
        <translation>Gleitreibungskoeffizient</translation>
    </message>
    <message>
        <source>Coefficient below which sliding stops</source>
        <translation>Koeffizient, unter dem das Gleiten endet</translation>
    </message>
    <message>
        <source>Stribeck speed of friction</source>
        <translation>Stribeck-Geschwindigkeit der Reibung</translation>
    </message>
    <message>
        <source>Fractions of the bending stiffness that relax</source>
        <translation>Anteile der Biegesteifigkeit, die relaxieren</translation>
    </message>
    <message>
        <source>Their time constants</source>
        <translation>Deren Zeitkonstanten</translation>
    </message>
    <message>
        <source>Fraction of the friction that relaxes at rest</source>
        <translation>Anteil der Reibung, der in Ruhe relaxiert</translation>
    </message>
    <message>
        <source>Its time constant</source>
        <translation>Dessen Zeitkonstante</translation>
    </message>
    <message>
        <source>Wall stiffness, normal</source>
        <translation>Wandsteifigkeit, normal</translation>
    </message>
    <message>
        <source>Wall stiffness, tangential</source>
        <translation>Wandsteifigkeit, tangential</translation>
    </message>
    <message>
        <source>Basilar membrane</source>
        <translation>Basilarmembran</translation>
    </message>
    <message>
        <source>Basilar membrane stiffness, if soft</source>
        <translation>Steifigkeit der Basilarmembran, falls weich</translation>
    </message>
    <message>
        <source>Strength of the cochlear partition, 0 if it never ruptures</source>
        <translation>Festigkeit der cochleären Trennwand, 0 ohne Ruptur</translation>
    </message>
    <message>
        <source>Calibrated scale of the array stiffness</source>
        <translation>Kalibrierter Faktor der Trägersteifigkeit</translation>
    </message>
    <message>
        <source>Calibrated residual curvature with stylet</source>
        <translation>Kalibrierte Restkrümmung mit Stilett</translation>
    </message>
    <message>
        <source>Array model</source>
        <translation>Modell des Trägers</translation>
    </message>
    <message>
        <source>Nodes of the array model</source>
        <translation>Knoten des Trägermodells</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Coupling to the input device</source>
        <translation>Kopplung an das Eingabegerät</translation>
    </message>
    <message>
        <source>Coupling stiffness, if a spring</source>
        <translation>Kopplungssteifigkeit, falls Feder</translation>
    </message>
    <message>
        <source>Coupling damping, if a spring</source>
        <translation>Kopplungsdämpfung, falls Feder</translation>
    </message>
    <message>
        <source>Force feedback gain</source>
        <translation>Kraftfaktor</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Startwert des Zufalls</translation>
    </message>
    <message>
        <source>published scala tympani</source>
        <translation>veröffentlichte Scala tympani</translation>
    </message>
    <message>
        <source>average of 15 human cochleae</source>
        <translation>Mittel aus 15 menschlichen Cochleae</translation>
    </message>
    <message>
        <source>Clark spiral</source>
        <translation>Clark-Spirale</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>wide opening (no edge contact)</source>
        <translation>weite Öffnung (kein Randkontakt)</translation>
    </message>
    <message>
        <source>round window</source>
        <translation>rundes Fenster</translation>
    </message>
    <message>
        <source>cochleostomy</source>
        <translation>Cochleostomie</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>advance off-stylet</source>
        <translation>Advance-off-Stylet</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>elastic rod</source>
        <translation>elastischer Stab</translation>
    </message>
    <message>
        <source>point set (published)</source>
        <translation>Punktmodell (veröffentlicht)</translation>
    </message>
    <message>
        <source>Standard deviation of the error of A</source>
        <translation>Standardabweichung des Fehlers von A</translation>
    </message>
    <message>
        <source>Standard deviation of the error of B</source>
        <translation>Standardabweichung des Fehlers von B</translation>
    </message>
    <message>
        <source>Standard deviation of the error of H</source>
        <translation>Standardabweichung des Fehlers von H</translation>
    </message>
    <message>
        <source>Withdrawal after the insertion</source>
        <translation>Rückzug nach der Insertion</translation>
    </message>
    <message>
        <source>Soft lining of the wall</source>
        <translation>Weiche Auskleidung der Wand</translation>
    </message>
    <message>
        <source>Depth over which the wall stiffens behind the opening</source>
        <translation>Tiefe, über die die Wand hinter der Öffnung steifer wird</translation>
    </message>
    <message>
        <source>Delay of the section&apos;s reach at an oval wall</source>
        <translation>Verzögerung der Reichweite eines ovalen Querschnitts</translation>
    </message>
    <message>
        <source>Stiffness of the opening&apos;s rim</source>
        <translation>Steifigkeit des Öffnungsrands</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Friction law</source>
        <translation>Reibungsgesetz</translation>
    </message>
    <message>
        <source>Speeds of the friction curve</source>
        <translation>Geschwindigkeiten der Reibungskurve</translation>
    </message>
    <message>
        <source>Friction coefficients at these speeds</source>
        <translation>Reibungskoeffizienten bei diesen Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Offset of the opening, toward the outer wall</source>
        <translation>Versatz der Öffnung zur Außenwand</translation>
    </message>
    <message>
        <source>Offset of the opening, toward the roof</source>
        <translation>Versatz der Öffnung zum Dach</translation>
    </message>
    <message>
        <source>Length of the drilled passage</source>
        <translation>Länge des Bohrkanals</translation>
    </message>
    <message>
        <source>Modulus of the array in the passage</source>
        <translation>Elastizitätsmodul des Trägers im Kanal</translation>
    </message>
    <message>
        <source>Friction in the passage</source>
        <translation>Reibung im Kanal</translation>
    </message>
    <message>
        <source>Energy lost where a rib leaves the passage</source>
        <translation>Energieverlust, wo ein Ring den Kanal verlässt</translation>
    </message>
    <message>
        <source>Force limit of the surgeon, 0 if none</source>
        <translation>Kraftgrenze des Operateurs, 0 ohne Grenze</translation>
    </message>
    <message>
        <source>Free length between opening and forceps</source>
        <translation>Freie Länge zwischen Öffnung und Pinzette</translation>
    </message>
    <message>
        <source>SD of ln friction, common to all ears</source>
        <translation>SD von ln Reibung, allen Ohren gemeinsam</translation>
    </message>
    <message>
        <source>SD of ln friction between ears</source>
        <translation>SD von ln Reibung zwischen Ohren</translation>
    </message>
    <message>
        <source>Yield stress of the wires</source>
        <translation>Fließspannung der Drähte</translation>
    </message>
    <message>
        <source>Yield stress of the stylet</source>
        <translation>Fließspannung des Stiletts</translation>
    </message>
    <message>
        <source>Packing of the wires of straight arrays</source>
        <translation>Packung der Drähte gerader Träger</translation>
    </message>
    <message>
        <source>Taper within the range of its file</source>
        <translation>Verjüngung im Bereich seiner Datei</translation>
    </message>
</context>
<context>
    <name>Study</name>
    <message>
        <source>A: basal-turn diameter, mm</source>
        <translation>A: Durchmesser der Basalwindung, mm</translation>
    </message>
    <message>
        <source>B: basal-turn width, mm</source>
        <translation>B: Breite der Basalwindung, mm</translation>
    </message>
    <message>
        <source>cochlear duct length, mm</source>
        <translation>Länge des Ductus cochlearis, mm</translation>
    </message>
    <message>
        <source>angular insertion depth, °</source>
        <translation>Insertionswinkel, °</translation>
    </message>
    <message>
        <source>cochlear coverage, %</source>
        <translation>Abdeckung der Cochlea, %</translation>
    </message>
    <message>
        <source>insertion depth, mm</source>
        <translation>Insertionstiefe, mm</translation>
    </message>
    <message>
        <source>maximum insertion depth, mm</source>
        <translation>größte Insertionstiefe, mm</translation>
    </message>
    <message>
        <source>peak insertion force, mN</source>
        <translation>maximale Insertionskraft, mN</translation>
    </message>
    <message>
        <source>depth of the peak force, mm</source>
        <translation>Tiefe der Maximalkraft, mm</translation>
    </message>
    <message>
        <source>final insertion force, mN</source>
        <translation>Insertionskraft am Ende, mN</translation>
    </message>
    <message>
        <source>maximum partition force, mN</source>
        <translation>maximale Kraft auf die Trennwand, mN</translation>
    </message>
    <message>
        <source>speed, mm/s</source>
        <translation>Geschwindigkeit, mm/s</translation>
    </message>
    <message>
        <source>depth at the start, mm</source>
        <translation>Tiefe zu Beginn, mm</translation>
    </message>
    <message>
        <source>stop travel, mm</source>
        <translation>Vorschub am Stopp, mm</translation>
    </message>
    <message>
        <source>approach angle, tilt, °</source>
        <translation>Zugangswinkel, Neigung, °</translation>
    </message>
    <message>
        <source>approach angle, rotation, °</source>
        <translation>Zugangswinkel, Drehung, °</translation>
    </message>
    <message>
        <source>static friction coefficient</source>
        <translation>Haftreibungskoeffizient</translation>
    </message>
    <message>
        <source>kinetic friction coefficient</source>
        <translation>Gleitreibungskoeffizient</translation>
    </message>
    <message>
        <source>nodes of the array model</source>
        <translation>Knoten des Trägermodells</translation>
    </message>
    <message>
        <source>time step, ms</source>
        <translation>Zeitschritt, ms</translation>
    </message>
    <message>
        <source>array</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>basilar membrane</source>
        <translation>Basilarmembran</translation>
    </message>
    <message>
        <source>array model</source>
        <translation>Trägermodell</translation>
    </message>
    <message>
        <source>anatomy</source>
        <translation>Anatomie</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>buckled</source>
        <translation>ausgeknickt</translation>
    </message>
    <message>
        <source>stopped with a fault</source>
        <translation>mit Fehler gestoppt</translation>
    </message>
    <message>
        <source>could not be prepared</source>
        <translation>nicht vorbereitbar</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>advance off-stylet</source>
        <translation>Advance-off-Stylet</translation>
    </message>
    <message>
        <source>wide opening</source>
        <translation>weite Öffnung</translation>
    </message>
    <message>
        <source>round window</source>
        <translation>rundes Fenster</translation>
    </message>
    <message>
        <source>cochleostomy</source>
        <translation>Cochleostomie</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>tissue-like</source>
        <translation>gewebeähnlich</translation>
    </message>
    <message>
        <source>average</source>
        <translation>mittlere</translation>
    </message>
    <message>
        <source>slipped out of the opening</source>
        <translation>aus der Öffnung gerutscht</translation>
    </message>
    <message>
        <source>stopped by resistance</source>
        <translation>durch Widerstand gestoppt</translation>
    </message>
    <message>
        <source>folded tip</source>
        <translation>umgeschlagene Spitze</translation>
    </message>
    <message>
        <source>jammed</source>
        <translation>verklemmt</translation>
    </message>
    <message>
        <source>outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>input coupling</source>
        <translation>Kopplung der Eingabe</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>Simulated cochlea %1</source>
        <translation>Simulierte Cochlea %1</translation>
    </message>
    <message>
        <source>Average cochlea</source>
        <translation>Mittlere Cochlea</translation>
    </message>
    <message>
        <source>insertion</source>
        <translation>Insertion</translation>
    </message>
    <message>
        <source>cochlea</source>
        <translation>Cochlea</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>all that ran</source>
        <translation>alle ausgeführten</translation>
    </message>
    <message>
        <source>complete only</source>
        <translation>nur vollständige</translation>
    </message>
    <message>
        <source>scala tympani length, mm</source>
        <translation>Länge der Scala tympani, mm</translation>
    </message>
    <message>
        <source>force limit, mN</source>
        <translation>Kraftgrenze, mN</translation>
    </message>
</context>
<context>
    <name>TakeAway</name>
    <message>
        <source>Cochlear implant insertion, simulated</source>
        <translation>Insertion eines Cochlea-Implantats, simuliert</translation>
    </message>
    <message>
        <source>Array: %1</source>
        <translation>Elektrode: %1</translation>
    </message>
    <message>
        <source>Depth: %1 mm</source>
        <translation>Tiefe: %1 mm</translation>
    </message>
    <message>
        <source>Peak force: %1 mN (%2)</source>
        <translation>Maximalkraft: %1 mN (%2)</translation>
    </message>
    <message>
        <source>Peak force: %1 mN</source>
        <translation>Maximalkraft: %1 mN</translation>
    </message>
    <message>
        <source>Rank today: %1 of %2</source>
        <translation>Rang heute: %1 von %2</translation>
    </message>
    <message>
        <source>Depth in mm: force in mN</source>
        <translation>Tiefe in mm: Kraft in mN</translation>
    </message>
</context>
<context>
    <name>perilymph::gui</name>
    <message>
        <source>none stated</source>
        <translation>keine genannt</translation>
    </message>
    <message>
        <source>The plan states no CT series, or carries no seal, so it was not compared with the study that this report was filed into.</source>
        <translation>Der Plan nennt keine CT-Serie oder trägt kein Siegel und wurde deshalb nicht mit der Untersuchung verglichen, in die dieser Bericht eingeordnet wurde.</translation>
    </message>
    <message>
        <source>%1, no seal</source>
        <translation>%1, ohne Siegel</translation>
    </message>
    <message>
        <source>changed by hand</source>
        <translation>von Hand geändert</translation>
    </message>
    <message>
        <source>precurved</source>
        <translation>vorgekrümmt</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 contacts</source>
        <translation>%1 Kontakte</translation>
    </message>
    <message>
        <source>%1 mN</source>
        <translation>%1 mN</translation>
    </message>
    <message>
        <source>axial, %1</source>
        <translation>axial, %1</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1 mJ</translation>
    </message>
    <message>
        <source>length of array past the opening</source>
        <translation>Länge des Trägers jenseits der Öffnung</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Am Ende</translation>
    </message>
    <message>
        <source>%1, %2°</source>
        <translation>%1, %2°</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Rückzüge</translation>
    </message>
    <message>
        <source>of the curve smoothed over 0.5 mm</source>
        <translation>der über 0,5 mm geglätteten Kurve</translation>
    </message>
    <message>
        <source>%1 %: %2</source>
        <translation>%1 %: %2</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Bytes</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>Aufgezeichnet von</translation>
    </message>
    <message>
        <source>Report by</source>
        <translation>Bericht von</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>travel, mm</source>
        <translation>Vorschub, mm</translation>
    </message>
    <message>
        <source>force, mN</source>
        <translation>Kraft, mN</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>this insertion</source>
        <translation>diese Insertion</translation>
    </message>
    <message>
        <source>axial</source>
        <translation>axial</translation>
    </message>
    <message>
        <source>lateral</source>
        <translation>lateral</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>vertikal</translation>
    </message>
    <message>
        <source>outer wall</source>
        <translation>Außenwand</translation>
    </message>
    <message>
        <source>modiolus</source>
        <translation>Modiolus</translation>
    </message>
    <message>
        <source>basilar membrane</source>
        <translation>Basilarmembran</translation>
    </message>
    <message>
        <source>wall force, 50 mN per mm</source>
        <translation>Wandkraft, 50 mN je mm</translation>
    </message>
    <message>
        <source>wall force %1 mN</source>
        <translation>Wandkraft %1 mN</translation>
    </message>
    <message>
        <source>wall force, mN per mm</source>
        <translation>Wandkraft, mN je mm</translation>
    </message>
    <message>
        <source>angle from round window, °; width, mm</source>
        <translation>Winkel ab rundem Fenster, °; Breite, mm</translation>
    </message>
    <message>
        <source>NOT recording</source>
        <translation>KEINE Aufzeichnung</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>not started</source>
        <translation>nicht gestartet</translation>
    </message>
    <message>
        <source>%1 overruns</source>
        <translation>%1 Überläufe</translation>
    </message>
    <message>
        <source>coupling %1 N/m</source>
        <translation>Kopplung %1 N/m</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>not a medical device</source>
        <translation>kein Medizinprodukt</translation>
    </message>
    <message>
        <source>The insertion was stopped.</source>
        <translation>Die Insertion wurde angehalten.</translation>
    </message>
    <message>
        <source>This insertion is not being recorded: %1</source>
        <translation>Diese Insertion wird nicht aufgezeichnet: %1</translation>
    </message>
    <message>
        <source>Building the cochlea…</source>
        <translation>Die Cochlea wird berechnet …</translation>
    </message>
    <message>
        <source>no stylet</source>
        <translation>kein Stilett</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>withdraw</source>
        <translation>zurückziehen</translation>
    </message>
    <message>
        <source>follow the tip</source>
        <translation>der Spitze folgen</translation>
    </message>
    <message>
        <source>stereo: off, anaglyph, side by side, interlaced</source>
        <translation>Stereo: aus, Anaglyphe, nebeneinander, zeilenweise</translation>
    </message>
    <message>
        <source>Drag; Shift+drag</source>
        <translation>Ziehen; Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>Wheel, Ctrl+wheel</source>
        <translation>Rad, Strg+Rad</translation>
    </message>
    <message>
        <source>Space; Esc</source>
        <translation>Leertaste; Esc</translation>
    </message>
    <message>
        <source>play or pause; back to the insertion</source>
        <translation>abspielen oder anhalten; zurück zur Insertion</translation>
    </message>
    <message>
        <source>Left, Right; with Shift</source>
        <translation>Links, Rechts; mit Umschalt</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Pos1, Ende</translation>
    </message>
    <message>
        <source>,  .</source>
        <translation>,  .</translation>
    </message>
    <message>
        <source>slower, faster</source>
        <translation>langsamer, schneller</translation>
    </message>
    <message>
        <source>one, two, four views</source>
        <translation>eine, zwei, vier Ansichten</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>hide or show the panel</source>
        <translation>Seitenleiste aus- oder einblenden</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>user guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Press Start, then hold the device button and advance.</source>
        <translation>Start drücken, dann die Gerätetaste halten und vorschieben.</translation>
    </message>
    <message>
        <source>Coupling stiffness limited to %1 N/m: see Devices (H).</source>
        <translation>Kopplungssteifigkeit begrenzt auf %1 N/m: siehe Geräte (H).</translation>
    </message>
    <message>
        <source>Hold the device button: the array follows the device.</source>
        <translation>Gerätetaste halten: Der Träger folgt dem Gerät.</translation>
    </message>
    <message>
        <source>Holding. Release the button to stop.</source>
        <translation>Gehalten. Taste loslassen zum Anhalten.</translation>
    </message>
    <message>
        <source>recording, %1 samples lost</source>
        <translation>Aufzeichnung, %1 Abtastwerte verloren</translation>
    </message>
    <message>
        <source>late samples: %1</source>
        <translation>verspätete Abtastwerte: %1</translation>
    </message>
    <message>
        <source>The input device stopped responding.</source>
        <translation>Das Eingabegerät antwortet nicht mehr.</translation>
    </message>
    <message>
        <source>The simulation became unstable and was stopped.</source>
        <translation>Die Simulation wurde instabil und wurde angehalten.</translation>
    </message>
    <message>
        <source> The force is off and the array is stationary. Press Reset to start again.</source>
        <translation> Die Kraft ist aus, der Träger steht. „Zurücksetzen“ drücken, um neu zu beginnen.</translation>
    </message>
    <message>
        <source>Full depth. Press Withdraw or Reset.</source>
        <translation>Volle Tiefe. „Zurückziehen“ oder „Zurücksetzen“ drücken.</translation>
    </message>
    <message>
        <source>The array is withdrawn. Press Reset for a new insertion.</source>
        <translation>Der Träger ist zurückgezogen. „Zurücksetzen“ für eine neue Insertion.</translation>
    </message>
    <message>
        <source>Building the cochlea; the insertion then starts…</source>
        <translation>Die Cochlea wird berechnet; dann beginnt die Insertion …</translation>
    </message>
    <message>
        <source>%1 mm withdrawn</source>
        <translation>%1 mm zurückgezogen</translation>
    </message>
    <message>
        <source>maximum of %1 recorded samples</source>
        <translation>Maximum von %1 aufgezeichneten Abtastwerten</translation>
    </message>
    <message>
        <source>Peak insertion force</source>
        <translation>Maximalkraft</translation>
    </message>
    <message>
        <source>%1 at %2 travel, insertion depth %3</source>
        <translation>%1 bei %2 Vorschub, Insertionstiefe %3</translation>
    </message>
    <message>
        <source>Maximum wall force</source>
        <translation>Maximale Wandkraft</translation>
    </message>
    <message>
        <source>normal to the wall, at one node; %1</source>
        <translation>normal zur Wand, an einem Knoten; %1</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>Maximum force on the cochlear partition</source>
        <translation>Maximale Kraft auf die cochleäre Trennwand</translation>
    </message>
    <message>
        <source>Insertion work</source>
        <translation>Insertionsarbeit</translation>
    </message>
    <message>
        <source>integral of force over displacement (trapezoidal rule)</source>
        <translation>Integral der Kraft über den Vorschub (Trapezregel)</translation>
    </message>
    <message>
        <source>Maximum insertion depth</source>
        <translation>Maximale Insertionstiefe</translation>
    </message>
    <message>
        <source>withdrawal of 0.1 mm or more</source>
        <translation>Rückzug um mindestens 0,1 mm</translation>
    </message>
    <message>
        <source>Basal-turn peak</source>
        <translation>Maximum in der Basalwindung</translation>
    </message>
    <message>
        <source>%1 at %2 travel</source>
        <translation>%1 bei %2 Vorschub</translation>
    </message>
    <message>
        <source>Samples not converged</source>
        <translation>Nicht konvergierte Abtastwerte</translation>
    </message>
    <message>
        <source>solver residual above tolerance</source>
        <translation>Residuum des Lösers über der Toleranz</translation>
    </message>
    <message>
        <source>Technique score</source>
        <translation>Bewertung der Technik</translation>
    </message>
    <message>
        <source>Simulation parameters</source>
        <translation>Simulationsparameter</translation>
    </message>
    <message>
        <source>Forces are computed with a model, not measured in an ear.</source>
        <translation>Die Kräfte sind mit einem Modell berechnet, nicht im Ohr gemessen.</translation>
    </message>
    <message>
        <source>The array model is based on published data and is not manufacturer data.</source>
        <translation>Das Modell des Trägers beruht auf veröffentlichten Daten und ist keine Herstellerangabe.</translation>
    </message>
    <message>
        <source>No value in this report shows that an insertion is atraumatic: trauma thresholds vary between ears and are not known for the insertion force.</source>
        <translation>Kein Wert in diesem Bericht belegt eine atraumatische Insertion: Traumaschwellen sind von Ohr zu Ohr verschieden und für die Insertionskraft nicht bekannt.</translation>
    </message>
    <message>
        <source>%1 samples were lost during recording.</source>
        <translation>%1 Abtastwerte gingen bei der Aufzeichnung verloren.</translation>
    </message>
    <message>
        <source>Replay verified: %1 samples identical</source>
        <translation>Wiedergabe geprüft: %1 Abtastwerte identisch</translation>
    </message>
    <message>
        <source>computed by version %1; not recomputed</source>
        <translation>berechnet mit Version %1; nicht neu berechnet</translation>
    </message>
    <message>
        <source>differs from sample %1, in %2</source>
        <translation>weicht ab Abtastwert %1 ab, in %2</translation>
    </message>
    <message>
        <source>could not be verified</source>
        <translation>konnte nicht geprüft werden</translation>
    </message>
    <message>
        <source>Traceability</source>
        <translation>Rückverfolgbarkeit</translation>
    </message>
    <message>
        <source>hash of cochlea, array and physical parameters</source>
        <translation>Prüfsumme von Cochlea, Träger und physikalischen Parametern</translation>
    </message>
    <message>
        <source>Array file</source>
        <translation>Datei des Trägers</translation>
    </message>
    <message>
        <source>hash</source>
        <translation>Prüfsumme</translation>
    </message>
    <message>
        <source>Insertion report</source>
        <translation>Insertionsbericht</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>perception threshold %1 mN</source>
        <translation>Wahrnehmungsschwelle %1 mN</translation>
    </message>
    <message>
        <source>tip is outside the cochlea</source>
        <translation>Spitze außerhalb der Cochlea</translation>
    </message>
    <message>
        <source>no contact inserted yet</source>
        <translation>noch kein Kontakt inseriert</translation>
    </message>
    <message>
        <source>mean %1 mm, %2 inserted</source>
        <translation>Mittel %1 mm, %2 inseriert</translation>
    </message>
    <message>
        <source>contact force (arrow %1 mm = %2 mN)</source>
        <translation>Kontaktkraft (Pfeil %1 mm = %2 mN)</translation>
    </message>
    <message>
        <source>friction force (arrows enlarged %1×)</source>
        <translation>Reibkraft (Pfeile %1-fach)</translation>
    </message>
    <message>
        <source>published measurements, mean ± SD</source>
        <translation>veröffentlichte Messungen, Mittelwert ± SD</translation>
    </message>
    <message>
        <source>round trip %1 ms</source>
        <translation>Umlaufzeit %1 ms</translation>
    </message>
    <message>
        <source>round trip at most %1 ms</source>
        <translation>Umlaufzeit höchstens %1 ms</translation>
    </message>
    <message>
        <source>device disconnected</source>
        <translation>Gerät getrennt</translation>
    </message>
    <message>
        <source>device %1 reports/s, jitter %2 ms</source>
        <translation>Gerät %1 Berichte/s, Jitter %2 ms</translation>
    </message>
    <message>
        <source>below perception threshold (%1 mN)</source>
        <translation>unter der Wahrnehmungsschwelle (%1 mN)</translation>
    </message>
    <message>
        <source>perceptible (above %1 mN)</source>
        <translation>wahrnehmbar (über %1 mN)</translation>
    </message>
    <message>
        <source>perceptible; within reported clinical peak forces (%1–%2 mN)</source>
        <translation>wahrnehmbar; im Bereich klinischer Maximalkräfte (%1–%2 mN)</translation>
    </message>
    <message>
        <source>above reported clinical peak forces (&gt; %1 mN)</source>
        <translation>über den berichteten klinischen Maximalkräften (&gt; %1 mN)</translation>
    </message>
    <message>
        <source>cochlear partition ruptured at %1° by %2 mN</source>
        <translation>cochleäre Trennwand bei %1° mit %2 mN rupturiert</translation>
    </message>
    <message>
        <source>translocation: partition ruptured at %1° by %2 mN, %3 mm above it</source>
        <translation>Translokation: Trennwand bei %1° mit %2 mN rupturiert, %3 mm darüber</translation>
    </message>
    <message>
        <source>force on the cochlear partition not recorded</source>
        <translation>Kraft auf die cochleäre Trennwand nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>cochlear partition %1 mN</source>
        <translation>cochleäre Trennwand %1 mN</translation>
    </message>
    <message>
        <source>138 cochleae (Pietsch et al. 2017, Sci Rep).</source>
        <translation>138 Cochleae (Pietsch et al. 2017, Sci Rep).</translation>
    </message>
    <message>
        <source>Mean %1 mm, n = 15 (Froehlich et al. 2024); cross-sections vary by 9–15 % (Avci et al. 2014).</source>
        <translation>Mittelwert %1 mm, n = 15 (Froehlich et al. 2024); Querschnitte variieren um 9–15 % (Avci et al. 2014).</translation>
    </message>
    <message>
        <source>Definitions of H vary between publications; only limits are given.</source>
        <translation>H ist in der Literatur unterschiedlich definiert; nur Grenzen sind angegeben.</translation>
    </message>
    <message>
        <source>start or pause; hold the array (mouse and keyboard)</source>
        <translation>starten oder anhalten; Träger halten (Maus und Tastatur)</translation>
    </message>
    <message>
        <source>advance or withdraw the held array</source>
        <translation>gehaltenen Träger vorschieben oder zurückziehen</translation>
    </message>
    <message>
        <source>reset: new insertion and recording</source>
        <translation>zurücksetzen: neue Insertion und Aufzeichnung</translation>
    </message>
    <message>
        <source>undo or redo a setup change</source>
        <translation>Änderung der Einstellungen rückgängig machen oder wiederholen</translation>
    </message>
    <message>
        <source>withdraw the stylet</source>
        <translation>Stilett zurückziehen</translation>
    </message>
    <message>
        <source>surgeon’s view, through the opening, overview, basal-turn section</source>
        <translation>Sicht des Operateurs, durch die Öffnung, Übersicht, Schnitt der Basalwindung</translation>
    </message>
    <message>
        <source>rotate the model</source>
        <translation>Modell drehen</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>vergrößern oder verkleinern</translation>
    </message>
    <message>
        <source>rotate the model; pan</source>
        <translation>Modell drehen; verschieben</translation>
    </message>
    <message>
        <source>step by 1 ms; by 100 ms</source>
        <translation>um 1 ms springen; um 100 ms</translation>
    </message>
    <message>
        <source>go to start, to end</source>
        <translation>zum Anfang, zum Ende</translation>
    </message>
    <message>
        <source>cycle one, two or four views</source>
        <translation>zwischen einer, zwei und vier Ansichten wechseln</translation>
    </message>
    <message>
        <source>maximize a view; restore</source>
        <translation>Ansicht maximieren; wiederherstellen</translation>
    </message>
    <message>
        <source>devices: list and connection quality</source>
        <translation>Geräte: Liste und Verbindungsqualität</translation>
    </message>
    <message>
        <source>leave the field</source>
        <translation>Feld verlassen</translation>
    </message>
    <message>
        <source>full screen on or off</source>
        <translation>Vollbild ein oder aus</translation>
    </message>
    <message>
        <source>save a screenshot</source>
        <translation>Bildschirmfoto speichern</translation>
    </message>
    <message>
        <source>keyboard and mouse reference</source>
        <translation>Tasten- und Mausübersicht</translation>
    </message>
    <message>
        <source>next button or field</source>
        <translation>nächste Schaltfläche oder nächstes Feld</translation>
    </message>
    <message>
        <source>Screenshot saved: %1</source>
        <translation>Bildschirmfoto gespeichert: %1</translation>
    </message>
    <message>
        <source>insertion force, mN</source>
        <translation>Insertionskraft, mN</translation>
    </message>
    <message>
        <source>%1 ± %2 mm</source>
        <translation>%1 ± %2 mm</translation>
    </message>
    <message>
        <source>no population mean available</source>
        <translation>kein Populationsmittel verfügbar</translation>
    </message>
    <message>
        <source>A: basal-turn diameter</source>
        <translation>A: Basalwindung, Durchmesser</translation>
    </message>
    <message>
        <source>of the model</source>
        <translation>des Modells</translation>
    </message>
    <message>
        <source>B: basal-turn width</source>
        <translation>B: Basalwindung, Breite</translation>
    </message>
    <message>
        <source>H: cochlear height</source>
        <translation>H: Höhe der Cochlea</translation>
    </message>
    <message>
        <source>Organ of Corti length</source>
        <translation>Länge des Corti-Organs</translation>
    </message>
    <message>
        <source>Scala width at round window</source>
        <translation>Skalenbreite am runden Fenster</translation>
    </message>
    <message>
        <source>Scala height at round window</source>
        <translation>Skalenhöhe am runden Fenster</translation>
    </message>
    <message>
        <source>Cochlear duct length (CDL)</source>
        <translation>Ductus cochlearis (CDL)</translation>
    </message>
    <message>
        <source>elliptic-circular; ± holds what A alone gives</source>
        <translation>elliptisch-zirkulär; ± umfasst den Wert aus A allein</translation>
    </message>
    <message>
        <source>Cochlear coverage</source>
        <translation>Abdeckung der Cochlea</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>organ of Corti basal to the most apical contact</source>
        <translation>Corti-Organ basal des apikalsten Kontakts</translation>
    </message>
    <message>
        <source>Cochlea, CT measurements ± 95 % interval</source>
        <translation>Cochlea, CT-Messwerte ± 95-%-Intervall</translation>
    </message>
    <message>
        <source>Cochlea, measures ± 95 % interval</source>
        <translation>Cochlea, Maße ± 95-%-Intervall</translation>
    </message>
    <message>
        <source>Cochlea: average of 15 human cochleae</source>
        <translation>Cochlea: Mittel aus 15 menschlichen Cochleae</translation>
    </message>
    <message>
        <source>Cochlea: model</source>
        <translation>Cochlea: Modell</translation>
    </message>
    <message>
        <source>left ear</source>
        <translation>linkes Ohr</translation>
    </message>
    <message>
        <source>right ear</source>
        <translation>rechtes Ohr</translation>
    </message>
    <message>
        <source>No patient · %1</source>
        <translation>Kein Patient · %1</translation>
    </message>
    <message>
        <source>Patient %1 · %2</source>
        <translation>Patient %1 · %2</translation>
    </message>
    <message>
        <source>%1, %2 (%3)</source>
        <translation>%1, %2 (%3)</translation>
    </message>
    <message>
        <source>Advance off-stylet</source>
        <translation>Advance-off-Stylet</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>%1; scripted insertion, %2 mm/s</source>
        <translation>%1; automatische Insertion, %2 mm/s</translation>
    </message>
    <message>
        <source>mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Patient code</source>
        <translation>Patientencode</translation>
    </message>
    <message>
        <source>Ear</source>
        <translation>Ohr</translation>
    </message>
    <message>
        <source>Electrode array</source>
        <translation>Elektrodenträger</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Hersteller</translation>
    </message>
    <message>
        <source>Institution</source>
        <translation>Einrichtung</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operateur</translation>
    </message>
    <message>
        <source>Date and time</source>
        <translation>Datum und Uhrzeit</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>at insertion depth %1 mm</source>
        <translation>bei Insertionstiefe %1 mm</translation>
    </message>
    <message>
        <source>Angular insertion depth</source>
        <translation>Insertionswinkel</translation>
    </message>
    <message>
        <source>Insertion depth</source>
        <translation>Insertionstiefe</translation>
    </message>
    <message>
        <source>past the opening</source>
        <translation>jenseits der Öffnung</translation>
    </message>
    <message>
        <source>Insertion time</source>
        <translation>Insertionsdauer</translation>
    </message>
    <message>
        <source>Maximum partition force</source>
        <translation>Maximale Trennwandkraft</translation>
    </message>
    <message>
        <source>Contacts, numbered from the tip</source>
        <translation>Kontakte, gezählt ab der Spitze</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Angle, °</source>
        <translation>Winkel, °</translation>
    </message>
    <message>
        <source>To modiolus, mm</source>
        <translation>Modiolus, mm</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Tiefe, mm</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Unterschrift</translation>
    </message>
    <message>
        <source>Simulation for research and training. Not a medical device; must not be used for patient care.</source>
        <translation>Simulation für Forschung und Training. Kein Medizinprodukt; darf nicht für die Patientenversorgung verwendet werden.</translation>
    </message>
    <message>
        <source>Limits: computed with a model based on published data, not measured in an ear and not manufacturer data; no value shows that an insertion is atraumatic.</source>
        <translation>Grenzen: mit einem Modell nach veröffentlichten Daten berechnet, nicht im Ohr gemessen und keine Herstellerangaben; kein Wert belegt eine atraumatische Insertion.</translation>
    </message>
    <message>
        <source>confidence high</source>
        <translation>Konfidenz hoch</translation>
    </message>
    <message>
        <source>confidence medium</source>
        <translation>Konfidenz mittel</translation>
    </message>
    <message>
        <source>confidence low</source>
        <translation>Konfidenz niedrig</translation>
    </message>
    <message>
        <source>Array: sources of the values</source>
        <translation>Träger: Quellen der Werte</translation>
    </message>
    <message>
        <source>Appendix: data for reproduction</source>
        <translation>Anhang: Daten zur Reproduktion</translation>
    </message>
    <message>
        <source>All results</source>
        <translation>Alle Ergebnisse</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>For research and training. Not a medical device.</source>
        <translation>Für Forschung und Training. Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Cochlear view</source>
        <translation>Cochleaansicht</translation>
    </message>
    <message>
        <source>Mid-modiolar, along A</source>
        <translation>Mittmodiolar, entlang A</translation>
    </message>
    <message>
        <source>Mid-modiolar, along B</source>
        <translation>Mittmodiolar, entlang B</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Round window</source>
        <translation>Rundes Fenster</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Apex</translation>
    </message>
    <message>
        <source>Modiolus</source>
        <translation>Modiolus</translation>
    </message>
    <message>
        <source>apex</source>
        <translation>Apex</translation>
    </message>
    <message>
        <source>Cochlear view: the center of the round window, where the basal turn opens.</source>
        <translation>Cochleaansicht: Mitte des runden Fensters, wo sich die Basalwindung öffnet.</translation>
    </message>
    <message>
        <source>Mid-modiolar view: the lowest point of the basal turn’s bony lumen.</source>
        <translation>Mittmodiolare Ansicht: tiefster Punkt des knöchernen Lumens der Basalwindung.</translation>
    </message>
    <message>
        <source>Mid-modiolar view: the highest point of the apical turn’s bony lumen.</source>
        <translation>Mittmodiolare Ansicht: höchster Punkt des knöchernen Lumens der apikalen Windung.</translation>
    </message>
    <message>
        <source>Cochlear view: the center of the modiolus in the basal turn.</source>
        <translation>Cochleaansicht: Mitte des Modiolus in der Basalwindung.</translation>
    </message>
    <message>
        <source>95 % interval. Standard deviations: noise and voxels %1 mm, shape model %2 mm, position of the round window %3 mm.</source>
        <translation>95-%-Intervall. Standardabweichungen: Rauschen und Voxel %1 mm, Formmodell %2 mm, Position des runden Fensters %3 mm.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Insertable length</source>
        <translation>Insertierbare Länge</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Bending stiffness</source>
        <translation>Biegesteifigkeit</translation>
    </message>
    <message>
        <source>Bending stiffness, other axis</source>
        <translation>Biegesteifigkeit, andere Achse</translation>
    </message>
    <message>
        <source>Torsional stiffness</source>
        <translation>Torsionssteifigkeit</translation>
    </message>
    <message>
        <source>Curvature at rest</source>
        <translation>Krümmung in Ruhe</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Marker ribs</source>
        <translation>Markierungsringe</translation>
    </message>
    <message>
        <source>Stylet</source>
        <translation>Stilett</translation>
    </message>
    <message>
        <source>in place</source>
        <translation>eingelegt</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Input device</source>
        <translation>Eingabegerät</translation>
    </message>
    <message>
        <source>another array (%1)</source>
        <translation>anderer Träger (%1)</translation>
    </message>
    <message>
        <source>another cochlea (%1)</source>
        <translation>andere Cochlea (%1)</translation>
    </message>
    <message>
        <source>%1 is saved already; open that patient, or use another code.</source>
        <translation>%1 ist schon gespeichert; diesen Patienten öffnen oder einen anderen Code verwenden.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>A %1, B %2, H %3 mm</source>
        <translation>A %1, B %2, H %3 mm</translation>
    </message>
    <message>
        <source>A %1, B %2 mm</source>
        <translation>A %1, B %2 mm</translation>
    </message>
    <message>
        <source>scala %1 mm, section %2 × %3 mm</source>
        <translation>Scala %1 mm, Schnitt %2 × %3 mm</translation>
    </message>
    <message>
        <source>Smaller cochleae are more than 4 SD below the mean of 138: hypoplastic or malformed, which this model does not describe.</source>
        <translation>Kleinere Cochleae liegen mehr als 4 SD unter dem Mittel von 138: hypoplastisch oder fehlgebildet; das beschreibt dieses Modell nicht.</translation>
    </message>
    <message>
        <source>A: in the cochlear view, from the center of the round window through the modiolus to the far lateral wall.</source>
        <translation>A: in der Cochleaansicht von der Mitte des runden Fensters durch den Modiolus zur gegenüberliegenden Außenwand.</translation>
    </message>
    <message>
        <source>B: in the same view, perpendicular to A through the modiolus, from lateral wall to lateral wall.</source>
        <translation>B: in derselben Ansicht senkrecht zu A durch den Modiolus, von Außenwand zu Außenwand.</translation>
    </message>
    <message>
        <source>H: in the view perpendicular to the cochlear view, along the modiolar axis from the base to the apex.</source>
        <translation>H: in der Ansicht senkrecht zur Cochleaansicht, entlang der Modiolusachse von der Basis zum Apex.</translation>
    </message>
    <message>
        <source>Not visible in clinical CT; from micro-CT or histology.</source>
        <translation>Im klinischen CT nicht sichtbar; aus Mikro-CT oder Histologie.</translation>
    </message>
    <message>
        <source>%1 — Perilymph</source>
        <translation>%1 — Perilymph</translation>
    </message>
    <message>
        <source>Replay of %1 — Perilymph</source>
        <translation>Wiedergabe von %1 — Perilymph</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Stopped as set; %1 mm of the array remains outside. Press Withdraw or Reset.</source>
        <translation>Wie eingestellt gestoppt; %1 mm des Trägers bleiben außerhalb. „Zurückziehen“ oder „Zurücksetzen“ drücken.</translation>
    </message>
    <message>
        <source>Back at the start, tip %1 mm inside. Press Reset for a new insertion.</source>
        <translation>Zurück am Start, Spitze %1 mm innen. „Zurücksetzen“ für eine neue Insertion.</translation>
    </message>
    <message>
        <source>Press Start, then hold Space and scroll down or press ↓ to advance.</source>
        <translation>Start drücken, dann Leertaste halten und abwärts scrollen oder ↓ drücken.</translation>
    </message>
    <message>
        <source>Hold Space, then scroll down or press ↓ to advance.</source>
        <translation>Leertaste halten, dann abwärts scrollen oder ↓ drücken, um vorzuschieben.</translation>
    </message>
    <message>
        <source>Holding. Scroll down or press ↓ to advance, scroll up or press ↑ to withdraw.</source>
        <translation>Gehalten. Abwärts scrollen oder ↓ schiebt vor, aufwärts scrollen oder ↑ zieht zurück.</translation>
    </message>
    <message>
        <source>Advance of the array since the start of the insertion. Insertion depth: length past the round window.</source>
        <translation>Vorschub des Trägers seit Beginn der Insertion. Insertionstiefe: Länge jenseits des runden Fensters.</translation>
    </message>
    <message>
        <source>Axial force on the hand that inserts the array; positive while it pushes in.</source>
        <translation>Axiale Kraft zum Vorschieben des Trägers; positiv beim Einführen.</translation>
    </message>
    <message>
        <source>Speed of the array along the insertion axis.</source>
        <translation>Geschwindigkeit des Trägers entlang der Insertionsachse.</translation>
    </message>
    <message>
        <source>Magnification of a surgical microscope with the same field.</source>
        <translation>Vergrößerung eines Operationsmikroskops mit demselben Sehfeld.</translation>
    </message>
    <message>
        <source>full insertion of this array</source>
        <translation>vollständige Insertion dieses Trägers</translation>
    </message>
    <message>
        <source>partial insertion: %1 mm of the array outside</source>
        <translation>partielle Insertion: %1 mm des Trägers außerhalb</translation>
    </message>
    <message>
        <source>%1: stop at %2 mm, %3.</source>
        <translation>%1: Stopp bei %2 mm, %3.</translation>
    </message>
    <message>
        <source>advance (down) or withdraw (up) the held array</source>
        <translation>gehaltenen Träger vorschieben (abwärts) oder zurückziehen (aufwärts)</translation>
    </message>
    <message>
        <source>quit</source>
        <translation>beenden</translation>
    </message>
    <message>
        <source>recording (paused)</source>
        <translation>Aufzeichnung (pausiert)</translation>
    </message>
    <message>
        <source>Stopped: the force is off. Press Start to continue.</source>
        <translation>Gestoppt: Die Kraft ist aus. Zum Fortfahren „Start“ drücken.</translation>
    </message>
    <message>
        <source>remove the force of a device; close the open panel; release the array</source>
        <translation>Kraft eines Geräts abschalten; offenes Feld schließen; Träger loslassen</translation>
    </message>
    <message>
        <source>Modified (%1): %2</source>
        <translation>Geändert (%1): %2</translation>
    </message>
    <message>
        <source>Stopped by resistance at %1 mm, %2 mN. Press Withdraw or Reset.</source>
        <translation>Bei %1 mm und %2 mN durch Widerstand gestoppt. „Zurückziehen“ oder „Zurücksetzen“ drücken.</translation>
    </message>
    <message>
        <source>The array buckled in front of the opening. The force is off. Press Withdraw or Reset.</source>
        <translation>Der Träger ist vor der Öffnung ausgeknickt. Die Kraft ist aus. „Zurückziehen“ oder „Zurücksetzen“ drücken.</translation>
    </message>
    <message>
        <source>The tip has left the cochlea. The force is off. Press Reset.</source>
        <translation>Die Spitze hat die Cochlea verlassen. Die Kraft ist aus. „Zurücksetzen“ drücken.</translation>
    </message>
    <message>
        <source>The tip folded over at %1 mm. The force is off. Press Withdraw or Reset.</source>
        <translation>Die Spitze ist bei %1 mm umgeschlagen. Die Kraft ist aus. „Zurückziehen“ oder „Zurücksetzen“ drücken.</translation>
    </message>
    <message>
        <source>The array jammed at %1 mm. The force is off. Press Withdraw or Reset.</source>
        <translation>Der Träger ist bei %1 mm verklemmt. Die Kraft ist aus. „Zurückziehen“ oder „Zurücksetzen“ drücken.</translation>
    </message>
    <message>
        <source>Fraction of the organ of Corti that is basal to the most apical contact.</source>
        <translation>Anteil des Corti-Organs, der basal des apikalsten Kontakts liegt.</translation>
    </message>
    <message>
        <source>Outlined: %1 to %2 %, for orientation; studies differ. %3</source>
        <translation>Umrandet: %1 bis %2 %, zur Orientierung; Studien widersprechen sich. %3</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Maximalkraft</translation>
    </message>
    <message>
        <source>End force</source>
        <translation>Endkraft</translation>
    </message>
    <message>
        <source>Force over depth</source>
        <translation>Kraft über der Tiefe</translation>
    </message>
    <message>
        <source>Force on the partition</source>
        <translation>Kraft auf die Trennwand</translation>
    </message>
    <message>
        <source>Stopped by resistance</source>
        <translation>Durch Widerstand gestoppt</translation>
    </message>
    <message>
        <source>Buckling</source>
        <translation>Ausknicken</translation>
    </message>
    <message>
        <source>Tip fold-over</source>
        <translation>Umschlagen der Spitze</translation>
    </message>
    <message>
        <source>Partition rupture</source>
        <translation>Ruptur der Trennwand</translation>
    </message>
    <message>
        <source>Every array is inserted in the same drawn cochleae by the same drawn surgeons. Models follow published data; they are not manufacturer data.</source>
        <translation>Jeder Träger wird in dieselben simulierten Cochleae von denselben simulierten Operateuren eingeführt. Die Modelle beruhen auf veröffentlichten Daten und sind keine Herstellerangaben.</translation>
    </message>
    <message>
        <source>Fraction in which the force reaches the limit at which the drawn surgeon stops, with its 95 % interval (Wilson 1927).</source>
        <translation>Anteil, in dem die Kraft die Grenze erreicht, bei der der simulierte Operateur anhält, mit 95-%-Intervall (Wilson 1927).</translation>
    </message>
    <message>
        <source>Fraction in which the array bows in front of the opening, with its 95 % interval (Wilson 1927).</source>
        <translation>Anteil, in dem der Träger sich vor der Öffnung ausbiegt, mit 95-%-Intervall (Wilson 1927).</translation>
    </message>
    <message>
        <source>Fraction in which the tip folds over, with its 95 % interval (Wilson 1927).</source>
        <translation>Anteil, in dem die Spitze umschlägt, mit 95-%-Intervall (Wilson 1927).</translation>
    </message>
    <message>
        <source>Fraction in which the force on the cochlear partition reaches its drawn strength, with its 95 % interval (Wilson 1927). The strength rests on few publications.</source>
        <translation>Anteil, in dem die Kraft auf die cochleäre Trennwand deren simulierte Festigkeit erreicht, mit 95-%-Intervall (Wilson 1927). Die Festigkeit beruht auf wenigen Veröffentlichungen.</translation>
    </message>
    <message>
        <source>%1 (%2–%3)°</source>
        <translation>%1 (%2–%3)°</translation>
    </message>
    <message>
        <source>%1 (%2–%3) %</source>
        <translation>%1 (%2–%3) %</translation>
    </message>
    <message>
        <source>%1 (%2–%3) mN</source>
        <translation>%1 (%2–%3) mN</translation>
    </message>
    <message>
        <source>%1–%2 %</source>
        <translation>%1–%2 %</translation>
    </message>
    <message>
        <source>Insertion force over depth</source>
        <translation>Insertionskraft über der Tiefe</translation>
    </message>
    <message>
        <source>insertion depth, mm</source>
        <translation>Insertionstiefe, mm</translation>
    </message>
    <message>
        <source>axial insertion force, mN</source>
        <translation>axiale Insertionskraft, mN</translation>
    </message>
    <message>
        <source>Depth of the tip: %1 (%2–%3) mm.</source>
        <translation>Tiefe der Spitze: %1 (%2–%3) mm.</translation>
    </message>
    <message>
        <source>First resistance that surgeons feel (%1 mN): at %2 (%3–%4) mm, in %5 of the insertions.</source>
        <translation>Erster Widerstand, den Chirurgen spüren (%1 mN): bei %2 (%3–%4) mm, in %5 der Insertionen.</translation>
    </message>
    <message>
        <source>Force on the partition reaches %1 mN, the lowest strength that is assumed, in %2, and %3 mN, the highest, in %4.</source>
        <translation>Die Kraft auf die Trennwand erreicht %1 mN, die kleinste angenommene Festigkeit, in %2 und %3 mN, die größte, in %4.</translation>
    </message>
    <message>
        <source>%1 · simulation %2, closest to the medians: %3°, peak %4 mN</source>
        <translation>%1 · Simulation %2, den Medianen am nächsten: %3°, Spitze %4 mN</translation>
    </message>
    <message>
        <source>Modiolus, mm</source>
        <translation>Modiolus, mm</translation>
    </message>
    <message>
        <source>GW</source>
        <translation>GW</translation>
    </message>
    <message>
        <source>SG</source>
        <translation>SG</translation>
    </message>
    <message>
        <source>st</source>
        <translation>HT</translation>
    </message>
    <message>
        <source>Not inserted: %1</source>
        <translation>Nicht inseriert: %1</translation>
    </message>
    <message>
        <source>Insertion speed</source>
        <translation>Insertionsgeschwindigkeit</translation>
    </message>
    <message>
        <source>Tremor</source>
        <translation>Tremor</translation>
    </message>
    <message>
        <source>Grip: length before the opening</source>
        <translation>Griff: Länge vor der Öffnung</translation>
    </message>
    <message>
        <source>Force limit of the surgeon</source>
        <translation>Kraftgrenze des Chirurgen</translation>
    </message>
    <message>
        <source>Rest before the final force</source>
        <translation>Ruhe vor der Endkraft</translation>
    </message>
    <message>
        <source>Visible buckling</source>
        <translation>Sichtbares Ausknicken</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Strength of the cochlear partition</source>
        <translation>Festigkeit der Trennwand</translation>
    </message>
    <message>
        <source>Stiffness of the array</source>
        <translation>Steifigkeit des Elektrodenträgers</translation>
    </message>
    <message>
        <source>Approach to the opening</source>
        <translation>Zugang zur Öffnung</translation>
    </message>
    <message>
        <source>Default filters: %1</source>
        <translation>Standardfilter: %1</translation>
    </message>
    <message>
        <source>Plan, SHA-256</source>
        <translation>Plan, SHA-256</translation>
    </message>
    <message>
        <source>Planned by</source>
        <translation>Geplant mit</translation>
    </message>
    <message>
        <source>CT series, SHA-256</source>
        <translation>CT-Serie, SHA-256</translation>
    </message>
    <message>
        <source>Insertion force</source>
        <translation>Insertionskraft</translation>
    </message>
    <message>
        <source>Measured with</source>
        <translation>Gemessen mit</translation>
    </message>
    <message>
        <source>%1 of each array</source>
        <translation>%1 je Elektrodenträger</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Resistance</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>Buckled</source>
        <translation>Geknickt</translation>
    </message>
    <message>
        <source>Tip fold</source>
        <translation>Spitze um</translation>
    </message>
    <message>
        <source>Rupture</source>
        <translation>Ruptur</translation>
    </message>
    <message>
        <source>Insertion plan</source>
        <translation>Insertionsplan</translation>
    </message>
    <message>
        <source>%1 cannot be used as a logo; choose a PNG or JPEG of at most %2 × %2 pixels.</source>
        <translation>%1 ist als Logo nicht verwendbar; wählen Sie ein PNG oder JPEG mit höchstens %2 × %2 Pixeln.</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>1 array</source>
        <translation>1 Träger</translation>
    </message>
    <message>
        <source>%1 arrays</source>
        <translation>%1 Träger</translation>
    </message>
    <message>
        <source> · </source>
        <translation> · </translation>
    </message>
    <message>
        <source>Opens the plan on the page Plan.</source>
        <translation>Öffnet den Plan auf der Seite Plan.</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>Tiefe %1 mm</translation>
    </message>
    <message>
        <source>peak %1 mN</source>
        <translation>Maximum %1 mN</translation>
    </message>
    <message>
        <source>Insertion</source>
        <translation>Insertion</translation>
    </message>
    <message>
        <source>Replays the recording %1.</source>
        <translation>Gibt die Aufzeichnung %1 wieder.</translation>
    </message>
    <message>
        <source>First resistance, mm</source>
        <translation>Erster Widerstand, mm</translation>
    </message>
    <message>
        <source>felt, %</source>
        <translation>gespürt, %</translation>
    </message>
    <message>
        <source>≥ %1 mN, %</source>
        <translation>≥ %1 mN, %</translation>
    </message>
    <message>
        <source>Sections of the scala tympani</source>
        <translation>Querschnitte der Scala tympani</translation>
    </message>
    <message>
        <source>Course of the center line</source>
        <translation>Verlauf der Mittellinie</translation>
    </message>
    <message>
        <source>Waves of the outer wall</source>
        <translation>Wellen der Außenwand</translation>
    </message>
    <message>
        <source>Height without a measured H</source>
        <translation>Höhe ohne gemessenes H</translation>
    </message>
    <message>
        <source>Soft lining of the wall</source>
        <translation>Weiche Auskleidung der Wand</translation>
    </message>
    <message>
        <source>Stiffness of the basilar membrane</source>
        <translation>Steifigkeit der Basilarmembran</translation>
    </message>
    <message>
        <source>Appendix: resistance, contacts and sources</source>
        <translation>Anhang: Widerstand, Kontakte und Quellen</translation>
    </message>
    <message>
        <source>Arrays 1 to %1; all %2 on the next page</source>
        <translation>Träger 1 bis %1; alle %2 auf der nächsten Seite</translation>
    </message>
    <message>
        <source>Insertion force of all arrays</source>
        <translation>Insertionskraft aller Träger</translation>
    </message>
    <message>
        <source>%1–%2°</source>
        <translation>%1–%2°</translation>
    </message>
    <message>
        <source>%1–%2 mN</source>
        <translation>%1–%2 mN</translation>
    </message>
    <message>
        <source>ruptured at %1° by %2 mN</source>
        <translation>bei %1° mit %2 mN rupturiert</translation>
    </message>
    <message>
        <source>translocation: ruptured at %1° by %2 mN, %3 mm above</source>
        <translation>Translokation: bei %1° mit %2 mN rupturiert, %3 mm darüber</translation>
    </message>
    <message>
        <source>SV</source>
        <translation>SV</translation>
    </message>
    <message>
        <source>SV: above the cochlear partition, in the scala vestibuli.</source>
        <translation>SV: über der cochleären Trennwand, in der Scala vestibuli.</translation>
    </message>
    <message>
        <source>rupture</source>
        <translation>Ruptur</translation>
    </message>
    <message>
        <source>mean %1 mm, %2 below the partition, %3 above</source>
        <translation>Mittel %1 mm, %2 unter der Trennwand, %3 darüber</translation>
    </message>
    <message>
        <source>%1 above the partition</source>
        <translation>%1 über der Trennwand</translation>
    </message>
    <message>
        <source>friction %1</source>
        <translation>Reibung %1</translation>
    </message>
    <message>
        <source>friction of a tissue simulant</source>
        <translation>Reibung eines Gewebe-Simulans</translation>
    </message>
    <message>
        <source>friction of %1</source>
        <translation>Reibung von %1</translation>
    </message>
    <message>
        <source>Cochlea, measures changed by hand</source>
        <translation>Cochlea, Maße von Hand geändert</translation>
    </message>
    <message>
        <source>none: the measures were changed</source>
        <translation>keine: die Maße wurden geändert</translation>
    </message>
    <message>
        <source> · measures changed by hand</source>
        <translation> · Maße von Hand geändert</translation>
    </message>
    <message>
        <source>changed by hand: %1</source>
        <translation>von Hand geändert: %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Lines: median; areas: %1. Paler and dotted where simulations have ended (rings), with the number that came that deep.</source>
        <translation>Linien: Median; Flächen: %1. Blasser und gepunktet, wo Simulationen geendet haben (Ringe), mit der Anzahl, die so tief kam.</translation>
    </message>
    <message>
        <source>Arrays in this cochlea: median (%1)</source>
        <translation>Träger in dieser Cochlea: Median (%1)</translation>
    </message>
    <message>
        <source>number of simulations</source>
        <translation>Anzahl der Simulationen</translation>
    </message>
    <message>
        <source>share of simulations, %</source>
        <translation>Anteil der Simulationen, %</translation>
    </message>
    <message>
        <source>≥ %1 mN</source>
        <translation>≥ %1 mN</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>gespürt</translation>
    </message>
    <message>
        <source>End force, mN</source>
        <translation>Endkraft, mN</translation>
    </message>
    <message>
        <source>after 1 s, mN</source>
        <translation>nach 1 s, mN</translation>
    </message>
    <message>
        <source>after 10 s, mN</source>
        <translation>nach 10 s, mN</translation>
    </message>
    <message>
        <source>mN over depth in mm: median, 25–75 % and band; rings: ends</source>
        <translation>mN über der Tiefe in mm: Median, 25–75 % und Band; Ringe: Enden</translation>
    </message>
    <message>
        <source>Force at rest: %1 (%2–%3) mN after 1 s, %4 (%5–%6) mN after 10 s.</source>
        <translation>Kraft in Ruhe: %1 (%2–%3) mN nach 1 s, %4 (%5–%6) mN nach 10 s.</translation>
    </message>
    <message>
        <source>plan: %1</source>
        <translation>Plan: %1</translation>
    </message>
    <message>
        <source>, at last %1 of %2</source>
        <translation>, zuletzt %1 von %2</translation>
    </message>
    <message>
        <source>End force: mean of the last half second of 2 s of rest, as the program that made this plan read it.</source>
        <translation>Endkraft: Mittel der letzten halben Sekunde von 2 s Ruhe, wie sie das Programm las, das diesen Plan rechnete.</translation>
    </message>
    <message>
        <source>Insertion in progress (%1 mm); it is recorded up to here.</source>
        <translation>Insertion läuft (%1 mm); sie ist bis hierher aufgezeichnet.</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>aufgezeichnet</translation>
    </message>
    <message>
        <source>Buckled in front of the opening</source>
        <translation>Vor der Öffnung ausgeknickt</translation>
    </message>
    <message>
        <source>Slipped out of the opening</source>
        <translation>Aus der Öffnung geglitten</translation>
    </message>
    <message>
        <source>Tip folded over</source>
        <translation>Spitze umgeschlagen</translation>
    </message>
    <message>
        <source>Jammed</source>
        <translation>Verklemmt</translation>
    </message>
    <message>
        <source>Stopped with a fault</source>
        <translation>Mit einem Fehler angehalten</translation>
    </message>
    <message>
        <source>Withdrawn</source>
        <translation>Zurückgezogen</translation>
    </message>
    <message>
        <source>Full depth</source>
        <translation>Volle Tiefe</translation>
    </message>
    <message>
        <source>Stopped as set, %1 mm of the array outside</source>
        <translation>Wie eingestellt angehalten, %1 mm des Elektrodenträgers außerhalb</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>tip at %1</source>
        <translation>Spitze bei %1</translation>
    </message>
    <message>
        <source>Force after 1 s of rest</source>
        <translation>Kraft nach 1 s Ruhe</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>no contact inside</source>
        <translation>kein Kontakt innerhalb</translation>
    </message>
    <message>
        <source>of the most apical contact; %1</source>
        <translation>des apikalsten Kontakts; %1</translation>
    </message>
    <message>
        <source>Contacts inside</source>
        <translation>Kontakte innerhalb</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>Patient without a code · %1</source>
        <translation>Patient ohne Code · %1</translation>
    </message>
    <message>
        <source>Published cochlea · %1</source>
        <translation>Veröffentlichte Cochlea · %1</translation>
    </message>
    <message>
        <source>Average cochlea · %1</source>
        <translation>Mittlere Cochlea · %1</translation>
    </message>
    <message>
        <source>Clark’s spiral · %1</source>
        <translation>Clark-Spirale · %1</translation>
    </message>
    <message>
        <source>Lateral wall (end of A)</source>
        <translation>Laterale Wand (Ende von A)</translation>
    </message>
    <message>
        <source>Lateral wall, first end of B</source>
        <translation>Laterale Wand, erstes Ende von B</translation>
    </message>
    <message>
        <source>Lateral wall, second end of B</source>
        <translation>Laterale Wand, zweites Ende von B</translation>
    </message>
    <message>
        <source>Base (floor of the basal turn)</source>
        <translation>Basis (Boden der Basalwindung)</translation>
    </message>
    <message>
        <source>RW</source>
        <translation>RW</translation>
    </message>
    <message>
        <source>LW</source>
        <translation>LW</translation>
    </message>
    <message>
        <source>base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Cochlear view: from the round window through the modiolus to the opposite lateral wall of the basal turn.</source>
        <translation>Cochleaansicht: vom runden Fenster durch den Modiolus zur gegenüberliegenden lateralen Wand der Basalwindung.</translation>
    </message>
    <message>
        <source>Cochlear view: the lateral wall of the basal turn on the line through the modiolus, perpendicular to A.</source>
        <translation>Cochleaansicht: die laterale Wand der Basalwindung auf der Linie durch den Modiolus, senkrecht zu A.</translation>
    </message>
    <message>
        <source>at population mean (%1 mm, SD %2)</source>
        <translation>am Populationsmittel (%1 mm, SD %2)</translation>
    </message>
    <message>
        <source>%1 SD below population mean (%2 mm, SD %3)</source>
        <translation>%1 SD unter dem Populationsmittel (%2 mm, SD %3)</translation>
    </message>
    <message>
        <source>%1 SD above population mean (%2 mm, SD %3)</source>
        <translation>%1 SD über dem Populationsmittel (%2 mm, SD %3)</translation>
    </message>
    <message>
        <source>insertion depth; tip angle</source>
        <translation>Insertionstiefe; Winkel der Spitze</translation>
    </message>
    <message>
        <source>Angular insertion depth: angle of the most apical contact about the modiolar axis, from the round window. The tip lies deeper.</source>
        <translation>Insertionswinkel: Winkel des apikalsten Kontakts um die Modiolusachse, ab dem runden Fenster. Die Spitze liegt tiefer.</translation>
    </message>
    <message>
        <source>Organ of Corti: 33.13 mm, SD 2.11, n = 9 (Stakhovskaya et al. 2007). The published model uses 35.58 mm.</source>
        <translation>Corti-Organ: 33,13 mm, SD 2,11, n = 9 (Stakhovskaya et al. 2007). Das veröffentlichte Modell verwendet 35,58 mm.</translation>
    </message>
    <message>
        <source>friction estimated from pig tissue</source>
        <translation>Reibung geschätzt aus Schweinegewebe</translation>
    </message>
    <message>
        <source>The cochlea in the CT</source>
        <translation>Die Cochlea im CT</translation>
    </message>
    <message>
        <source>Cochlear view and the mid-modiolar planes along A and along B: the fitted wall, the lines of A, B and H, and a bar of 5 mm.</source>
        <translation>Cochleäre Ansicht und die mittmodiolaren Ebenen entlang A und entlang B: die angepasste Wand, die Linien von A, B und H und ein Balken von 5 mm.</translation>
    </message>
    <message>
        <source>Packing of the wires</source>
        <translation>Packung der Drähte</translation>
    </message>
    <message>
        <source>Angle of the most apical contact from the round window at the end of each insertion. Median and the band that the head names.</source>
        <translation>Winkel des apikalsten Kontakts vom runden Fenster am Ende jeder Insertion. Median und das Band, das der Kopf nennt.</translation>
    </message>
    <message>
        <source>Maximum axial force on the surgeon’s hand. Median and the band that the head names.</source>
        <translation>Größte axiale Kraft auf die Hand des Operateurs. Median und das Band, das der Kopf nennt.</translation>
    </message>
    <message>
        <source>Axial force over the depth of the tip past the opening, as deep as any simulation went. Line: median; area: the band that the head names; paler and dashed where some simulations have ended. All rows have the same axes.</source>
        <translation>Axiale Kraft über der Tiefe der Spitze hinter der Öffnung, so weit eine Simulation reichte. Linie: Median; Fläche: das Band, das der Kopf nennt; blasser und gestrichelt, wo Simulationen geendet haben. Alle Zeilen haben dieselben Achsen.</translation>
    </message>
    <message>
        <source>Maximum force on the cochlear partition. Median and the band that the head names.</source>
        <translation>Größte Kraft auf die cochleäre Trennwand. Median und das Band, das der Kopf nennt.</translation>
    </message>
    <message>
        <source>Wires</source>
        <translation>Drähte</translation>
    </message>
    <message>
        <source>At the median friction, %1, only: %2, peak force %3.</source>
        <translation>Nur bei der mittleren Reibung, %1: %2, größte Kraft %3.</translation>
    </message>
    <message>
        <source>%1 against %2: %3°, deeper in %4; peak force %5 mN, higher in %6.</source>
        <translation>%1 gegen %2: %3°, tiefer in %4; größte Kraft %5 mN, höher in %6.</translation>
    </message>
    <message>
        <source>Differences in the same ear, with the same hand and friction (%1):</source>
        <translation>Unterschiede im selben Ohr, bei gleicher Hand und Reibung (%1):</translation>
    </message>
    <message>
        <source>mean of 0.5 to 1 s after the stop</source>
        <translation>Mittel von 0,5 bis 1 s nach dem Halt</translation>
    </message>
    <message>
        <source>Angular depth, °</source>
        <translation>Insertionswinkel, °</translation>
    </message>
    <message>
        <source>Peak force, mN</source>
        <translation>Größte Kraft, mN</translation>
    </message>
    <message>
        <source>From the same simulations, less what follows the logarithm of their friction (least squares). All else is still drawn.</source>
        <translation>Aus denselben Simulationen, ohne das, was dem Logarithmus ihrer Reibung folgt (kleinste Quadrate). Alles andere ist weiter gezogen.</translation>
    </message>
    <message>
        <source>First against second</source>
        <translation>Erster gegen zweiten</translation>
    </message>
    <message>
        <source>deeper</source>
        <translation>tiefer</translation>
    </message>
    <message>
        <source>higher</source>
        <translation>höher</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 gegen %2</translation>
    </message>
    <message>
        <source>First minus second, simulation by simulation: cochlea, hand and friction are the same for both, so their spread is not in these bands.</source>
        <translation>Erster minus zweiter, Simulation für Simulation: Cochlea, Hand und Reibung sind für beide gleich, ihre Streuung ist also nicht in diesen Bändern.</translation>
    </message>
    <message>
        <source>Depth that the surgeon intends</source>
        <translation>Tiefe, die der Operateur beabsichtigt</translation>
    </message>
    <message>
        <source>Method: each array is inserted by a simulated hand %1 times (%2). Every time A, B and H within their errors, the shape of the cochlea, speed, tremor, grip, force limit, intended depth, friction, approach, and stiffness and packing of the array&apos;s wires are drawn again; see the appendix.</source>
        <translation>Methode: Jeder Elektrodenträger wird %1-mal von einer simulierten Hand inseriert (%2). Jedes Mal werden A, B und H innerhalb ihrer Fehler, die Form der Cochlea, Geschwindigkeit, Tremor, Griff, Kraftgrenze, beabsichtigte Tiefe, Reibung, Zugang sowie Steifigkeit und Packung der Drähte des Trägers neu gezogen; siehe Anhang.</translation>
    </message>
    <message>
        <source>plan of %1</source>
        <translation>Plan vom %1</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>ended, resting</source>
        <translation>beendet, ruht</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>recording now</source>
        <translation>wird aufgezeichnet</translation>
    </message>
    <message>
        <source>recording the rest</source>
        <translation>Ruhe wird aufgezeichnet</translation>
    </message>
    <message>
        <source>Save the contacts</source>
        <translation>Kontakte speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Ended before its stop at %1</source>
        <translation>Vor dem Halt bei %1 beendet</translation>
    </message>
    <message>
        <source>%1 samples did not converge</source>
        <translation>%1 Abtastwerte sind nicht konvergiert</translation>
    </message>
    <message>
        <source>Taper of the array</source>
        <translation>Verjüngung des Trägers</translation>
    </message>
    <message>
        <source>clinics report</source>
        <translation>Kliniken berichten</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Verjüngung</translation>
    </message>
    <message>
        <source>SHA-256 when this report was made; later motion is recorded, too</source>
        <translation>SHA-256 zur Zeit dieses Berichts; spätere Bewegung wird auch aufgezeichnet</translation>
    </message>
    <message>
        <source>%1–%2</source>
        <translation>%1–%2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>n = %1</source>
        <translation>n = %1</translation>
    </message>
    <message>
        <source>Clinics report %1: %2. %3</source>
        <translation>Kliniken berichten %1: %2. %3</translation>
    </message>
    <message>
        <source>Not validated: the program’s clinical table misses %1.</source>
        <translation>Nicht validiert: Die klinische Tabelle des Programms verfehlt %1.</translation>
    </message>
    <message>
        <source>depth, angle and contacts at the deepest place, %1</source>
        <translation>Tiefe, Winkel und Kontakte an der tiefsten Stelle, %1</translation>
    </message>
    <message>
        <source>at the end %1, tip at %2°</source>
        <translation>am Ende %1, Spitze bei %2°</translation>
    </message>
    <message>
        <source>stop reached</source>
        <translation>Ziel erreicht</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>buckled</source>
        <translation>ausgeknickt</translation>
    </message>
    <message>
        <source>slipped out</source>
        <translation>herausgerutscht</translation>
    </message>
    <message>
        <source>tip folded</source>
        <translation>Spitze umgeschlagen</translation>
    </message>
    <message>
        <source>jammed</source>
        <translation>verklemmt</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>ended early</source>
        <translation>früh beendet</translation>
    </message>
    <message>
        <source>rib %1</source>
        <translation>Rippe %1</translation>
    </message>
    <message>
        <source>Click; drag a landmark</source>
        <translation>Klick; Landmarke ziehen</translation>
    </message>
    <message>
        <source>move the crosshair; move the landmark</source>
        <translation>Fadenkreuz setzen; Landmarke verschieben</translation>
    </message>
    <message>
        <source>Wheel, Up, Down; Ctrl+wheel, +, -</source>
        <translation>Rad, Auf, Ab; Strg+Rad, +, -</translation>
    </message>
    <message>
        <source>layers; zoom</source>
        <translation>Schichten; Zoom</translation>
    </message>
    <message>
        <source>Right drag; middle or Shift+drag</source>
        <translation>Rechts ziehen; Mitte oder Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>brightness and contrast; pan</source>
        <translation>Helligkeit und Kontrast; verschieben</translation>
    </message>
    <message>
        <source>Simulations</source>
        <translation>Simulationen</translation>
    </message>
    <message>
        <source>%1 simulations</source>
        <translation>%1 Simulationen</translation>
    </message>
    <message>
        <source>%1 simulations so far</source>
        <translation>bisher %1 Simulationen</translation>
    </message>
    <message>
        <source>Simulated cochlea %1 · %2</source>
        <translation>Simulierte Cochlea %1 · %2</translation>
    </message>
    <message>
        <source>peaks in patients %1–%2 mN</source>
        <translation>Spitzen bei Patienten %1–%2 mN</translation>
    </message>
    <message>
        <source>felt from %1 mN</source>
        <translation>spürbar ab %1 mN</translation>
    </message>
    <message>
        <source>Insertion force, mN over depth, mm</source>
        <translation>Insertionskraft, mN über Tiefe, mm</translation>
    </message>
    <message>
        <source>blue: this insertion; gray: median and band of the plan</source>
        <translation>blau: diese Insertion; grau: Median und Band des Plans</translation>
    </message>
    <message>
        <source>blue: this insertion; no plan of it is stored</source>
        <translation>blau: diese Insertion; kein Plan dazu gespeichert</translation>
    </message>
    <message>
        <source>Report of the insertion</source>
        <translation>Bericht der Insertion</translation>
    </message>
    <message>
        <source>&lt; %1 mN</source>
        <translation>&lt; %1 mN</translation>
    </message>
    <message>
        <source>rupture assumed at %1–%2 mN; original not available</source>
        <translation>Ruptur angenommen bei %1–%2 mN; Original nicht verfügbar</translation>
    </message>
    <message>
        <source>First resistance and force on the partition: median (band)</source>
        <translation>Erster Widerstand und Kraft auf die Trennwand: Median (Band)</translation>
    </message>
    <message>
        <source>Force at the end and at rest: median (band)</source>
        <translation>Kraft am Ende und in Ruhe: Median (Band)</translation>
    </message>
    <message>
        <source>At friction %1 only: median (band)</source>
        <translation>Nur bei Reibung %1: Median (Band)</translation>
    </message>
    <message>
        <source>Differences between arrays in the same ear: median (band)</source>
        <translation>Unterschiede zwischen Elektrodenträgern im selben Ohr: Median (Band)</translation>
    </message>
    <message>
        <source>Contacts, numbered from the tip: median (band)</source>
        <translation>Kontakte, gezählt ab der Spitze: Median (Band)</translation>
    </message>
    <message>
        <source>Inputs and their sources</source>
        <translation>Eingangsgrößen und ihre Quellen</translation>
    </message>
    <message>
        <source>angle, %</source>
        <translation>Winkel, %</translation>
    </message>
    <message>
        <source>peak force, %</source>
        <translation>Maximalkraft, %</translation>
    </message>
    <message>
        <source>What decides angle and peak force: share of the variance</source>
        <translation>Was Winkel und Maximalkraft bestimmt: Anteil an der Varianz</translation>
    </message>
    <message>
        <source>Inputs from the strongest on, at most %1 of each array; shares below %2 % are not drawn. Blue: angular depth; orange: peak force.</source>
        <translation>Eingangsgrößen, die stärkste zuerst, höchstens %1 je Elektrodenträger; Anteile unter %2 % sind nicht gezeichnet. Blau: Insertionswinkel; orange: Maximalkraft.</translation>
    </message>
    <message>
        <source>Method and limits; all limits in the appendix</source>
        <translation>Methode und Grenzen; alle Grenzen im Anhang</translation>
    </message>
    <message>
        <source>assumption</source>
        <translation>Annahme</translation>
    </message>
    <message>
        <source>general literature</source>
        <translation>allgemeine Literatur</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Literatur</translation>
    </message>
    <message>
        <source>Assumption: a choice, or a value whose source was not at hand in the original. The guide lists them (The method, Assumptions).</source>
        <translation>Annahme: eine Festlegung oder ein Wert, dessen Quelle nicht im Original vorlag. Das Handbuch führt sie auf (The method, Assumptions).</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Friction μ</source>
        <translation>Reibung μ</translation>
    </message>
    <message>
        <source>Partition: the model gives fewer translocations than clinics report.</source>
        <translation>Trennwand: Das Modell ergibt weniger Translokationen, als Kliniken berichten.</translation>
    </message>
    <message>
        <source>outside: %1</source>
        <translation>außerhalb: %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Angle from the center of the round window. Frequency by Greenwood&apos;s map at the place on the organ of Corti. Distance from the center line of the array to the inner wall. Depth past the opening. –: not inserted.</source>
        <translation>Winkel ab der Mitte des runden Fensters. Frequenz nach der Greenwood-Funktion am Ort des Corti-Organs. Abstand der Mittellinie des Elektrodenträgers zur Innenwand. Tiefe jenseits der Öffnung. –: nicht inseriert.</translation>
    </message>
    <message>
        <source>Frequency, kHz</source>
        <translation>Frequenz, kHz</translation>
    </message>
    <message>
        <source>Array in the cochlea</source>
        <translation>Träger in der Cochlea</translation>
    </message>
    <message>
        <source>CT, cochlear view</source>
        <translation>CT, cochleäre Ansicht</translation>
    </message>
    <message>
        <source>The report was saved as %1. It names the patient, as the CT does.</source>
        <translation>Der Bericht wurde als %1 gespeichert. Er nennt den Patienten wie das CT.</translation>
    </message>
    <message>
        <source>The report was saved as %1.</source>
        <translation>Der Bericht wurde als %1 gespeichert.</translation>
    </message>
    <message>
        <source>DICOM with the patient’s code (*.dcm)</source>
        <translation>DICOM mit dem Patientencode (*.dcm)</translation>
    </message>
    <message>
        <source>DICOM in the study of the CT, with the patient’s name (*.dcm)</source>
        <translation>DICOM in der Studie des CT, mit dem Namen des Patienten (*.dcm)</translation>
    </message>
    <message>
        <source>Folder of the patient’s CT; the report takes name and number from it</source>
        <translation>Ordner des CT; der Bericht übernimmt daraus Namen und Nummer</translation>
    </message>
    <message>
        <source>%1 to %2 by speed</source>
        <translation>%1 bis %2 je nach Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1; %2 %3</source>
        <translation>%1; %2 %3</translation>
    </message>
    <message>
        <source>own value</source>
        <translation>eigener Wert</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>none; entered by hand</source>
        <translation>keine; Maße eingegeben</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>moved by hand: %1</source>
        <translation>von Hand versetzt: %1</translation>
    </message>
    <message>
        <source>Strength of the cochlear partition, %1 to %2 mN: assumed; original not available. The model gives fewer translocations than clinics report.</source>
        <translation>Festigkeit der cochleären Trennwand, %1 bis %2 mN: angenommen; Original nicht verfügbar. Das Modell ergibt weniger Translokationen, als Kliniken berichten.</translation>
    </message>
    <message>
        <source>cochlear partition %1 mN (rupture assumed at %2–%3 mN)</source>
        <translation>cochleäre Trennwand %1 mN (Ruptur angenommen bei %2–%3 mN)</translation>
    </message>
    <message>
        <source>cochlear partition %1 mN: within or above assumed rupture forces (%2–%3 mN)</source>
        <translation>cochleäre Trennwand %1 mN: im Bereich der angenommenen Rupturkräfte oder darüber (%2–%3 mN)</translation>
    </message>
    <message>
        <source>friction of endosteum, assumed</source>
        <translation>Reibung des Endosts, angenommen</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>All contacts inside</source>
        <translation>Alle Kontakte innen</translation>
    </message>
    <message>
        <source>Fraction of the insertions that end with all contacts inside the cochlea, which clinics count as complete, with its 95 % interval (Wilson 1927).</source>
        <translation>Anteil der Insertionen, die mit allen Kontakten in der Cochlea enden, was Kliniken als vollständig zählen, mit seinem 95-%-Intervall (Wilson 1927).</translation>
    </message>
    <message>
        <source>All inside</source>
        <translation>Alle innen</translation>
    </message>
    <message>
        <source>Its interval holds what the formula of A alone gives: %1 mm (Alexiades et al. 2015).</source>
        <translation>Ihr Intervall enthält, was die Formel aus A allein ergibt: %1 mm (Alexiades et al. 2015).</translation>
    </message>
    <message>
        <source>CDL: cochlear duct length along the organ of Corti, from A and B (elliptic-circular).</source>
        <translation>CDL: Länge des Ductus cochlearis entlang des Corti-Organs, aus A und B (elliptisch-kreisförmig).</translation>
    </message>
    <message>
        <source>Axial force on the hand at its stop, by the line through the last half second of motion. Median and the band that the head names.</source>
        <translation>Axiale Kraft auf die Hand bei ihrem Halt, nach der Geraden durch die letzte halbe Sekunde der Bewegung. Median und das Band, das der Kopf nennt.</translation>
    </message>
    <message>
        <source>at the stop: line through the last 0.5 s of motion</source>
        <translation>beim Halt: Gerade der letzten 0,5 s Bewegung</translation>
    </message>
    <message>
        <source>first to last motion, pauses included; reversals: %1</source>
        <translation>erste bis letzte Bewegung, mit Pausen; Umkehrungen: %1</translation>
    </message>
    <message>
        <source>First resistance: depth of the tip past the opening where the insertion force first reaches %1 mN, the median force that surgeons detect %4, over the simulations in which it does; felt: that it does. ≥ %2 and ≥ %3 mN: that the force on the cochlear partition reaches its weakest and its strongest assumed strength; original not available.</source>
        <translation>Erster Widerstand: Tiefe der Spitze jenseits der Öffnung, in der die Insertionskraft zuerst %1 mN erreicht, den Median der Kraft, die Operateure spüren %4, über die Simulationen, in denen sie das tut; spürbar: dass sie es tut. ≥ %2 und ≥ %3 mN: dass die Kraft auf die cochleäre Trennwand deren geringste und höchste angenommene Festigkeit erreicht; Original nicht verfügbar.</translation>
    </message>
    <message>
        <source>End force: at the stop, by the line through the last half second of motion; then means of the half second before 1 s and before 10 s of rest.</source>
        <translation>Endkraft: beim Halt, nach der Geraden durch die letzte halbe Sekunde der Bewegung; danach Mittel der halben Sekunde vor 1 s und vor 10 s Ruhe.</translation>
    </message>
    <message>
        <source>Angle from the center of the round window. Modiolus: distance from the center line of the array to the inner wall. GW: frequency by Greenwood&apos;s map, kHz, at the place on the organ of Corti. SG: frequency of the spiral ganglion, kHz, at the angle; st: its semitones above the center of the default filter; in: number of simulations in which the contact is inside; its row is of these.</source>
        <translation>Winkel ab der Mitte des runden Fensters. Modiolus: Abstand der Mittellinie des Elektrodenträgers zur Innenwand. GW: Frequenz nach der Greenwood-Funktion, kHz, am Ort des Corti-Organs. SG: Frequenz des Spiralganglions, kHz, am Winkel; HT: Halbtöne über der Mitte des Standardfilters; in: Zahl der Simulationen, in denen der Kontakt innen liegt; seine Zeile gilt für diese.</translation>
    </message>
    <message>
        <source>first to last motion, pauses included</source>
        <translation>erste bis letzte Bewegung, mit Pausen</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>eingegeben</translation>
    </message>
    <message>
        <source>by hand: %1</source>
        <translation>von Hand: %1</translation>
    </message>
    <message>
        <source>CDL</source>
        <translation>CDL</translation>
    </message>
    <message>
        <source>Beyond the 95 % interval of the difference</source>
        <translation>Außerhalb des 95-%-Intervalls der Differenz</translation>
    </message>
    <message>
        <source>Within the 95 % interval of the difference</source>
        <translation>Innerhalb des 95-%-Intervalls der Differenz</translation>
    </message>
    <message>
        <source>%1 %2 → %3 mm</source>
        <translation>%1 %2 → %3 mm</translation>
    </message>
    <message>
        <source>Opens the CT series with the SHA-256 %1 where it was read. The CT itself is not kept.</source>
        <translation>Öffnet die CT-Serie mit dem SHA-256 %1, wo sie gelesen wurde. Das CT selbst wird nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>A, B, H and duct length with their errors (structured report)</source>
        <translation>A, B, H und Ganglänge mit ihren Fehlern (Structured Report)</translation>
    </message>
    <message>
        <source>The fitted lumen (segmentation)</source>
        <translation>Das angepasste Lumen (Segmentation)</translation>
    </message>
    <message>
        <source>The cochlear view with A and B (picture)</source>
        <translation>Die Cochleaansicht mit A und B (Bild)</translation>
    </message>
    <message>
        <source>%1 about %2 s left</source>
        <translation>%1 noch etwa %2 s</translation>
    </message>
    <message>
        <source>Angular</source>
        <translation>Winkel-</translation>
    </message>
    <message>
        <source>depth, °</source>
        <translation>tiefe, °</translation>
    </message>
    <message>
        <source>Coverage, %</source>
        <translation>Abdeckung, %</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Maximale</translation>
    </message>
    <message>
        <source>Partition</source>
        <translation>Trennwand</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>Mittlere Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>inward motion up to the maximum depth by its time, pauses included</source>
        <translation>Bewegung einwärts bis zur maximalen Tiefe durch ihre Zeit, Pausen eingeschlossen</translation>
    </message>
    <message>
        <source>%1 of 100: the fractions of insertion and peak force, times the geometric mean of the fractions of speed, reversals and smoothness; none can be made good by the others. Rates technique only; it does not assess trauma.</source>
        <translation>%1 von 100: die Anteile für Insertion und Maximalkraft, mal das geometrische Mittel der Anteile für Geschwindigkeit, Rückzüge und Gleichmäßigkeit; keiner gleicht einen anderen aus. Bewertet nur die Technik, nicht das Trauma.</translation>
    </message>
    <message>
        <source> †</source>
        <translation> †</translation>
    </message>
    <message>
        <source>%1; clinics</source>
        <translation>%1; Kliniken</translation>
    </message>
    <message>
        <source>Angle and coverage of the most apical contact. Shares, from %1 simulations on with 95 % intervals: all contacts inside, stop by resistance, buckling in front of the opening, tip fold-over, a force that reaches the strength of the cochlear partition. Clinics: medians or means of patients, angular depth, complete insertions, tip fold-over and translocation %2. Strength of the partition: assumed; original not available; the model gives fewer translocations than clinics report. †: of a group of arrays or of one that is not named, not of this one. Not validated, not tested, or *: the program’s clinical table misses a row of this array, or has none.</source>
        <translation>Winkel und Abdeckung des apikalsten Kontakts. Anteile, ab %1 Simulationen mit 95-%-Intervallen: alle Kontakte innen, Halt durch Widerstand, Knicken vor der Öffnung, Umschlagen der Spitze, eine Kraft, die die Festigkeit der cochleären Trennwand erreicht. Kliniken: Mediane oder Mittelwerte von Patienten, Insertionswinkel, vollständige Insertionen, Umschlagen der Spitze und Translokation %2. Festigkeit der Trennwand: angenommen; Original nicht verfügbar; das Modell ergibt weniger Translokationen, als Kliniken berichten. †: einer Gruppe von Elektrodenträgern oder eines ungenannten, nicht dieses Trägers. Nicht validiert, nicht geprüft oder *: Die klinische Tabelle des Programms verfehlt eine Zeile dieses Elektrodenträgers oder hat keine.</translation>
    </message>
    <message>
        <source>%1, number %2: %3.</source>
        <translation>%1, Nummer %2: %3.</translation>
    </message>
    <message>
        <source>range %1</source>
        <translation>Spanne %1</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> von %1</translation>
    </message>
    <message>
        <source>not validated</source>
        <translation>nicht validiert</translation>
    </message>
    <message>
        <source>not tested</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>Not tested: the program’s clinical table has no row of this array.</source>
        <translation>Nicht geprüft: Die klinische Tabelle des Programms hat keine Zeile dieses Elektrodenträgers.</translation>
    </message>
    <message>
        <source>%1 to %2 mN</source>
        <translation>%1 bis %2 mN</translation>
    </message>
    <message>
        <source>Values of the model, not clinical risks: no friction in a living ear is known; the one that is taken is estimated from pig tissue, and bands hold its uncertainty. Many arrays stop earlier here than clinics report, perimodiolar ones far earlier, and peaks are bounded by the force at which the simulated hand stops (%1): do not choose a maker by this table. Translocation is rarer than clinics report.</source>
        <translation>Werte des Modells, keine klinischen Risiken: Eine Reibung im lebenden Ohr ist nicht bekannt; die verwendete ist aus Schweinegewebe geschätzt, und die Bandbreiten enthalten ihre Unsicherheit. Viele Träger halten hier früher an, als Kliniken berichten, perimodioläre weit früher, und Maximalkräfte sind durch die Kraft begrenzt, bei der die simulierte Hand anhält (%1): Wählen Sie keinen Hersteller nach dieser Tabelle. Translokationen sind seltener, als Kliniken berichten.</translation>
    </message>
    <message>
        <source>A hand that stops at %1 mN</source>
        <translation>Eine Hand, die bei %1 mN stoppt,</translation>
    </message>
    <message>
        <source>would have ended at %1, %2°, %3 of %4 contacts inside</source>
        <translation>hätte bei %1, %2°, mit %3 von %4 Kontakten innen aufgehört</translation>
    </message>
    <message>
        <source>Report of the insertion (PDF)</source>
        <translation>Bericht der Insertion (PDF)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 %2.</source>
        <translation>%1 %2.</translation>
    </message>
    <message>
        <source>Cochlea, CT measurements, %1 entered, ± 95 % interval</source>
        <translation>Cochlea, CT-Messwerte, %1 eingegeben, ± 95-%-Intervall</translation>
    </message>
    <message>
        <source>%1; %2 entered</source>
        <translation>%1; %2 eingegeben</translation>
    </message>
    <message>
        <source>This series is already %1, %2.</source>
        <translation>Diese Serie ist bereits %1, %2.</translation>
    </message>
    <message>
        <source>%1, %2, was measured in series %3; this is series %4. Check that both are of one person.</source>
        <translation>%1, %2, wurde in der Serie %3 vermessen; dies ist die Serie %4. Prüfen Sie, ob beide von einer Person sind.</translation>
    </message>
    <message>
        <source>This plan is of %1 mm; the measures in use are %2 mm.</source>
        <translation>Dieser Plan gilt für %1 mm; die verwendeten Messwerte sind %2 mm.</translation>
    </message>
    <message>
        <source>Measured again (%1; before: %2): %3</source>
        <translation>Erneut vermessen (%1; davor: %2): %3</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>mean of 0.5 to 1 s after the stop, without tremor</source>
        <translation>Mittel von 0,5 bis 1 s nach dem Halt, ohne Tremor</translation>
    </message>
    <message>
        <source>%1 to %2 (95 %)</source>
        <translation>%1 bis %2 (95 %)</translation>
    </message>
    <message>
        <source>Friction in ears: %1.</source>
        <translation>Reibung in Ohren: %1.</translation>
    </message>
    <message>
        <source>Clinics: median or mean (IQR, range or ± SD) of patients.</source>
        <translation>Kliniken: Median oder Mittelwert (IQR, Spanne oder ± SD) von Patienten.</translation>
    </message>
    <message>
        <source>IQR %1</source>
        <translation>IQR %1</translation>
    </message>
    <message>
        <source>%1 (SD %2)</source>
        <translation>%1 (SD %2)</translation>
    </message>
    <message>
        <source>inserted by hand</source>
        <translation>von Hand inseriert</translation>
    </message>
    <message>
        <source>inserted in the patient</source>
        <translation>im Patienten inseriert</translation>
    </message>
    <message>
        <source>stopped because of: %1</source>
        <translation>beendet wegen: %1</translation>
    </message>
    <message>
        <source>intended mark reached</source>
        <translation>geplante Marke erreicht</translation>
    </message>
    <message>
        <source>intended mark not reached</source>
        <translation>geplante Marke nicht erreicht</translation>
    </message>
    <message>
        <source>intended depth %1 mm</source>
        <translation>geplante Tiefe %1 mm</translation>
    </message>
    <message>
        <source>contacts outside, as seen: %1</source>
        <translation>Kontakte außen, gesehen: %1</translation>
    </message>
    <message>
        <source>length outside %1 mm</source>
        <translation>Länge außen %1 mm</translation>
    </message>
    <message>
        <source>lot %1</source>
        <translation>Charge %1</translation>
    </message>
    <message>
        <source>attempts: %1</source>
        <translation>Versuche: %1</translation>
    </message>
    <message>
        <source>pull-backs: %1</source>
        <translation>Rückzüge: %1</translation>
    </message>
    <message>
        <source>first resistance at contact %1</source>
        <translation>erster Widerstand bei Kontakt %1</translation>
    </message>
    <message>
        <source>CT %1 days after surgery</source>
        <translation>CT %1 Tage nach der Operation</translation>
    </message>
    <message>
        <source>CT after surgery</source>
        <translation>CT nach Operation</translation>
    </message>
    <message>
        <source>%1, of %2</source>
        <translation>%1, vom %2</translation>
    </message>
    <message>
        <source>no plan of this array</source>
        <translation>kein Plan dieses Trägers</translation>
    </message>
    <message>
        <source>What was found, beside the plan</source>
        <translation>Gefunden, neben dem Plan</translation>
    </message>
    <message>
        <source>found (95 %)</source>
        <translation>gefunden (95 %)</translation>
    </message>
    <message>
        <source>percentile</source>
        <translation>Perzentil</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>angle (95 %)</source>
        <translation>Winkel (95 %)</translation>
    </message>
    <message>
        <source>placed</source>
        <translation>gesetzt</translation>
    </message>
    <message>
        <source>Outcome of an implantation</source>
        <translation>Ergebnis einer Implantation</translation>
    </message>
    <message>
        <source>The surgeon states: %1.</source>
        <translation>Angaben aus der Operation: %1.</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>Patient %1</source>
        <translation>Patient %1</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>singly</source>
        <translation>einzeln</translation>
    </message>
    <message>
        <source>by spacing</source>
        <translation>nach Abstand</translation>
    </message>
    <message>
        <source>%1 (%2–%3) kHz</source>
        <translation>%1 (%2–%3) kHz</translation>
    </message>
    <message>
        <source>below 5 %</source>
        <translation>unter 5 %</translation>
    </message>
    <message>
        <source>above 95 %</source>
        <translation>über 95 %</translation>
    </message>
    <message>
        <source>%1 (%2–%3)%4</source>
        <translation>%1 (%2–%3)%4</translation>
    </message>
    <message>
        <source>mark reached</source>
        <translation>Marke erreicht</translation>
    </message>
    <message>
        <source>bowed outside</source>
        <translation>außen gebogen</translation>
    </message>
    <message>
        <source>hearing</source>
        <translation>Gehör</translation>
    </message>
    <message>
        <source>bleeding</source>
        <translation>Blutung</translation>
    </message>
    <message>
        <source>other</source>
        <translation>anderes</translation>
    </message>
    <message>
        <source>round window</source>
        <translation>rundes Fenster</translation>
    </message>
    <message>
        <source>extended RW</source>
        <translation>erweitertes RF</translation>
    </message>
    <message>
        <source>cochleostomy</source>
        <translation>Cochleostomie</translation>
    </message>
    <message>
        <source>forceps</source>
        <translation>Pinzette</translation>
    </message>
    <message>
        <source>sheath</source>
        <translation>Hülse</translation>
    </message>
    <message>
        <source>stylet</source>
        <translation>Stilett</translation>
    </message>
    <message>
        <source>off-stylet</source>
        <translation>vom Stilett</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>%1 (%2–%3) mm</source>
        <translation>%1 (%2–%3) mm</translation>
    </message>
    <message>
        <source>ear carried over from the CT before surgery, residual %1 mm</source>
        <translation>Ohr aus dem CT vor der Operation übertragen, Restfehler %1 mm</translation>
    </message>
    <message>
        <source>the ear is measured in this CT, with wider errors</source>
        <translation>das Ohr ist in diesem CT gemessen, mit größeren Fehlern</translation>
    </message>
    <message>
        <source>Opens the outcome on the page Outcome, in its CT where that is still there.</source>
        <translation>Öffnet das Ergebnis auf der Seite Ergebnis, in seinem CT, wo es noch da ist.</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>Outcome</source>
        <comment>of an implanted ear</comment>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Whether the plan was made before surgery is not known: the CT states no day. Type Day of the CT, else it is not counted among the outcomes.</source>
        <translation>Ob der Plan vor der Operation erstellt wurde, ist nicht bekannt: Das CT gibt keinen Tag an. Tragen Sie den Tag des CT ein, sonst zählt er nicht unter den Ergebnissen.</translation>
    </message>
    <message>
        <source>Whether the plan was made before surgery is not known. Type Days from surgery to CT, else it is not counted among the outcomes.</source>
        <translation>Ob der Plan vor der Operation erstellt wurde, ist nicht bekannt. Tragen Sie die Tage von der OP bis zum CT ein, sonst zählt er nicht unter den Ergebnissen.</translation>
    </message>
    <message>
        <source>The plan was made after surgery: it is no prediction, and is not counted among the outcomes.</source>
        <translation>Der Plan wurde nach der Operation erstellt: Er ist keine Vorhersage und zählt nicht unter den Ergebnissen.</translation>
    </message>
    <message>
        <source>plan (band)</source>
        <translation>Plan (Band)</translation>
    </message>
    <message>
        <source>Inserted length</source>
        <translation>Inserierte Länge</translation>
    </message>
    <message>
        <source>Bands: %1.</source>
        <translation>Bänder: %1.</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)°</source>
        <translation>%1 (%2 bis %3)°</translation>
    </message>
    <message>
        <source>Contacts outside: %1 as the surgeon states, %2 in the CT.</source>
        <translation>Kontakte außen: %1 nach Angabe des Operateurs, %2 im CT.</translation>
    </message>
    <message>
        <source>The mark at %1 mm was reached as the surgeon states, and %2 mm are inserted in the CT.</source>
        <translation>Die Marke bei %1 mm wurde nach Angabe des Operateurs erreicht, und %2 mm sind im CT inseriert.</translation>
    </message>
    <message>
        <source>Contacts, 1 at the tip; E: the electrode’s number in its maker’s fitting software</source>
        <translation>Kontakte, 1 an der Spitze; E: Nummer der Elektrode in der Anpasssoftware des Herstellers</translation>
    </message>
    <message>
        <source>in ST</source>
        <translation>in ST</translation>
    </message>
    <message>
        <source>mod., mm</source>
        <translation>Mod., mm</translation>
    </message>
    <message>
        <source>GW, kHz</source>
        <translation>GW, kHz</translation>
    </message>
    <message>
        <source>SG, kHz (95 %)</source>
        <translation>SG, kHz (95 %)</translation>
    </message>
    <message>
        <source>filter, kHz</source>
        <translation>Filter, kHz</translation>
    </message>
    <message>
        <source>%1 (%2–%3)</source>
        <translation>%1 (%2–%3)</translation>
    </message>
    <message>
        <source>Positions are those of metal in the CT, with their errors; the basilar membrane is not visible, so that in scala tympani (ST) is a probability and no diagnosis. mod.: distance to the inner wall. Place frequencies are estimated, GW by Greenwood’s map, SG on the spiral ganglion; their intervals are those of the angle, and listeners vary beyond them. filter: center of the default filter; mismatch: SG above it, in semitones. Plan: median and band of simulated insertions, of a contact those in which it is inside; percentile: share of them below the value found. Angles are counted from the round window.</source>
        <translation>Positionen sind die von Metall im CT, mit ihren Fehlern; die Basilarmembran ist nicht zu sehen, deshalb ist „in der Scala tympani“ (ST) eine Wahrscheinlichkeit und keine Diagnose. Mod.: Abstand zur inneren Wand. Ortsfrequenzen sind geschätzt, GW nach Greenwoods Karte, SG am Spiralganglion; ihre Intervalle sind die des Winkels, und Hörende streuen darüber hinaus. Filter: Mitte des Standardfilters; Abw.: SG darüber, in Halbtönen (HT). Plan: Median und Band simulierter Insertionen, bei einem Kontakt derer, in denen er innen liegt; Perzentil: Anteil davon unter dem gefundenen Wert. Winkel zählen ab dem runden Fenster.</translation>
    </message>
    <message>
        <source>%1 (E%2)</source>
        <translation>%1 (E%2)</translation>
    </message>
    <message>
        <source>inserted at %1 mm/s</source>
        <translation>inseriert mit %1 mm/s</translation>
    </message>
    <message>
        <source>mismatch, st (95 %)</source>
        <translation>Abw., HT (95 %)</translation>
    </message>
    <message>
        <source>Bone of the patient’s CT</source>
        <translation>Knochen aus dem CT des Patienten</translation>
    </message>
    <message>
        <source>Schematic: landmarks of this model; it has no bone.</source>
        <translation>Schema: Landmarken dieses Modells; es hat keinen Knochen.</translation>
    </message>
    <message>
        <source>Schematic: landmarks of the average cochlea, scaled to the patient’s measures.</source>
        <translation>Schema: Landmarken der mittleren Cochlea, skaliert auf die Maße des Patienten.</translation>
    </message>
    <message>
        <source>There is no CT of this patient.</source>
        <translation>Von diesem Patienten gibt es kein CT.</translation>
    </message>
    <message>
        <source>The bone appears once the CT of this patient is open and measured on page CT.</source>
        <translation>Der Knochen erscheint, sobald das CT dieses Patienten auf der Seite CT geöffnet und gemessen ist.</translation>
    </message>
    <message>
        <source>Drag: rotate. Drag the handle, Ctrl+drag or Page Up, Page Down: move the cut. V: turn the cut to the viewer. Wheel: zoom.</source>
        <translation>Ziehen: drehen. Griff ziehen, Strg+Ziehen oder Bild auf, Bild ab: Schnitt verschieben. V: Schnitt zum Betrachter drehen. Rad: vergrößern.</translation>
    </message>
    <message>
        <source>bone and landmarks on or off</source>
        <translation>Knochen und Landmarken ein- oder ausblenden</translation>
    </message>
    <message>
        <source>move the cut of the bone</source>
        <translation>Schnitt durch den Knochen verschieben</translation>
    </message>
    <message>
        <source>turn the cut to the viewer</source>
        <translation>Schnitt zum Betrachter drehen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Facial nerve</source>
        <translation>N. facialis</translation>
    </message>
    <message>
        <source>Chorda tympani</source>
        <translation>Chorda tympani</translation>
    </message>
    <message>
        <source>Canal wall</source>
        <translation>Gehörgangswand</translation>
    </message>
    <message>
        <source>%1 ± %2°</source>
        <translation>%1 ± %2°</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>LPS %1 mm</source>
        <translation>LPS %1 mm</translation>
    </message>
    <message>
        <source>outside the CT</source>
        <translation>außerhalb des CT</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>%1, unit not stated</source>
        <translation>%1, Einheit nicht angegeben</translation>
    </message>
    <message>
        <source>%1 HU</source>
        <translation>%1 HE</translation>
    </message>
    <message>
        <source>%1, gray value, not HU</source>
        <translation>%1, Grauwert, keine HE</translation>
    </message>
    <message>
        <source>single layer, voxels %1 mm</source>
        <translation>einzelne Schicht, Voxel %1 mm</translation>
    </message>
    <message>
        <source>slab %1 mm, mean</source>
        <translation>Schicht %1 mm, Mittelwert</translation>
    </message>
    <message>
        <source>slab %1 mm, maximum</source>
        <translation>Schicht %1 mm, Maximum</translation>
    </message>
    <message>
        <source>%1 · through LPS %2 mm · %3 · level %4, width %5</source>
        <translation>%1 · durch LPS %2 mm · %3 · Fenster %4, Breite %5</translation>
    </message>
    <message>
        <source>Key images of the CT</source>
        <translation>Schlüsselbilder des CT</translation>
    </message>
    <message>
        <source>Key image %1</source>
        <translation>Schlüsselbild %1</translation>
    </message>
    <message>
        <source>D, A, N; Return; Esc</source>
        <translation>D, A, N; Eingabe; Esc</translation>
    </message>
    <message>
        <source>distance, angle, note; next point at the crosshair; end the tool</source>
        <translation>Abstand, Winkel, Notiz; nächster Punkt am Fadenkreuz; Werkzeug beenden</translation>
    </message>
    <message>
        <source>Del; Ctrl+Z, Ctrl+Shift+Z; K</source>
        <translation>Entf; Strg+Z, Strg+Umschalt+Z; K</translation>
    </message>
    <message>
        <source>remove the chosen markup; undo, redo; keep a key image for the report</source>
        <translation>gewählte Markierung entfernen; rückgängig, wiederholen; Schlüsselbild für den Bericht behalten</translation>
    </message>
    <message>
        <source>Click along the center of its canal: the mastoid part below the lateral semicircular canal, in axial slices from above downward.</source>
        <translation>Entlang der Mitte seines Kanals klicken: den mastoidalen Abschnitt unterhalb des lateralen Bogengangs, in axialen Schichten von oben nach unten.</translation>
    </message>
    <message>
        <source>Click along its canal, from the mastoid part of the facial nerve up to the tympanic cavity. Where the slices do not show it, it is not marked.</source>
        <translation>Entlang ihres Kanals klicken, vom mastoidalen Abschnitt des N. facialis aufwärts bis zur Paukenhöhle. Wo die Schichten sie nicht zeigen, wird sie nicht markiert.</translation>
    </message>
    <message>
        <source>Click on the surface of the posterior wall of the ear canal that faces the mastoid.</source>
        <translation>Auf die dem Mastoid zugewandte Fläche der hinteren Gehörgangswand klicken.</translation>
    </message>
    <message>
        <source>Line of approach</source>
        <translation>Zugangslinie</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Zugang</translation>
    </message>
    <message>
        <source>Approach, from which simulations deviate: %1.</source>
        <translation>Zugang, von dem die Simulationen abweichen: %1.</translation>
    </message>
    <message>
        <source>Approach: %1.</source>
        <translation>Zugang: %1.</translation>
    </message>
    <message>
        <source>along the axis of the opening</source>
        <translation>in der Achse der Öffnung</translation>
    </message>
    <message>
        <source>line of approach</source>
        <translation>Zugangslinie</translation>
    </message>
    <message>
        <source>Bone: drag the handle of the line, Shift+arrow keys; Home</source>
        <translation>Knochen: Griff der Linie ziehen, Umschalt+Pfeiltasten; Pos1</translation>
    </message>
    <message>
        <source>turn the line of approach; along the axis of the opening</source>
        <translation>Zugangslinie drehen; in die Achse der Öffnung legen</translation>
    </message>
    <message>
        <source>%1° toward the lateral wall</source>
        <translation>%1° zur Außenwand</translation>
    </message>
    <message>
        <source>%1° toward the modiolus</source>
        <translation>%1° zum Modiolus</translation>
    </message>
    <message>
        <source>%1° toward the basilar membrane</source>
        <translation>%1° zur Basilarmembran</translation>
    </message>
    <message>
        <source>%1° toward the floor of the scala tympani</source>
        <translation>%1° zum Boden der Scala tympani</translation>
    </message>
    <message>
        <source>%1 in the plane of the basal turn, %2 out of it</source>
        <translation>%1 in der Ebene der Basalwindung, %2 aus ihr</translation>
    </message>
    <message>
        <source>The simulation allows at most %1° of tilt and of turn from the axis of the opening.</source>
        <translation>Die Simulation erlaubt höchstens %1° Neigung und Drehung gegenüber der Achse der Öffnung.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::AboutOverlay</name>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Cochlear-implant insertion workstation for research and training. Not a medical device.</source>
        <translation>Arbeitsplatz für Cochlea-Implantat-Insertionen, für Forschung und Training. Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>License: BSD 3-clause, in the file LICENSE of the source and of the package.</source>
        <translation>Lizenz: BSD 3-Clause, in der Datei LICENSE der Quellen und des Pakets.</translation>
    </message>
    <message>
        <source>Log file: %1</source>
        <translation>Protokolldatei: %1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::AngleRing</name>
    <message>
        <source>Angles of the contacts from the round window</source>
        <translation>Winkel der Kontakte vom runden Fenster</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Contacts at their median angles from the round window, seen from the apex; arcs: the band that the head names. The radius is not to scale.</source>
        <translation>Kontakte an ihren mittleren Winkeln vom runden Fenster, vom Apex gesehen; Bögen: das Band, das der Kopf nennt. Der Radius ist nicht maßstäblich.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::Application</name>
    <message>
        <source>The action failed: %1</source>
        <translation>Die Aktion ist fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Something went wrong. See the log.</source>
        <translation>Es ist ein Fehler aufgetreten. Siehe Protokoll.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ArchiveQuery</name>
    <message>
        <source>YYYY-MM-DD</source>
        <translation>JJJJ-MM-TT</translation>
    </message>
    <message>
        <source>Patient number</source>
        <translation>Patientennummer</translation>
    </message>
    <message>
        <source>4711, 47*</source>
        <translation>4711, 47*</translation>
    </message>
    <message>
        <source>Patient name</source>
        <translation>Patientenname</translation>
    </message>
    <message>
        <source>Doe^Jane, Doe*</source>
        <translation>Doe^Jane, Doe*</translation>
    </message>
    <message>
        <source>Birth date</source>
        <translation>Geburtsdatum</translation>
    </message>
    <message>
        <source>Study date from</source>
        <translation>Untersucht ab</translation>
    </message>
    <message>
        <source>Study date until</source>
        <translation>Untersucht bis</translation>
    </message>
    <message>
        <source>CT only</source>
        <translation>Nur CT</translation>
    </message>
    <message>
        <source>Some archives ignore this. Cone-beam scans are CT in DICOM, too.</source>
        <translation>Manche Archive beachten dies nicht. Auch DVT-Aufnahmen sind in DICOM CT.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ArchiveView</name>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Retrieve and measure</source>
        <translation>Abrufen und messen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Archives…</source>
        <translation>Archive …</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Enter, change and test archives</source>
        <translation>Archive eintragen, ändern und prüfen</translation>
    </message>
    <message>
        <source>From the archive</source>
        <translation>Aus dem Archiv</translation>
    </message>
    <message>
        <source>The first %1 studies; the archive has more: narrow the query.</source>
        <translation>Die ersten %1 Studien; das Archiv hat mehr: Grenzen Sie die Suche ein.</translation>
    </message>
    <message>
        <source>No study matches.</source>
        <translation>Keine Studie passt.</translation>
    </message>
    <message numerus="yes">
        <source>%n studies</source>
        <translation>
            <numerusform>%n Studie</numerusform>
            <numerusform>%n Studien</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a series of thin slices with a bone kernel, and retrieve it.</source>
        <translation>Wählen Sie eine Serie dünner Schichten mit Knochenkernel, und rufen Sie sie ab.</translation>
    </message>
    <message>
        <source>Canceled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>No archive is entered yet. Press Archives… and ask its administrator for AE title, host and port.</source>
        <translation>Noch ist kein Archiv eingetragen. Drücken Sie Archive … und fragen Sie seinen Administrator nach AE-Titel, Rechner und Port.</translation>
    </message>
    <message>
        <source>Asking the archive…</source>
        <translation>Das Archiv wird gefragt …</translation>
    </message>
    <message>
        <source>Asking for the series…</source>
        <translation>Nach den Serien wird gefragt …</translation>
    </message>
    <message>
        <source>Retrieving the series…</source>
        <translation>Die Serie wird abgerufen …</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ArraySection</name>
    <message>
        <source>Array</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>array %1</source>
        <translation>Träger %1</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Advance off-stylet</source>
        <translation>Advance-off-Stylet</translation>
    </message>
    <message>
        <source>technique: %1</source>
        <translation>Technik: %1</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>speed %1 mm/s</source>
        <translation>Tempo %1 mm/s</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>friction: %1</source>
        <translation>Reibung: %1</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>Cochleostomy</source>
        <translation>Cochleostomie</translation>
    </message>
    <message>
        <source>Round window</source>
        <translation>Rundes Fenster</translation>
    </message>
    <message>
        <source>opening: %1</source>
        <translation>Öffnung: %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Elastic rod</source>
        <translation>Elastischer Stab</translation>
    </message>
    <message>
        <source>model: %1</source>
        <translation>Modell: %1</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 Knoten</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>kalibriert</translation>
    </message>
    <message>
        <source>this array has no stylet</source>
        <translation>dieser Träger hat kein Stilett</translation>
    </message>
    <message>
        <source>The stylet stays in place until full depth.</source>
        <translation>Das Stilett bleibt bis zur vollen Tiefe im Träger.</translation>
    </message>
    <message>
        <source>The stylet is held at a fixed depth and the array is advanced off it.</source>
        <translation>Das Stilett wird in fester Tiefe gehalten und der Träger von ihm abgeschoben.</translation>
    </message>
    <message>
        <source>Insertion speed of the scripted insertion.</source>
        <translation>Geschwindigkeit der automatischen Insertion.</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>Stopp bei</translation>
    </message>
    <message>
        <source>Travel at which the insertion stops.</source>
        <translation>Vorschub, bei dem die Insertion endet.</translation>
    </message>
    <message>
        <source>stop at %1 mm</source>
        <translation>Stopp bei %1 mm</translation>
    </message>
    <message>
        <source>Coulomb friction between array and wall: static and kinetic coefficient.</source>
        <translation>Coulomb-Reibung zwischen Träger und Wand: Haft- und Gleitreibungszahl.</translation>
    </message>
    <message>
        <source>A drilled round opening; marker ribs contact its edge.</source>
        <translation>Eine gebohrte runde Öffnung; Markierungsringe berühren ihren Rand.</translation>
    </message>
    <message>
        <source>1.37 × 1.91 mm, mean, n = 20 (Benha Med J 2018;35:246).</source>
        <translation>1,37 × 1,91 mm, Mittelwert, n = 20 (Benha Med J 2018;35:246).</translation>
    </message>
    <message>
        <source>Wide opening (no edge contact)</source>
        <translation>Weite Öffnung (kein Randkontakt)</translation>
    </message>
    <message>
        <source>The array contacts the scala wall only.</source>
        <translation>Der Träger berührt nur die Skalenwand.</translation>
    </message>
    <message>
        <source>The array is an elastic rod discretized into nodes.</source>
        <translation>Der Träger ist ein elastischer Stab aus diskreten Knoten.</translation>
    </message>
    <message>
        <source>Point set (published)</source>
        <translation>Punktmodell (veröffentlicht)</translation>
    </message>
    <message>
        <source>The published model: sample points coupled by springs, with its known limits.</source>
        <translation>Das veröffentlichte Modell: Stützpunkte an Federn, mit den bekannten Grenzen.</translation>
    </message>
    <message>
        <source>Number of nodes of the rod, or of sample points.</source>
        <translation>Anzahl der Stabknoten oder Stützpunkte.</translation>
    </message>
    <message>
        <source>Stiffness and curvature were fitted to published forces: %1.</source>
        <translation>Steifigkeit und Krümmung sind an veröffentlichte Kräfte angepasst: %1.</translation>
    </message>
    <message>
        <source>no stylet depth is known for this array</source>
        <translation>für diesen Träger ist keine Stiletttiefe bekannt</translation>
    </message>
    <message>
        <source>static %1 · kinetic %2</source>
        <translation>Haft- %1 · Gleitreibung %2</translation>
    </message>
    <message>
        <source>%1–%2, speed-dependent</source>
        <translation>%1–%2, geschwindigkeitsabhängig</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>%1 %2. Enter a valid value or press Esc.</source>
        <translation>%1 %2. Gültigen Wert eingeben oder Esc drücken.</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experte</translation>
    </message>
    <message>
        <source>Handling of the stylet during the insertion.</source>
        <translation>Handhabung des Stiletts während der Insertion.</translation>
    </message>
    <message>
        <source>Friction between array and wall. A choice with its source is in the list.</source>
        <translation>Reibung zwischen Träger und Wand. Die Liste nennt die Quellen.</translation>
    </message>
    <message>
        <source>Opening through which the array enters the scala tympani.</source>
        <translation>Öffnung, durch die der Träger in die Scala tympani eintritt.</translation>
    </message>
    <message>
        <source>Mechanical model of the array.</source>
        <translation>Mechanisches Modell des Trägers.</translation>
    </message>
    <message>
        <source>Sample rate of the haptic loop, samples that started more than one period late, and frames per second of the window.</source>
        <translation>Abtastrate der haptischen Schleife, Abtastwerte mit mehr als einer Periode Verspätung, und Bilder pro Sekunde des Fensters.</translation>
    </message>
    <message>
        <source>The line of approach. It is turned on the page CT, in the picture of the bone.</source>
        <translation>Die Zugangslinie. Sie wird auf der Seite CT gedreht, im Bild des Knochens.</translation>
    </message>
    <message>
        <source>Approach: %1</source>
        <translation>Zugang: %1</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::BottomBar</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Zurückziehen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Start or pause the insertion (Space)</source>
        <translation>Insertion starten oder anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Withdraw the array (Backspace)</source>
        <translation>Träger zurückziehen (Rücktaste)</translation>
    </message>
    <message>
        <source>New insertion and recording (Ctrl+R)</source>
        <translation>Neue Insertion und Aufzeichnung (Strg+R)</translation>
    </message>
    <message>
        <source>The cochlea is being built; the insertion can start afterwards.</source>
        <translation>Die Cochlea wird berechnet; danach kann die Insertion beginnen.</translation>
    </message>
    <message>
        <source>Recorded time since the first motion; after the insertion time it includes the rest</source>
        <translation>Aufgezeichnete Zeit seit der ersten Bewegung; nach der Insertionsdauer enthält sie die Ruhe</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::BuildingNote</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Building the cochlea… %1 s</source>
        <translation>Die Cochlea wird berechnet … %1 s</translation>
    </message>
    <message>
        <source>Keep the cochlea and array shown (Esc)</source>
        <translation>Gezeigte Cochlea und gezeigten Träger behalten (Esc)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ComparePage</name>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n recording(s)…</source>
        <translation>
            <numerusform>Eine Aufzeichnung wird gelesen …</numerusform>
            <numerusform>%n Aufzeichnungen werden gelesen …</numerusform>
        </translation>
    </message>
    <message>
        <source>Compare insertions</source>
        <translation>Insertionen vergleichen</translation>
    </message>
    <message>
        <source>Select two or more recordings on the Recordings page and press Compare to plot their insertion forces on common axes, with the published measurements.</source>
        <translation>Auf der Seite Aufzeichnungen zwei oder mehr wählen und „Vergleichen“ drücken: Ihre Insertionskräfte erscheinen auf gemeinsamen Achsen, mit den veröffentlichten Messungen.</translation>
    </message>
    <message>
        <source>Esc cancels.</source>
        <translation>Esc bricht ab.</translation>
    </message>
    <message>
        <source>Recordings cannot be compared</source>
        <translation>Aufzeichnungen nicht vergleichbar</translation>
    </message>
    <message>
        <source>Canceled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Select two or more recordings on the Recordings page and press Compare.</source>
        <translation>Auf der Seite Aufzeichnungen zwei oder mehr wählen und „Vergleichen“ drücken.</translation>
    </message>
    <message>
        <source>%1: %2 % (%3). Criterion: %4. Source: %5.</source>
        <translation>%1: %2 % (%3). Kriterium: %4. Quelle: %5.</translation>
    </message>
    <message>
        <source>Export to folder</source>
        <translation>In Ordner exportieren</translation>
    </message>
    <message>
        <source>Choose recordings</source>
        <translation>Aufzeichnungen wählen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Export tables, curves and events as CSV and the figure as SVG and PNG.</source>
        <translation>Tabellen, Kurven und Ereignisse als CSV und die Abbildung als SVG und PNG exportieren.</translation>
    </message>
    <message>
        <source>○  published measurements of this array, mean ± SD</source>
        <translation>○  veröffentlichte Messungen dieses Elektrodenträgers, Mittelwert ± SD</translation>
    </message>
    <message>
        <source>Insertion force</source>
        <translation>Insertionskraft</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>insertion depth</source>
        <translation>Insertionstiefe</translation>
    </message>
    <message>
        <source>tip angle</source>
        <translation>Winkel der Spitze</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>none: each insertion</source>
        <translation>keine: jede Insertion</translation>
    </message>
    <message>
        <source>by array</source>
        <translation>nach Elektrodenträger</translation>
    </message>
    <message>
        <source>by technique</source>
        <translation>nach Technik</translation>
    </message>
    <message>
        <source>by patient</source>
        <translation>nach Patient</translation>
    </message>
    <message>
        <source>by array and technique</source>
        <translation>nach Elektrodenträger und Technik</translation>
    </message>
    <message>
        <source>rib %1 at the opening</source>
        <translation>Rippe %1 an der Öffnung</translation>
    </message>
    <message>
        <source>%1 files saved to %2.</source>
        <translation>%1 Dateien in %2 gespeichert.</translation>
    </message>
    <message>
        <source>Score of %1: insertion × peak force × geometric mean of speed, reversals and smoothness. Rates technique only; it does not assess trauma.</source>
        <translation>Bewertung von %1: Insertion × Maximalkraft × geometrisches Mittel von Geschwindigkeit, Rückzügen und Gleichmäßigkeit. Bewertet nur die Technik, nicht das Trauma.</translation>
    </message>
    <message>
        <source>by friction</source>
        <translation>nach Reibung</translation>
    </message>
    <message>
        <source>by set speed</source>
        <translation>nach eingestellter Geschwindigkeit</translation>
    </message>
    <message>
        <source>Differences of means with their 95 % intervals (Welch). %1 quantities are compared; the intervals are not corrected for their number.</source>
        <translation>Differenzen der Mittelwerte mit 95-%-Intervallen (Welch). %1 Größen werden verglichen; die Intervalle sind dafür nicht korrigiert.</translation>
    </message>
    <message>
        <source>%1 mixes insertions that differ in %2.</source>
        <translation>%1 mischt verschiedene Insertionen; es unterscheiden sich: %2.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ComparisonPlot</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>travel, mm</source>
        <translation>Vorschub, mm</translation>
    </message>
    <message>
        <source>insertion force, mN</source>
        <translation>Insertionskraft, mN</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Insertion force</source>
        <translation>Insertionskraft</translation>
    </message>
    <message>
        <source>insertion depth, mm</source>
        <translation>Insertionstiefe, mm</translation>
    </message>
    <message>
        <source>tip angle, °</source>
        <translation>Winkel der Spitze, °</translation>
    </message>
    <message>
        <source>%1 ± %2 mN</source>
        <translation>%1 ± %2 mN</translation>
    </message>
    <message>
        <source>%1 mN</source>
        <translation>%1 mN</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ContactTable</name>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Number of the contact; 1 at the tip</source>
        <translation>Nummer des Kontakts; 1 an der Spitze</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>To modiolus</source>
        <translation>Zum Modiolus</translation>
    </message>
    <message>
        <source>From the center line of the array to the inner wall. Median and the band that the head names.</source>
        <translation>Von der Mittellinie des Trägers zur Innenwand. Median und das Band, das der Kopf nennt.</translation>
    </message>
    <message>
        <source>Greenwood</source>
        <translation>Greenwood</translation>
    </message>
    <message>
        <source>Frequency of the place along the organ of Corti (Greenwood 1990)</source>
        <translation>Frequenz des Ortes entlang des Corti-Organs (Greenwood 1990)</translation>
    </message>
    <message>
        <source>Spiral ganglion</source>
        <translation>Spiralganglion</translation>
    </message>
    <message>
        <source>Frequency of the spiral ganglion at the angle (Stakhovskaya et al. 2007)</source>
        <translation>Frequenz des Spiralganglions am Winkel (Stakhovskaya et al. 2007)</translation>
    </message>
    <message>
        <source>Default filter</source>
        <translation>Standard-Filter</translation>
    </message>
    <message>
        <source>Center of the filter that the contact gets by default; – if no allocation is known</source>
        <translation>Mitte des Filters, den der Kontakt standardmäßig erhält; – wenn keine Zuordnung bekannt ist</translation>
    </message>
    <message>
        <source>Mismatch</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Frequency of its place on the spiral ganglion above its default filter, in semitones; positive: it hears a lower frequency than its place</source>
        <translation>Frequenz seines Ortes am Spiralganglion über seinem Standardfilter, in Halbtönen; positiv: Er hört eine tiefere Frequenz als sein Ort</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 st</source>
        <translation>%1 HT</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>From the round window. Median and the band that the head names.</source>
        <translation>Vom runden Fenster. Median und das Band, das der Kopf nennt.</translation>
    </message>
    <message>
        <source>Simulations in which the contact is inserted; the other columns are over these</source>
        <translation>Simulationen, in denen der Kontakt eingeführt ist; die anderen Spalten gelten für diese</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::CtNextSteps</name>
    <message>
        <source>Insert into this cochlea</source>
        <translation>In diese Cochlea inserieren</translation>
    </message>
    <message>
        <source>Plan with this cochlea</source>
        <translation>Mit dieser Cochlea planen</translation>
    </message>
    <message>
        <source>Save surface…</source>
        <translation>Oberfläche speichern …</translation>
    </message>
    <message>
        <source>Patient code</source>
        <translation>Patientencode</translation>
    </message>
    <message>
        <source>Patient code (no names)</source>
        <translation>Patientencode (kein Name)</translation>
    </message>
    <message>
        <source>The fitted wall in the CT’s own frame (LPS): STL, PLY, glTF, OBJ, VTP</source>
        <translation>Angepasste Wand im Koordinatensystem des CT (LPS): STL, PLY, glTF, OBJ, VTP</translation>
    </message>
    <message>
        <source>Type a patient code first.</source>
        <translation>Zuerst einen Patientencode eingeben.</translation>
    </message>
    <message>
        <source>The landmarks moved: the cochlea is measured first.</source>
        <translation>Die Landmarken wurden bewegt: Die Cochlea wird zuerst gemessen.</translation>
    </message>
    <message>
        <source>Angular insertion depth, coverage and forces of electrode arrays in this cochlea, before one is inserted</source>
        <translation>Insertionswinkel, Abdeckung und Kräfte von Elektrodenträgern in dieser Cochlea, bevor einer eingeführt wird</translation>
    </message>
    <message>
        <source>Send to the archive…</source>
        <translation>An das Archiv senden …</translation>
    </message>
    <message>
        <source>Measures, lumen and picture into the study of this CT, as DICOM (SR, SEG, secondary capture)</source>
        <translation>Maße, Lumen und Bild in die Studie dieses CT, als DICOM (SR, SEG, Secondary Capture)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::CtPage</name>
    <message>
        <source>A patient’s CT</source>
        <translation>CT eines Patienten</translation>
    </message>
    <message>
        <source>Open a folder with a temporal-bone CT, or drop it here. The cochlea is found and measured; then insert into it.</source>
        <translation>Ordner mit einem Felsenbein-CT öffnen oder hier ablegen. Die Cochlea wird gefunden und gemessen; danach kann darin inseriert werden.</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>Reading the CT…</source>
        <translation>Das CT wird gelesen …</translation>
    </message>
    <message>
        <source>Measuring the cochlea…</source>
        <translation>Die Cochlea wird gemessen …</translation>
    </message>
    <message>
        <source>Looking for the cochlea…</source>
        <translation>Die Cochlea wird gesucht …</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Gespeichert in %1.</translation>
    </message>
    <message>
        <source>Surface of the cochlea</source>
        <translation>Oberfläche der Cochlea</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Open folder…</source>
        <translation>Ordner öffnen …</translation>
    </message>
    <message>
        <source>The CT in which %1 was measured is no longer where it was read, or was never read on this computer. Open its folder here.</source>
        <translation>Das CT, in dem %1 vermessen wurde, ist nicht mehr, wo es gelesen wurde, oder wurde nie auf diesem Rechner gelesen. Öffnen Sie seinen Ordner hier.</translation>
    </message>
    <message>
        <source>From the archive…</source>
        <translation>Aus dem Archiv …</translation>
    </message>
    <message>
        <source>The CT is no longer where it was read. Open its folder here.</source>
        <translation>Das CT ist nicht mehr dort, wo es gelesen wurde. Öffnen Sie hier seinen Ordner.</translation>
    </message>
    <message>
        <source>Recent CTs</source>
        <translation>Letzte CTs</translation>
    </message>
    <message>
        <source>%1 The CT shown is the one that was open before.</source>
        <translation>%1 Das gezeigte CT ist das zuvor geöffnete.</translation>
    </message>
    <message>
        <source>Kept with the patient by a plan or an insertion</source>
        <translation>Wird mit einem Plan oder einer Insertion beim Patienten behalten</translation>
    </message>
    <message>
        <source>Kept with %1</source>
        <translation>Behalten bei %1</translation>
    </message>
    <message>
        <source>Bone and measured cochlea, 3D</source>
        <translation>Knochen und gemessene Cochlea, 3D</translation>
    </message>
    <message>
        <source>Key image %1 goes into the reports of this CT’s patient.</source>
        <translation>Schlüsselbild %1 kommt in die Berichte des Patienten dieses CT.</translation>
    </message>
    <message>
        <source>Caption of the key image, Return keeps it, Esc drops it</source>
        <translation>Bildunterschrift; Eingabe behält, Esc verwirft</translation>
    </message>
    <message>
        <source>Markups</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>%1 markups were loaded.</source>
        <translation>%1 Markierungen wurden geladen.</translation>
    </message>
    <message>
        <source>An insertion into this cochlea is in progress, or is replayed: reset it, or close the replay, to turn its line of approach.</source>
        <translation>Eine Insertion in diese Cochlea läuft oder wird wiedergegeben: Setzen Sie sie zurück, oder schließen Sie die Wiedergabe, um ihre Zugangslinie zu drehen.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::CtPanel</name>
    <message>
        <source>VIEW</source>
        <translation>ANSICHT</translation>
    </message>
    <message>
        <source>Axial, coronal, sagittal</source>
        <translation>Axial, koronar, sagittal</translation>
    </message>
    <message>
        <source>Cochlear view</source>
        <translation>Cochleaansicht</translation>
    </message>
    <message>
        <source>The plane through the basal turn, perpendicular to the modiolus, and two mid-modiolar planes. Needs a measured cochlea.</source>
        <translation>Ebene durch die Basalwindung, senkrecht zum Modiolus, und zwei mittmodiolare Ebenen. Braucht eine gemessene Cochlea.</translation>
    </message>
    <message>
        <source>Gray values</source>
        <translation>Grauwerte</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alle Werte</translation>
    </message>
    <message>
        <source>Bone: level 700, width 4000 HU. Soft tissue: level 40, width 400 HU. Drag with the right mouse button to change brightness and contrast.</source>
        <translation>Knochen: Mitte 700, Breite 4000 HU. Weichteile: Mitte 40, Breite 400 HU. Mit der rechten Maustaste ziehen ändert Helligkeit und Kontrast.</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>Single layer</source>
        <translation>Einzelschicht</translation>
    </message>
    <message>
        <source>Slab 1 mm, mean</source>
        <translation>1 mm, Mittelwert</translation>
    </message>
    <message>
        <source>Slab 2 mm, mean</source>
        <translation>2 mm, Mittelwert</translation>
    </message>
    <message>
        <source>Slab 2 mm, maximum</source>
        <translation>2 mm, Maximum</translation>
    </message>
    <message>
        <source>Find and measure the cochlea</source>
        <translation>Cochlea suchen und messen</translation>
    </message>
    <message>
        <source>Measure at the crosshair</source>
        <translation>Am Fadenkreuz messen</translation>
    </message>
    <message>
        <source>Click inside the cochlea first.</source>
        <translation>Zuerst in die Cochlea klicken.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>CDL</source>
        <translation>CDL</translation>
    </message>
    <message>
        <source>LANDMARKS</source>
        <translation>LANDMARKEN</translation>
    </message>
    <message>
        <source>%1. Press, then click into a picture. %2</source>
        <translation>%1. Drücken, dann in ein Bild klicken. %2</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden …</translation>
    </message>
    <message>
        <source>Re-measure using landmarks</source>
        <translation>Anhand der Landmarken neu messen</translation>
    </message>
    <message>
        <source>Left ear</source>
        <translation>Linkes Ohr</translation>
    </message>
    <message>
        <source>Right ear</source>
        <translation>Rechtes Ohr</translation>
    </message>
    <message>
        <source>Markups for 3D Slicer (.mrk.json, LPS): landmarks, axis, and the inserted array with its contacts</source>
        <translation>Markups für 3D Slicer (.mrk.json, LPS): Landmarken, Achse und der eingeführte Träger mit seinen Kontakten</translation>
    </message>
    <message>
        <source>Landmarks moved: measure again.</source>
        <translation>Landmarken bewegt: neu messen.</translation>
    </message>
    <message>
        <source>fitted before (95 % CI)</source>
        <translation>frühere Anpassung (95 %-KI)</translation>
    </message>
    <message>
        <source>used: fitted (95 % CI)</source>
        <translation>verwendet: Anpassung (95 %-KI)</translation>
    </message>
    <message>
        <source>Markups of 3D Slicer with points named RW, LW, B1, B2, base, apex, M, or as this program saves them</source>
        <translation>Markups von 3D Slicer mit Punkten namens RW, LW, B1, B2, base, apex, M, oder wie dieses Programm sie speichert</translation>
    </message>
    <message>
        <source>1  SCAN</source>
        <translation>1  SCAN</translation>
    </message>
    <message>
        <source>2  CHECK</source>
        <translation>2  PRÜFEN</translation>
    </message>
    <message>
        <source>3  USE</source>
        <translation>3  VERWENDEN</translation>
    </message>
    <message>
        <source>from landmarks</source>
        <translation>aus Landmarken</translation>
    </message>
    <message>
        <source>APPROACH TO THE BASAL TURN</source>
        <translation>ZUGANG ZUR BASALWINDUNG</translation>
    </message>
    <message>
        <source>in its plane</source>
        <translation>in ihrer Ebene</translation>
    </message>
    <message>
        <source>out of it</source>
        <translation>aus ihr</translation>
    </message>
    <message>
        <source>Along the axis of the opening</source>
        <translation>In der Achse der Öffnung</translation>
    </message>
    <message>
        <source>Home, in the picture of the bone</source>
        <translation>Pos1, im Bild des Knochens</translation>
    </message>
    <message>
        <source>Where the array points at the opening, from the tangent of the scala tympani’s center line there. Turn the line by its handle in the picture of the bone. Insert and Plan use it.</source>
        <translation>Wohin der Träger an der Öffnung zeigt, gegenüber der dortigen Tangente der Mittellinie der Scala tympani. Die Linie an ihrem Griff im Bild des Knochens drehen. Insertion und Plan verwenden sie.</translation>
    </message>
    <message>
        <source>STRUCTURES BESIDE THE APPROACH</source>
        <translation>STRUKTUREN NEBEN DEM ZUGANG</translation>
    </message>
    <message>
        <source>Press, then click points into the pictures; press again to end. %1</source>
        <translation>Drücken, dann Punkte in den Bildern anklicken; erneut drücken, um zu enden. %1</translation>
    </message>
    <message>
        <source>Shortest distance between the line of approach and the marked course, with its 95 % interval: from placing by hand (standard deviation 0.3 mm) and from the voxels. It leaves out the width of the structure and of an instrument, navigation and the hand.</source>
        <translation>Kürzester Abstand zwischen der Zugangslinie und dem markierten Verlauf, mit 95-%-Intervall: aus dem Setzen von Hand (Standardabweichung 0,3 mm) und aus den Voxeln. Nicht enthalten sind die Breite der Struktur und eines Instruments, Navigation und Hand.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove: %1</source>
        <translation>Entfernen: %1</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::CtSeriesList</name>
    <message>
        <source>Series</source>
        <translation>Serien</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::CtSource</name>
    <message>
        <source>Open folder…</source>
        <translation>Ordner …</translation>
    </message>
    <message>
        <source>Open file…</source>
        <translation>Datei …</translation>
    </message>
    <message>
        <source>A folder with DICOM files, or the folder of a DICOMDIR</source>
        <translation>Ordner mit DICOM-Dateien oder Ordner eines DICOMDIR</translation>
    </message>
    <message>
        <source>DICOM (.zip), DICOMDIR, enhanced DICOM, NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr) or MetaImage (.mha, .mhd)</source>
        <translation>DICOM (.zip), DICOMDIR, Enhanced DICOM, NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr) oder MetaImage (.mha, .mhd)</translation>
    </message>
    <message>
        <source>From the archive…</source>
        <translation>Aus dem Archiv …</translation>
    </message>
    <message>
        <source>Find the CT in a DICOM archive (PACS) and retrieve it</source>
        <translation>Das CT in einem DICOM-Archiv (PACS) suchen und abrufen</translation>
    </message>
    <message>
        <source>Recent CTs</source>
        <translation>Letzte CTs</translation>
    </message>
    <message>
        <source>Recent CTs, by the patient’s code and the date</source>
        <translation>Zuletzt geöffnete CTs, nach Patientencode und Datum</translation>
    </message>
    <message>
        <source>Folder with a temporal-bone CT</source>
        <translation>Ordner mit einem Felsenbein-CT</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::DayView</name>
    <message>
        <source>%1 mN</source>
        <translation>%1 mN</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Visitors</source>
        <translation>Besucher</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Bester</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Gentlest</source>
        <translation>Am sanftesten</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>you</source>
        <translation>Sie</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::DerivedMeasures</name>
    <message>
        <source>Cochlear duct length</source>
        <translation>Länge des Ductus cochlearis</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>wird berechnet …</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Angle and coverage are estimated for straight arrays only.</source>
        <translation>Winkel und Abdeckung werden nur für gerade Träger geschätzt.</translation>
    </message>
    <message>
        <source>± 95 % interval of an error of %1 mm (SD) in each measure and of the duct length’s formula.</source>
        <translation>± 95-%-Intervall bei einem Fehler von je %1 mm (SD) und der Formel der Länge des Ductus.</translation>
    </message>
    <message>
        <source>± 95 % interval of the errors in the CT and of the duct length’s formula.</source>
        <translation>± 95-%-Intervall der Messfehler im CT und der Formel der Länge des Ductus.</translation>
    </message>
    <message>
        <source>Angular insertion depth at the lateral wall</source>
        <translation>Insertionswinkel an der Außenwand</translation>
    </message>
    <message>
        <source>Cochlear coverage at the lateral wall</source>
        <translation>Abdeckung an der Außenwand</translation>
    </message>
    <message>
        <source>Angle and coverage for %1 along the lateral wall, fully inserted: geometry alone. In a plan it may lie nearer the modiolus, at a larger angle, or stop earlier.</source>
        <translation>Winkel und Abdeckung für %1 entlang der Außenwand, vollständig inseriert: allein aus der Geometrie. In einem Plan kann er näher am Modiolus liegen, mit größerem Winkel, oder früher enden.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::DevicePage</name>
    <message>
        <source>force up to %1 N</source>
        <translation>Kraft bis %1 N</translation>
    </message>
    <message>
        <source>no force</source>
        <translation>keine Kraft</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Close (H)</source>
        <translation>Schließen (H)</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>%1 · %2 · report interval %3 ms</source>
        <translation>%1 · %2 · Berichtsabstand %3 ms</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>No HID device is connected.</source>
        <translation>Kein HID-Gerät angeschlossen.</translation>
    </message>
    <message>
        <source>Available without hardware: scripted insertion, and mouse and keyboard.</source>
        <translation>Ohne Gerät verfügbar: automatische Insertion sowie Maus und Tastatur.</translation>
    </message>
    <message>
        <source>Use as input</source>
        <translation>Als Eingabe verwenden</translation>
    </message>
    <message>
        <source>Input: %1</source>
        <translation>Eingabe: %1</translation>
    </message>
    <message>
        <source>Loop: %1 samples/s, %2 late, %3 overruns, 99 % below %4 ms.</source>
        <translation>Schleife: %1 Abtastwerte/s, %2 verspätet, %3 Überläufe, 99 % unter %4 ms.</translation>
    </message>
    <message>
        <source>Reports: %1/s; interval median %2 ms, 99 % below %3 ms, maximum %4 ms.</source>
        <translation>Berichte: %1/s; Abstand im Median %2 ms, 99 % unter %3 ms, maximal %4 ms.</translation>
    </message>
    <message>
        <source>%1 lost, %2 repeated, %3 outdated, %4 invalid.</source>
        <translation>%1 verloren, %2 wiederholt, %3 veraltet, %4 ungültig.</translation>
    </message>
    <message>
        <source>Force output takes %1 ms, 99 % below %2 ms; %3.</source>
        <translation>Kraftausgabe in %1 ms, 99 % unter %2 ms; %3.</translation>
    </message>
    <message>
        <source>No hardware needed; no force feedback.</source>
        <translation>Ohne Gerät; keine Kraftrückkopplung.</translation>
    </message>
    <message>
        <source>Profile %1, confidence %2. %3</source>
        <translation>Profil %1, Konfidenz %2. %3</translation>
    </message>
    <message>
        <source>Loading the installed plug-ins…</source>
        <translation>Installierte Plug-ins werden geladen…</translation>
    </message>
    <message>
        <source>No plug-in is installed.</source>
        <translation>Es ist kein Plug-in installiert.</translation>
    </message>
    <message>
        <source>Plug-ins are installed in %1, for all users in %2.</source>
        <translation>Plug-ins werden in %1 installiert, für alle Benutzer in %2.</translation>
    </message>
    <message>
        <source>%1 (chosen last)</source>
        <translation>%1 (zuletzt gewählt)</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 an %2</translation>
    </message>
    <message>
        <source>Plug-in</source>
        <translation>Plug-in</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::EarQuestion</name>
    <message>
        <source>left</source>
        <translation>linkes</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechtes</translation>
    </message>
    <message>
        <source>The ear in this CT is a %1 one, that of %2 a %3 one.</source>
        <translation>Das Ohr in diesem CT ist ein %1, das von %2 ein %3.</translation>
    </message>
    <message>
        <source>%1 is %2 mm in this CT, %3 mm in the record (95 %).</source>
        <translation>%1 ist %2 mm in diesem CT, %3 mm in der Akte (95 %).</translation>
    </message>
    <message>
        <source>This CT series is in the record of %1.</source>
        <translation>Diese CT-Serie steht in der Akte von %1.</translation>
    </message>
    <message>
        <source>Is this CT of %1?</source>
        <translation>Ist dieses CT von %1?</translation>
    </message>
    <message>
        <source>This CT may be of another person than %1.</source>
        <translation>Dieses CT ist vielleicht von einer anderen Person als %1.</translation>
    </message>
    <message>
        <source>If it is joined, the outcome stands in the record of %1 and in the statistics.</source>
        <translation>Wird es zugeordnet, steht das Ergebnis in der Akte von %1 und in der Statistik.</translation>
    </message>
    <message>
        <source>No, leave it out</source>
        <translation>Nein, nicht zuordnen</translation>
    </message>
    <message>
        <source>It is %1: join it</source>
        <translation>Es ist %1: zuordnen</translation>
    </message>
    <message>
        <source>The images state a %1 ear (Laterality); that of %2 is a %3 one.</source>
        <translation>Die Bilder nennen ein %1 Ohr (Laterality), das von %2 ist ein %3.</translation>
    </message>
    <message>
        <source>The CT before surgery and this one do not agree around the cochlea.</source>
        <translation>Das CT vor der Operation und dieses stimmen um die Cochlea nicht überein.</translation>
    </message>
    <message>
        <source>This CT shows a left ear; the record is that of a right ear.</source>
        <translation>Dieses CT zeigt ein linkes Ohr; die Akte ist die eines rechten.</translation>
    </message>
    <message>
        <source>This CT shows a right ear; the record is that of a left ear.</source>
        <translation>Dieses CT zeigt ein rechtes Ohr; die Akte ist die eines linken.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::FlatViews</name>
    <message>
        <source>Unrolled scala tympani</source>
        <translation>Abgewickelte Scala tympani</translation>
    </message>
    <message>
        <source>angle from round window; width, mm</source>
        <translation>Winkel ab rundem Fenster; Breite, mm</translation>
    </message>
    <message>
        <source>Section at the tip</source>
        <translation>Schnitt an der Spitze</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>at %1°</source>
        <translation>bei %1°</translation>
    </message>
    <message>
        <source>Half-plane through the modiolar axis at the tip, to scale; the angle is measured from the round window. The arrow shows the normal wall force on the last millimeter of array. Where the wall is compliant, the array extends past its outline.</source>
        <translation>Halbebene durch die Modiolusachse an der Spitze, maßstäblich; der Winkel zählt ab dem runden Fenster. Der Pfeil zeigt die normale Wandkraft auf den letzten Millimeter des Trägers. Wo die Wand nachgibt, ragt der Träger über ihre Kontur.</translation>
    </message>
    <message>
        <source>distance to modiolus, mm</source>
        <translation>Abstand zum Modiolus, mm</translation>
    </message>
    <message>
        <source>Distance from the center line of the array at each contact (1 at the tip) to the inner wall, toward the modiolar axis.</source>
        <translation>Abstand der Mittellinie des Trägers an jedem Kontakt (1 an der Spitze) zur Innenwand in Richtung Modiolusachse.</translation>
    </message>
    <message>
        <source>The scala tympani seen along the modiolar axis and unrolled. Bars: normal wall force per millimeter of array; rings: forces from floor and roof. Red: where the cochlear partition is torn, and the array above it.</source>
        <translation>Die Scala tympani entlang der Modiolusachse gesehen und abgewickelt. Balken: normale Wandkraft je Millimeter Träger; Ringe: Kräfte von Boden und Dach. Rot: wo die cochleäre Trennwand gerissen ist, und der Träger darüber.</translation>
    </message>
    <message>
        <source>at %1°, tip in the scala vestibuli</source>
        <translation>bei %1°, Spitze in der Scala vestibuli</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ForceCharts</name>
    <message>
        <source>Force components</source>
        <translation>Kraftkomponenten</translation>
    </message>
    <message>
        <source>last 5 s, mN</source>
        <translation>letzte 5 s, mN</translation>
    </message>
    <message>
        <source>Insertion force over travel</source>
        <translation>Insertionskraft über Vorschub</translation>
    </message>
    <message>
        <source>insertion force, mN</source>
        <translation>Insertionskraft, mN</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ForceLabel</name>
    <message>
        <source>Perception threshold: median of ten otologic surgeons, %1 mN (Kratchman et al. 2016, Audiol Neurotol 21:244).</source>
        <translation>Wahrnehmungsschwelle: Median von zehn Ohrchirurgen, %1 mN (Kratchman et al. 2016, Audiol Neurotol 21:244).</translation>
    </message>
    <message>
        <source>The partition force is the largest force normal to the cochlear partition, bone and membrane, within one width of the array: that at which the partition ruptures in the simulation. Rupture was measured under a point load. No force is known to be safe: trauma may occur below these forces (Mirsalehi et al. 2017).</source>
        <translation>Die Trennwandkraft ist die größte Kraft senkrecht auf die cochleäre Trennwand, Knochen und Membran, innerhalb einer Trägerbreite: die, bei der die Trennwand in der Simulation rupturiert. Die Ruptur wurde unter Punktlast gemessen. Keine Kraft gilt als sicher: Trauma kann auch unter diesen Kräften auftreten (Mirsalehi et al. 2017).</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ForceSound</name>
    <message>
        <source>no audio device</source>
        <translation>kein Audiogerät</translation>
    </message>
    <message>
        <source>audio device does not support 16 bit at 44.1 kHz</source>
        <translation>Audiogerät unterstützt 16 Bit bei 44,1 kHz nicht</translation>
    </message>
    <message>
        <source>built without audio support</source>
        <translation>ohne Audiounterstützung gebaut</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::FoundContacts</name>
    <message>
        <source>Contacts found in the CT</source>
        <translation>Im CT gefundene Kontakte</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>From the round window, with its 95 % interval</source>
        <translation>Ab dem runden Fenster, mit 95-%-Intervall</translation>
    </message>
    <message>
        <source>To modiolus</source>
        <translation>Zum Modiolus</translation>
    </message>
    <message>
        <source>From the contact’s center to the inner wall, toward the modiolar axis</source>
        <translation>Von der Mitte des Kontakts zur inneren Wand, zur Modiolusachse hin</translation>
    </message>
    <message>
        <source>In scala tympani</source>
        <translation>In Scala tympani</translation>
    </message>
    <message>
        <source>Probability that the contact lies below the basilar membrane, with the errors of the CT and of the ear. The membrane is not visible in a CT: no diagnosis.</source>
        <translation>Wahrscheinlichkeit, dass der Kontakt unter der Basilarmembran liegt, mit den Fehlern von CT und Ohr. Die Membran ist im CT nicht zu sehen: keine Diagnose.</translation>
    </message>
    <message>
        <source>Greenwood</source>
        <translation>Greenwood</translation>
    </message>
    <message>
        <source>Estimated frequency of the place along the organ of Corti (Greenwood 1990), with its 95 % interval</source>
        <translation>Geschätzte Frequenz des Orts am Corti-Organ (Greenwood 1990), mit 95-%-Intervall</translation>
    </message>
    <message>
        <source>Spiral ganglion</source>
        <translation>Spiralganglion</translation>
    </message>
    <message>
        <source>Estimated frequency of the spiral ganglion at the angle (Stakhovskaya et al. 2007), with its 95 % interval</source>
        <translation>Geschätzte Frequenz des Spiralganglions am Winkel (Stakhovskaya et al. 2007), mit 95-%-Intervall</translation>
    </message>
    <message>
        <source>Default filter</source>
        <translation>Standard-Filter</translation>
    </message>
    <message>
        <source>Center of the filter that the contact gets by default; – if no allocation is known</source>
        <translation>Mitte des Filters, den der Kontakt standardmäßig erhält; – wenn keine Zuordnung bekannt ist</translation>
    </message>
    <message>
        <source>Mismatch</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Placed</source>
        <translation>Gesetzt</translation>
    </message>
    <message>
        <source>singly: its own brightness was seen; by spacing: the contacts merge in this CT, and the array’s spacings place it; by hand: a person placed it</source>
        <translation>einzeln: seine eigene Helligkeit war zu sehen; nach Abstand: die Kontakte verschmelzen in diesem CT, die Abstände des Trägers setzen ihn; von Hand: eine Person hat ihn gesetzt</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 st</source>
        <translation>%1 HT</translation>
    </message>
    <message>
        <source>Position known to %1 mm</source>
        <translation>Position auf %1 mm bekannt</translation>
    </message>
    <message>
        <source>Number of the contact, 1 at the tip; in brackets that in its maker’s fitting software</source>
        <translation>Nummer des Kontakts, 1 an der Spitze; in Klammern die in der Anpasssoftware des Herstellers</translation>
    </message>
    <message>
        <source>Frequency of its place on the spiral ganglion above its default filter, in semitones, with its 95 % interval; positive: it hears a lower frequency than its place</source>
        <translation>Frequenz seines Orts auf dem Spiralganglion über seinem Standardfilter, in Halbtönen, mit 95-%-Intervall; positiv: Er hört eine tiefere Frequenz als sein Ort</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::GroupsTable</name>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Mean ± SD</source>
        <translation>Mittelwert ± SD</translation>
    </message>
    <message>
        <source>%1, n = %2</source>
        <translation>%1, n = %2</translation>
    </message>
    <message>
        <source>Difference of the means with its 95 % interval (Welch). Without an interval where a group has fewer than two insertions, or where none of them differ.</source>
        <translation>Differenz der Mittelwerte mit 95-%-Intervall (Welch). Ohne Intervall, wo eine Gruppe weniger als zwei Insertionen hat oder keine sich unterscheiden.</translation>
    </message>
    <message>
        <source>insertion force at %1</source>
        <translation>Insertionskraft bei %1</translation>
    </message>
    <message>
        <source>mN</source>
        <translation>mN</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (own value)</source>
        <translation>%1 (eigener Wert)</translation>
    </message>
    <message>
        <source>%1 − %2, 95 %</source>
        <translation>%1 − %2, 95 %</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::GuideOverlay</name>
    <message>
        <source>User guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>The user guide is not installed. It is in the folder resources/guide of the source.</source>
        <translation>Das Handbuch ist nicht installiert. Es liegt im Ordner resources/guide der Quellen.</translation>
    </message>
    <message>
        <source>Found in the user guide</source>
        <translation>Fundstellen im Handbuch</translation>
    </message>
    <message>
        <source>Search the guide (Ctrl+F)</source>
        <translation>Im Handbuch suchen (Strg+F)</translation>
    </message>
    <message>
        <source>Words to search in the user guide</source>
        <translation>Suchwörter für das Handbuch</translation>
    </message>
    <message>
        <source>No page has &quot;%1&quot;. Try one word, such as &quot;depth&quot; or &quot;device&quot;.</source>
        <translation>Keine Seite enthält „%1“. Versuchen Sie ein Wort wie „Tiefe“ oder „Gerät“.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::InputSection</name>
    <message>
        <source>Input</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Scripted insertion</source>
        <translation>Automatische Insertion</translation>
    </message>
    <message>
        <source>Mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>Haptic device…</source>
        <translation>Haptisches Gerät …</translation>
    </message>
    <message>
        <source>Hold the array (Space)</source>
        <translation>Träger halten (Leertaste)</translation>
    </message>
    <message>
        <source>Withdraw stylet (S)</source>
        <translation>Stilett zurückziehen (S)</translation>
    </message>
    <message>
        <source>Force feedback gain</source>
        <translation>Kraftfaktor</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>Ratio of the rendered to the physical force. Without a haptic device there is no force feedback.</source>
        <translation>Verhältnis der dargestellten zur physikalischen Kraft. Ohne haptisches Gerät gibt es keine Kraftrückkopplung.</translation>
    </message>
    <message>
        <source>Inserts and withdraws at constant speed.</source>
        <translation>Führt mit konstanter Geschwindigkeit ein und zurück.</translation>
    </message>
    <message>
        <source>The mouse wheel or the ↑ and ↓ keys move the array while it is held.</source>
        <translation>Mausrad oder die Tasten ↑ und ↓ bewegen den Träger, solange er gehalten wird.</translation>
    </message>
    <message>
        <source>force feedback gain %1 ×</source>
        <translation>Kraftfaktor %1 ×</translation>
    </message>
    <message>
        <source>The array moves only while this button or Space is held.</source>
        <translation>Der Träger bewegt sich nur, solange diese Schaltfläche oder die Leertaste gehalten wird.</translation>
    </message>
    <message>
        <source>Stylet</source>
        <translation>Stilett</translation>
    </message>
    <message>
        <source>Force feedback gain %1. Enter a valid value or press Esc.</source>
        <translation>Kraftfaktor %1. Gültigen Wert eingeben oder Esc drücken.</translation>
    </message>
    <message>
        <source>Array held</source>
        <translation>Träger gehalten</translation>
    </message>
    <message>
        <source>Uses the device chosen last; shows the list if it is not there (list: H).</source>
        <translation>Verwendet das zuletzt gewählte Gerät; zeigt die Liste, wenn es nicht da ist (Liste: H).</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::InsertPage</name>
    <message>
        <source>Insert</source>
        <translation>Insertion</translation>
    </message>
    <message>
        <source>Keep inserting</source>
        <translation>Weiter inserieren</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::InsertionController</name>
    <message>
        <source>The chosen device is not open, so that Start would insert by the script. Press Reset to open the device again, or choose the script as the input.</source>
        <translation>Das gewählte Gerät ist nicht geöffnet; „Start“ würde automatisch inserieren. „Zurücksetzen“ drücken, um das Gerät erneut zu öffnen, oder die automatische Insertion als Eingabe wählen.</translation>
    </message>
    <message>
        <source>%1 is being opened.</source>
        <translation>%1 wird geöffnet.</translation>
    </message>
    <message>
        <source>%1 has not answered for %2 s. Check its power and its cable, or cancel.</source>
        <translation>%1 antwortet seit %2 s nicht. Prüfen Sie Stromversorgung und Kabel, oder brechen Sie ab.</translation>
    </message>
    <message>
        <source>The device was not opened. The input is the scripted insertion.</source>
        <translation>Das Gerät wurde nicht geöffnet. Die Eingabe ist die automatische Insertion.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::InsertionViews</name>
    <message>
        <source>not supported by this display</source>
        <translation>von dieser Anzeige nicht unterstützt</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::KeyList</name>
    <message>
        <source>Insertion</source>
        <translation>Insertion</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>Five tutorials and a search (Shift+F1)</source>
        <translation>Fünf Anleitungen und eine Suche (Umschalt+F1)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::KioskScreen</name>
    <message>
        <source>Touch anywhere to try it yourself</source>
        <translation>Berühren und selbst versuchen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Simulation for research and training. Not a medical device.</source>
        <translation>Simulation für Forschung und Training. Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Stop: remove the force of the device</source>
        <translation>Stopp: Kraft des Geräts abschalten</translation>
    </message>
    <message>
        <source>Hold to
withdraw</source>
        <translation>Halten:
zurück</translation>
    </message>
    <message>
        <source>Start
over</source>
        <translation>Von
vorn</translation>
    </message>
    <message>
        <source>Use the
screen</source>
        <translation>Bildschirm
verwenden</translation>
    </message>
    <message>
        <source>Use the
haptic device</source>
        <translation>Haptisches Gerät
verwenden</translation>
    </message>
    <message>
        <source>Scan to keep your force curve</source>
        <translation>Scannen: Ihre Kraftkurve</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::KioskWindow</name>
    <message>
        <source>Your turn</source>
        <translation>Sie sind dran</translation>
    </message>
    <message>
        <source>Perilymph</source>
        <translation>Perilymph</translation>
    </message>
    <message>
        <source>Not available now</source>
        <translation>Zurzeit nicht verfügbar</translation>
    </message>
    <message>
        <source>Please ask the booth staff.</source>
        <translation>Bitte fragen Sie das Standpersonal.</translation>
    </message>
    <message>
        <source>The insertion was stopped</source>
        <translation>Die Insertion wurde angehalten</translation>
    </message>
    <message>
        <source>The simulation became unstable and was stopped. The force is off. Try again.</source>
        <translation>Die Simulation wurde instabil und wurde angehalten. Die Kraft ist aus. Bitte erneut versuchen.</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>The force is off. Touch the screen to continue.</source>
        <translation>Die Kraft ist aus. Zum Fortfahren den Bildschirm berühren.</translation>
    </message>
    <message>
        <source>The array is stuck</source>
        <translation>Der Träger steckt fest</translation>
    </message>
    <message>
        <source>A cochlear implant lets deaf people hear. A surgeon slides its array of electrodes into the inner ear by hand.</source>
        <translation>Ein Cochlea-Implantat lässt Gehörlose hören. Sein Elektrodenträger wird von Hand ins Innenohr geschoben.</translation>
    </message>
    <message>
        <source>The wall glows where the array presses on it. A gentle hand protects the hearing that is left.</source>
        <translation>Die Wand leuchtet, wo der Träger auf sie drückt. Eine sanfte Hand schont das Gehör, das noch da ist.</translation>
    </message>
    <message>
        <source>The inner ear is as small as a pea, and its opening measures one to two millimeters.</source>
        <translation>Die Hörschnecke ist so klein wie eine Erbse, ihre Öffnung misst ein bis zwei Millimeter.</translation>
    </message>
    <message>
        <source>Hold the device button and advance. Stay gentle until the goal.</source>
        <translation>Gerätetaste halten und vorschieben. Bis zum Ziel sanft bleiben.</translation>
    </message>
    <message>
        <source>Hold the bar to insert; further right is faster. Stay gentle until the goal.</source>
        <translation>Leiste halten zum Einführen; weiter rechts ist schneller. Bis zum Ziel sanft bleiben.</translation>
    </message>
    <message>
        <source>It bent or jammed before the goal. The force is off. Try again, slower.</source>
        <translation>Er hat sich vor dem Ziel verbogen oder verklemmt. Die Kraft ist aus. Bitte langsamer noch einmal.</translation>
    </message>
    <message>
        <source>Cochlear implant: %1</source>
        <translation>Cochlea-Implantat: %1</translation>
    </message>
    <message>
        <source>Full depth reached</source>
        <translation>Volle Tiefe erreicht</translation>
    </message>
    <message>
        <source>Goal reached</source>
        <translation>Ziel erreicht</translation>
    </message>
    <message>
        <source>rank %1 of %2 today</source>
        <translation>heute Rang %1 von %2</translation>
    </message>
    <message>
        <source>Peak force %1 mN in %2 s, no reversals.</source>
        <translation>Maximalkraft %1 mN in %2 s, keine Rückzüge.</translation>
    </message>
    <message>
        <source>Peak force %1 mN in %2 s, reversals: %3.</source>
        <translation>Maximalkraft %1 mN in %2 s, Rückzüge: %3.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::LandmarkDrawing</name>
    <message>
        <source>Landmarks of A, B and H</source>
        <translation>Landmarken von A, B und H</translation>
    </message>
    <message>
        <source>Cochlear view</source>
        <translation>Cochleaansicht</translation>
    </message>
    <message>
        <source>Perpendicular view</source>
        <translation>Senkrechte Ansicht</translation>
    </message>
    <message>
        <source>round window</source>
        <translation>rundes Fenster</translation>
    </message>
    <message>
        <source>modiolus</source>
        <translation>Modiolus</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::LevelGauge</name>
    <message>
        <source>now %1 mN</source>
        <translation>jetzt %1 mN</translation>
    </message>
    <message>
        <source>peak %1 mN</source>
        <translation>Max. %1 mN</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::LoadingStage</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Keep the cochlea and array of before (Esc)</source>
        <translation>Cochlea und Elektrodenträger von vorher behalten (Esc)</translation>
    </message>
    <message>
        <source>Building the cochlea: %1</source>
        <translation>Die Cochlea wird aufgebaut: %1</translation>
    </message>
    <message>
        <source>The scripted insertion remains the input (Esc)</source>
        <translation>Die automatische Insertion bleibt die Eingabe (Esc)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::MainMenu</name>
    <message>
        <source>Open recording…</source>
        <translation>Aufzeichnung öffnen …</translation>
    </message>
    <message>
        <source>Export recordings…</source>
        <translation>Aufzeichnungen exportieren …</translation>
    </message>
    <message>
        <source>Save screenshot</source>
        <translation>Bildschirmfoto speichern</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Strg+Umschalt+S</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Strg+,</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tastatur und Maus</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Shift+F1</source>
        <translation>Umschalt+F1</translation>
    </message>
    <message>
        <source>About Perilymph</source>
        <translation>Über Perilymph</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Strg+Q</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Recordings (*.insertion)</source>
        <translation>Aufzeichnungen (*.insertion)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::MainWindow</name>
    <message>
        <source>Show recordings</source>
        <translation>Aufzeichnungen zeigen</translation>
    </message>
    <message>
        <source>The program closed unexpectedly. Your last insertion (depth %1 mm) was recovered: %2.</source>
        <translation>Das Programm wurde unerwartet beendet. Ihre letzte Insertion (Tiefe %1 mm) wurde wiederhergestellt: %2.</translation>
    </message>
    <message>
        <source>End it and continue</source>
        <translation>Beenden und fortfahren</translation>
    </message>
    <message>
        <source>End it and replay</source>
        <translation>Beenden und wiedergeben</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>Trotzdem schließen</translation>
    </message>
    <message>
        <source>Change it anyway</source>
        <translation>Trotzdem ändern</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::MarkupBar</name>
    <message>
        <source>Key image</source>
        <translation>Schlüsselbild</translation>
    </message>
    <message>
        <source>Click two points in any plane (D). Esc ends.</source>
        <translation>Zwei Punkte in beliebigen Ebenen anklicken (D). Esc beendet.</translation>
    </message>
    <message>
        <source>Click a side, the vertex and the other side in any plane (A). Esc ends.</source>
        <translation>Einen Schenkel, den Scheitel und den anderen Schenkel in beliebigen Ebenen anklicken (A). Esc beendet.</translation>
    </message>
    <message>
        <source>Click a point and type the note (N). Esc ends.</source>
        <translation>Einen Punkt anklicken und die Notiz eingeben (N). Esc beendet.</translation>
    </message>
    <message>
        <source>Markups (%1)</source>
        <translation>Markierungen (%1)</translation>
    </message>
    <message>
        <source>In the report (%1)</source>
        <translation>Im Bericht (%1)</translation>
    </message>
    <message>
        <source>Remove the chosen one (Del)</source>
        <translation>Gewählte entfernen (Entf)</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Rückgängig (Strg+Z)</translation>
    </message>
    <message>
        <source>Export for 3D Slicer (LPS)…</source>
        <translation>Für 3D Slicer exportieren (LPS) …</translation>
    </message>
    <message>
        <source>Export as a table (CSV, LPS)…</source>
        <translation>Als Tabelle exportieren (CSV, LPS) …</translation>
    </message>
    <message>
        <source>Load from 3D Slicer…</source>
        <translation>Aus 3D Slicer laden …</translation>
    </message>
    <message>
        <source>Remove from the report</source>
        <translation>Aus dem Bericht entfernen</translation>
    </message>
    <message>
        <source>Keep the picture that was clicked last with its markups for the reports (K: the one under the mouse)</source>
        <translation>Das zuletzt angeklickte Bild mit seinen Markierungen für die Berichte behalten (K: das unter der Maus)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::MeasureVersionList</name>
    <message>
        <source>Measures of this ear, the newest first</source>
        <translation>Messwerte dieses Ohrs, die neuesten zuerst</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>%1, mm</source>
        <translation>%1, mm</translation>
    </message>
    <message>
        <source>in use: %1</source>
        <translation>gilt: %1</translation>
    </message>
    <message>
        <source>In use: %1 mm. %2</source>
        <translation>Geltende: %1 mm. %2</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::Navigation</name>
    <message>
        <source>OpenIGTLink is off: no program can connect.</source>
        <translation>OpenIGTLink ist aus: Kein Programm kann sich verbinden.</translation>
    </message>
    <message>
        <source>OpenIGTLink on %1, no client</source>
        <translation>OpenIGTLink auf %1, kein Client</translation>
    </message>
    <message>
        <source>OpenIGTLink on %1, 1 client</source>
        <translation>OpenIGTLink auf %1, 1 Client</translation>
    </message>
    <message>
        <source>OpenIGTLink on %1, %2 clients</source>
        <translation>OpenIGTLink auf %1, %2 Clients</translation>
    </message>
    <message>
        <source>Whoever reaches it in the network receives the insertion and the CT, without a password.</source>
        <translation>Wer diese Adresse im Netz erreicht, erhält Insertion und CT, ohne Kennwort.</translation>
    </message>
    <message>
        <source>Nothing is sent: the coordinates of the patient are known while the CT of this cochlea is open.</source>
        <translation>Es wird nichts gesendet: Die Koordinaten des Patienten sind bekannt, solange das CT dieser Cochlea geöffnet ist.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::NavigationSection</name>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on, also for other computers</source>
        <translation>ein, auch für andere Computer</translation>
    </message>
    <message>
        <source>on, for programs on this computer</source>
        <translation>ein, für Programme auf diesem Computer</translation>
    </message>
    <message>
        <source>Stream to 3D Slicer (OpenIGTLink)</source>
        <translation>An 3D Slicer übertragen (OpenIGTLink)</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>The port must be a number from %1 to %2.</source>
        <translation>Der Port muss eine Zahl von %1 bis %2 sein.</translation>
    </message>
    <message>
        <source>coordinates of the cochlea</source>
        <translation>Koordinaten der Cochlea</translation>
    </message>
    <message>
        <source>coordinates of the patient (RAS), with the CT open</source>
        <translation>Koordinaten des Patienten (RAS), bei geöffnetem CT</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::NewStudy</name>
    <message>
        <source>Arrays</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>Cochleae</source>
        <translation>Cochleae</translation>
    </message>
    <message>
        <source>Hand and friction</source>
        <translation>Hand und Reibung</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>Neue Studie</translation>
    </message>
    <message>
        <source>%1 insertions, about %2 on %3 of %4 cores: an estimate from %5 that were run now.</source>
        <translation>%1 Insertionen, etwa %2 auf %3 von %4 Kernen: eine Schätzung aus %5, die eben gerechnet wurden.</translation>
    </message>
    <message>
        <source>Simulated, from the population</source>
        <translation>Simuliert, aus der Population</translation>
    </message>
    <message>
        <source>Drawn by the seed from the mean, the spread and the correlation of A and B</source>
        <translation>Mit dem Startwert aus Mittelwert, Streuung und Korrelation von A und B gezogen</translation>
    </message>
    <message>
        <source>Average cochlea</source>
        <translation>Mittlere Cochlea</translation>
    </message>
    <message>
        <source>%1, from</source>
        <translation>%1, von</translation>
    </message>
    <message>
        <source>%1, to</source>
        <translation>%1, bis</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Speed, mm/s</source>
        <translation>Geschwindigkeit, mm/s</translation>
    </message>
    <message>
        <source>By hand, 0.66 ± 0.31 mm/s in cadaver heads (Kesler et al. 2017)</source>
        <translation>Von Hand, 0,66 ± 0,31 mm/s in Präparaten (Kesler et al. 2017)</translation>
    </message>
    <message>
        <source>Force limit, mN</source>
        <translation>Kraftgrenze, mN</translation>
    </message>
    <message>
        <source>The surgeon stops there: highest peak in vivo (Rau et al. 2024); 0: never</source>
        <translation>Dort hält der Operateur an: höchste Kraft in vivo (Rau et al. 2024); 0: nie</translation>
    </message>
    <message>
        <source>Approach angle, tilt, °</source>
        <translation>Zugangswinkel, Neigung, °</translation>
    </message>
    <message>
        <source>From the axis of the opening</source>
        <translation>Gegen die Achse der Öffnung</translation>
    </message>
    <message>
        <source>Approach angle, rotation, °</source>
        <translation>Zugangswinkel, Drehung, °</translation>
    </message>
    <message>
        <source>Samples in each cochlea</source>
        <translation>Stichproben je Cochlea</translation>
    </message>
    <message>
        <source>Of values that go from one limit to another: a Latin hypercube</source>
        <translation>Für Werte, die von einer Grenze zur anderen gehen: ein lateinischer Hyperwürfel</translation>
    </message>
    <message>
        <source>FRICTION</source>
        <translation>REIBUNG</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Study of %1</source>
        <translation>Studie vom %1</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Everything that is drawn depends on it; the same seed gives the same study</source>
        <translation>Alles Gezogene hängt davon ab; derselbe Startwert gibt dieselbe Studie</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Coarse and fast</source>
        <translation>Grob und schnell</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Üblich</translation>
    </message>
    <message>
        <source>Fine and slow</source>
        <translation>Fein und langsam</translation>
    </message>
    <message>
        <source>%1: %2 nodes, %3 ms</source>
        <translation>%1: %2 Knoten, %3 ms</translation>
    </message>
    <message>
        <source>Cores</source>
        <translation>Kerne</translation>
    </message>
    <message>
        <source>1 core</source>
        <translation>1 Kern</translation>
    </message>
    <message>
        <source>%1 cores</source>
        <translation>%1 Kerne</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>PATIENTS</source>
        <translation>PATIENTEN</translation>
    </message>
    <message>
        <source>No saved patient has A and B.</source>
        <translation>Kein gespeicherter Patient hat A und B.</translation>
    </message>
    <message>
        <source>SHIPPED EXAMPLES</source>
        <translation>MITGELIEFERTE BEISPIELE</translation>
    </message>
    <message>
        <source>Estimating the time…</source>
        <translation>Die Dauer wird geschätzt …</translation>
    </message>
    <message>
        <source>%1 is “%2”; a whole number from %3 to 1,000,000 is needed.</source>
        <translation>%1 ist „%2“; nötig ist eine ganze Zahl von %3 bis 1.000.000.</translation>
    </message>
    <message>
        <source>%1: “%2” is no number. Enter one.</source>
        <translation>%1: „%2“ ist keine Zahl. Geben Sie eine ein.</translation>
    </message>
    <message>
        <source>%1 is %2, above the other limit, %3. Exchange them.</source>
        <translation>%1 ist %2, über der anderen Grenze, %3. Tauschen Sie beide.</translation>
    </message>
    <message>
        <source>The study has no title. Enter one.</source>
        <translation>Die Studie hat keinen Titel. Geben Sie einen ein.</translation>
    </message>
    <message>
        <source>No array is chosen. Choose one or more.</source>
        <translation>Kein Träger ist gewählt. Wählen Sie einen oder mehrere.</translation>
    </message>
    <message>
        <source>No friction is chosen. Choose one or more.</source>
        <translation>Keine Reibung ist gewählt. Wählen Sie eine oder mehrere.</translation>
    </message>
    <message>
        <source>There is no cochlea. Enter a number of simulated ones, or choose another.</source>
        <translation>Es gibt keine Cochlea. Geben Sie eine Anzahl simulierter ein oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>A study is running.</source>
        <translation>Eine Studie läuft.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::Notice</name>
    <message>
        <source>Dismiss</source>
        <translation>Verbergen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::NumberField</name>
    <message>
        <source>must be %1 to %2 %3</source>
        <translation>muss %1 bis %2 %3 sein</translation>
    </message>
    <message>
        <source>%1–%2 %3. %4</source>
        <translation>%1–%2 %3. %4</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::OperationView</name>
    <message>
        <source>Surgeon’s view</source>
        <translation>Sicht des Operateurs</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Following the tip</source>
        <translation>Der Spitze nach</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>mN</source>
        <translation>mN</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>Microscope × %1</source>
        <translation>Mikroskop × %1</translation>
    </message>
    <message>
        <source>anaglyph</source>
        <translation>Anaglyphe</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>nebeneinander</translation>
    </message>
    <message>
        <source>interlaced</source>
        <translation>zeilenweise</translation>
    </message>
    <message>
        <source>quad-buffered</source>
        <translation>vierfach gepuffert</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>insertion force</source>
        <translation>Insertionskraft</translation>
    </message>
    <message>
        <source>advanced · insertion depth %1 mm</source>
        <translation>vorgeschoben · Insertionstiefe %1 mm</translation>
    </message>
    <message>
        <source>Through the opening</source>
        <translation>Durch die Öffnung</translation>
    </message>
    <message>
        <source>Basal-turn section</source>
        <translation>Schnitt der Basalwindung</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>Tiefe %1 mm</translation>
    </message>
    <message>
        <source>angular depth</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>angular insertion depth · tip %1°</source>
        <translation>Insertionswinkel · Spitze %1°</translation>
    </message>
    <message>
        <source>angular insertion depth</source>
        <translation>Insertionswinkel</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::OutcomePage</name>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Plan and outcome</source>
        <translation>Plan und Ergebnis</translation>
    </message>
    <message>
        <source>Choose a patient and open the CT after surgery, or drop it here. The contacts of the array are found, measured and shown beside the plan.</source>
        <translation>Wählen Sie einen Patienten und öffnen Sie das CT nach der Operation, oder legen Sie es hier ab. Die Kontakte des Trägers werden gefunden, gemessen und neben dem Plan gezeigt.</translation>
    </message>
    <message>
        <source>Open folder…</source>
        <translation>Ordner öffnen …</translation>
    </message>
    <message>
        <source>From the archive…</source>
        <translation>Aus dem Archiv …</translation>
    </message>
    <message>
        <source>The outcome of %1 is not saved in the record.</source>
        <translation>Das Ergebnis von %1 ist nicht in der Akte gespeichert.</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>The CT of this outcome is no longer where it was read.</source>
        <translation>Das CT dieses Ergebnisses ist nicht mehr, wo es gelesen wurde.</translation>
    </message>
    <message>
        <source>Reading the CT…</source>
        <translation>Das CT wird gelesen …</translation>
    </message>
    <message>
        <source>This CT was not joined to %1.</source>
        <translation>Dieses CT wurde %1 nicht zugeordnet.</translation>
    </message>
    <message>
        <source>Finding the contacts…</source>
        <translation>Die Kontakte werden gesucht …</translation>
    </message>
    <message>
        <source>Saved outcome. Its CT is no longer where it was read.</source>
        <translation>Gespeichertes Ergebnis. Sein CT ist nicht mehr, wo es gelesen wurde.</translation>
    </message>
    <message>
        <source>Saved in the record of %1, version %2.</source>
        <translation>In der Akte von %1 gespeichert, Version %2.</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Markups (*.mrk.json)</source>
        <translation>Markierungen (*.mrk.json)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Save the outcome</source>
        <translation>Ergebnis speichern</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Gespeichert in %1.</translation>
    </message>
    <message>
        <source>Report of the outcome</source>
        <translation>Bericht des Ergebnisses</translation>
    </message>
    <message>
        <source>Choose the implanted array first.</source>
        <translation>Zuerst den implantierten Träger wählen.</translation>
    </message>
    <message>
        <source>Reading the CT before surgery…</source>
        <translation>Das CT vor der Operation wird gelesen …</translation>
    </message>
    <message>
        <source>Measuring the ear in the CT before surgery…</source>
        <translation>Das Ohr wird im CT vor der Operation gemessen …</translation>
    </message>
    <message>
        <source>Carrying the ear over from the CT before surgery…</source>
        <translation>Das Ohr wird aus dem CT vor der Operation übertragen …</translation>
    </message>
    <message>
        <source>Measuring the ear in this CT…</source>
        <translation>Das Ohr wird in diesem CT gemessen …</translation>
    </message>
    <message>
        <source>What the surgeon knows of %1 is not saved in the record.</source>
        <translation>Was aus der Operation von %1 bekannt ist, ist nicht in der Akte gespeichert.</translation>
    </message>
    <message>
        <source>Open without saving</source>
        <translation>Ohne Speichern öffnen</translation>
    </message>
    <message>
        <source>Change without saving</source>
        <translation>Ohne Speichern wechseln</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::OutcomePanel</name>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Saved outcomes</source>
        <translation>Gespeicherte Ergebnisse</translation>
    </message>
    <message>
        <source>Find the contacts</source>
        <translation>Kontakte suchen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Save in the record</source>
        <translation>In der Akte speichern</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export …</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>PATIENT</source>
        <translation>PATIENT</translation>
    </message>
    <message>
        <source>1  WHAT THE SURGEON KNOWS</source>
        <translation>1  WAS AUS DER OPERATION BEKANNT IST</translation>
    </message>
    <message>
        <source>2  CT AFTER SURGERY</source>
        <translation>2  CT NACH DER OPERATION</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>The contact that was moved last (Ctrl+Z)</source>
        <translation>Der zuletzt bewegte Kontakt (Strg+Z)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Strg+Umschalt+Z</translation>
    </message>
    <message>
        <source>Every outcome that is saved stays in the patient’s record, with its date.</source>
        <translation>Jedes gespeicherte Ergebnis bleibt mit seinem Datum in der Akte.</translation>
    </message>
    <message>
        <source>One page as PDF or DICOM</source>
        <translation>Eine Seite als PDF oder DICOM</translation>
    </message>
    <message>
        <source>Table of the contacts (CSV)…</source>
        <translation>Tabelle der Kontakte (CSV) …</translation>
    </message>
    <message>
        <source>Everything (JSON)…</source>
        <translation>Alles (JSON) …</translation>
    </message>
    <message>
        <source>Markups for 3D Slicer…</source>
        <translation>Markierungen für 3D Slicer …</translation>
    </message>
    <message>
        <source>Picture of the cochlear view…</source>
        <translation>Bild der Cochlea-Ansicht …</translation>
    </message>
    <message>
        <source>Save a patient first</source>
        <translation>Zuerst einen Patienten speichern</translation>
    </message>
    <message>
        <source>Choose a patient</source>
        <translation>Patient wählen</translation>
    </message>
    <message>
        <source>no outcome saved yet</source>
        <translation>noch kein Ergebnis</translation>
    </message>
    <message>
        <source>1 saved outcome</source>
        <translation>1 Ergebnis gespeichert</translation>
    </message>
    <message>
        <source>%1 saved outcomes</source>
        <translation>%1 Ergebnisse gespeichert</translation>
    </message>
    <message>
        <source>Choose a patient with A and B first.</source>
        <translation>Zuerst einen Patienten mit A und B wählen.</translation>
    </message>
    <message>
        <source>Open the CT after surgery first.</source>
        <translation>Zuerst das CT nach der Operation öffnen.</translation>
    </message>
    <message>
        <source>Correct the form first.</source>
        <translation>Zuerst das Formular berichtigen.</translation>
    </message>
    <message>
        <source>Choose the implanted array first.</source>
        <translation>Zuerst den implantierten Träger wählen.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Saves this earlier version as the newest, which counts among the outcomes.</source>
        <translation>Speichert diese frühere Fassung als neueste, die unter den Ergebnissen zählt.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::OutcomeView</name>
    <message>
        <source>Contacts in the CT</source>
        <translation>Kontakte im CT</translation>
    </message>
    <message>
        <source>Plan beside outcome</source>
        <translation>Plan neben Ergebnis</translation>
    </message>
    <message>
        <source>Unrolled scala tympani with the contacts and the plan’s bands</source>
        <translation>Abgerollte Scala tympani mit den Kontakten und den Bändern des Plans</translation>
    </message>
    <message>
        <source>Force over depth: insertion by hand, the plan’s band, the length inserted in the patient</source>
        <translation>Kraft über der Tiefe: Insertion von Hand, Band des Plans, im Patienten inserierte Länge</translation>
    </message>
    <message>
        <source>The CT after surgery</source>
        <translation>Das CT nach der Operation</translation>
    </message>
    <message>
        <source>%1: %2, contacts inside %3, inserted %4; %5.</source>
        <translation>%1: %2, Kontakte innen %3, inseriert %4; %5.</translation>
    </message>
    <message>
        <source>There is no plan of this array for this patient. The page Plan makes one.</source>
        <translation>Für diesen Patienten gibt es keinen Plan dieses Trägers. Die Seite Plan macht einen.</translation>
    </message>
    <message>
        <source>Plan of %1, %2 simulations; bands: %3</source>
        <translation>Plan vom %1, %2 Simulationen; Bänder: %3</translation>
    </message>
    <message>
        <source>Contacts by number, with the intervals of their angles; hollow: placed by spacing; diamond: more likely above the basilar membrane. Bars at the modiolus: the plan’s bands; across the scala: that of the most apical contact.</source>
        <translation>Kontakte mit Nummer und dem Intervall ihres Winkels; hohl: nach Abstand gesetzt; Raute: eher über der Basilarmembran. Balken am Modiolus: die Bänder des Plans; quer über die Scala: das des apikalsten Kontakts.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::OutcomesPage</name>
    <message>
        <source>%1 (%2–%3)%4</source>
        <translation>%1 (%2–%3)%4</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 of %2: %3 % (%4–%5)</source>
        <translation>%1 von %2: %3 % (%4–%5)</translation>
    </message>
    <message>
        <source>Outcomes</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Outcomes of all patients</source>
        <translation>Ergebnisse aller Patienten</translation>
    </message>
    <message>
        <source>Outcomes that are saved on the page Outcome stand here beside their plans: how often the bands held, and where in them each ear came.</source>
        <translation>Ergebnisse, die auf der Seite Ergebnis gespeichert sind, stehen hier neben ihren Plänen: wie oft die Bänder hielten, und wo in ihnen jedes Ohr lag.</translation>
    </message>
    <message>
        <source>Outcomes, a row an ear</source>
        <translation>Ergebnisse, eine Zeile je Ohr</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Code and ear; the newest outcome of each</source>
        <translation>Code und Ohr; jeweils das neueste Ergebnis</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>The implanted array</source>
        <translation>Der implantierte Träger</translation>
    </message>
    <message>
        <source>Depth, plan</source>
        <translation>Tiefe, Plan</translation>
    </message>
    <message>
        <source>Depth, found</source>
        <translation>Tiefe, gefunden</translation>
    </message>
    <message>
        <source>Percentile</source>
        <translation>Perzentil</translation>
    </message>
    <message>
        <source>Share of the plan’s simulations below the depth found, with its error</source>
        <translation>Anteil der Simulationen des Plans unter der gefundenen Tiefe, mit ihrem Fehler</translation>
    </message>
    <message>
        <source>Angle, plan</source>
        <translation>Winkel, Plan</translation>
    </message>
    <message>
        <source>Angle, found</source>
        <translation>Winkel, gefunden</translation>
    </message>
    <message>
        <source>Of the most apical contact, with its 95 % interval</source>
        <translation>Der des apikalsten Kontakts, mit 95-%-Intervall</translation>
    </message>
    <message>
        <source>Share of the plan’s simulations below the angle found, with its error</source>
        <translation>Anteil der Simulationen des Plans unter dem gefundenen Winkel, mit seinem Fehler</translation>
    </message>
    <message>
        <source>Stopped because of</source>
        <translation>Beendet wegen</translation>
    </message>
    <message>
        <source>As the surgeon states it</source>
        <translation>Nach Angabe aus der Operation</translation>
    </message>
    <message>
        <source>How often the bands held, by array</source>
        <translation>Wie oft die Bänder hielten, je Träger</translation>
    </message>
    <message>
        <source>Ears inside the band, with the 95 % interval of Wilson</source>
        <translation>Ohren im Band, mit dem 95-%-Intervall nach Wilson</translation>
    </message>
    <message>
        <source>Depth in 50 %</source>
        <translation>Tiefe in 50 %</translation>
    </message>
    <message>
        <source>Depth in 90 %</source>
        <translation>Tiefe in 90 %</translation>
    </message>
    <message>
        <source>Angle in 50 %</source>
        <translation>Winkel in 50 %</translation>
    </message>
    <message>
        <source>Angle in 90 %</source>
        <translation>Winkel in 90 %</translation>
    </message>
    <message>
        <source>Predicted against measured depth</source>
        <translation>Vorhergesagte gegen gemessene Tiefe</translation>
    </message>
    <message>
        <source>Histogram of the percentiles</source>
        <translation>Histogramm der Perzentile</translation>
    </message>
    <message>
        <source>Each ear is compared with the plan as it was made before. Where the bands are right, half of the ears lie in that of 50 %, nine of ten in that of 90 %, and the percentiles are spread evenly.</source>
        <translation>Jedes Ohr wird mit dem Plan verglichen, wie er vorher gemacht wurde. Stimmen die Bänder, so liegt die Hälfte der Ohren in dem von 50 %, neun von zehn in dem von 90 %, und die Perzentile sind gleichmäßig verteilt.</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>Tabelle speichern …</translation>
    </message>
    <message>
        <source>CSV with a dictionary of its columns; neither codes nor dates finer than a year</source>
        <translation>CSV mit einem Verzeichnis seiner Spalten; weder Codes noch Daten genauer als ein Jahr</translation>
    </message>
    <message>
        <source>Comparing outcomes with their plans…</source>
        <translation>Ergebnisse werden mit ihren Plänen verglichen …</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Save the outcomes</source>
        <translation>Ergebnisse speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Gespeichert in %1.</translation>
    </message>
    <message>
        <source>Find an array in a CT</source>
        <translation>Elektrodenträger in einer CT finden</translation>
    </message>
    <message>
        <source>Median and band of the plan’s simulations, 5 to 95 %; of fewer than 19 the lowest and the highest</source>
        <translation>Median und Band der Simulationen des Plans, 5 bis 95 %; bei weniger als 19 die niedrigste und die höchste</translation>
    </message>
    <message>
        <source>Inserted length past the opening, with its 95 % interval</source>
        <translation>Inserierte Länge hinter der Öffnung, mit 95-%-Intervall</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PatientDetails</name>
    <message>
        <source>Another program changed the record of %1 meanwhile: its notes are kept before yours.</source>
        <translation>Ein anderes Programm hat die Akte von %1 inzwischen geändert: seine Notizen stehen vor den Ihren.</translation>
    </message>
    <message>
        <source> · measures changed by hand</source>
        <translation> · Maße von Hand geändert</translation>
    </message>
    <message>
        <source> · record changed by hand</source>
        <translation> · Akte von Hand geändert</translation>
    </message>
    <message>
        <source>Notes on this ear; no names</source>
        <translation>Notizen zu diesem Ohr; keine Namen</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Schlagwörter</translation>
    </message>
    <message>
        <source>Tags, separated by commas; no names</source>
        <translation>Schlagwörter, durch Kommas getrennt; keine Namen</translation>
    </message>
    <message>
        <source>Notes have at most %1 characters; the end of what was typed or pasted is not taken.</source>
        <translation>Notizen haben höchstens %1 Zeichen; das Ende des Eingegebenen ist nicht übernommen.</translation>
    </message>
    <message>
        <source>The tags of %1 are saved.</source>
        <translation>Die Schlagwörter von %1 sind gespeichert.</translation>
    </message>
    <message>
        <source>The notes on %1 are saved.</source>
        <translation>Die Notizen zu %1 sind gespeichert.</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen …</translation>
    </message>
    <message>
        <source>Choose a patient.</source>
        <translation>Einen Patienten wählen.</translation>
    </message>
    <message>
        <source>MEASURES</source>
        <translation>MESSWERTE</translation>
    </message>
    <message>
        <source>SCANS, PLANS, INSERTIONS, OUTCOMES</source>
        <translation>CT, PLÄNE, INSERTIONEN, ERGEBNISSE</translation>
    </message>
    <message>
        <source>None yet. Scans are measured on the page CT, plans made on the page Plan; insertions of this patient are recorded, and outcomes saved on the page Outcome.</source>
        <translation>Noch keine. CTs werden auf der Seite CT gemessen, Pläne auf der Seite Plan gemacht; Insertionen dieses Patienten werden aufgezeichnet und Ergebnisse auf der Seite Ergebnis gespeichert.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PatientForm</name>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>A, B and H</source>
        <translation>A, B und H</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>PATIENT</source>
        <translation>PATIENT</translation>
    </message>
    <message>
        <source>EAR</source>
        <translation>OHR</translation>
    </message>
    <message>
        <source>CDL and round-window section</source>
        <translation>CDL und Schnitt am runden Fenster</translation>
    </message>
    <message>
        <source>Build cochlea</source>
        <translation>Cochlea berechnen</translation>
    </message>
    <message>
        <source>Patient code (no names)</source>
        <translation>Patientencode (kein Name)</translation>
    </message>
    <message>
        <source>Patient measurements</source>
        <translation>Messwerte des Patienten</translation>
    </message>
    <message>
        <source>Cochlear duct length (organ of Corti)</source>
        <translation>Länge des Ductus cochlearis (Corti-Organ)</translation>
    </message>
    <message>
        <source>Scala width at round window</source>
        <translation>Skalenbreite am runden Fenster</translation>
    </message>
    <message>
        <source>Scala height at round window</source>
        <translation>Skalenhöhe am runden Fenster</translation>
    </message>
    <message>
        <source>A: basal-turn diameter</source>
        <translation>A: Durchmesser der Basalwindung</translation>
    </message>
    <message>
        <source>B: basal-turn width, perpendicular to A</source>
        <translation>B: Breite der Basalwindung, senkrecht zu A</translation>
    </message>
    <message>
        <source>Patient code</source>
        <translation>Patientencode</translation>
    </message>
    <message>
        <source>Letters, digits and hyphens, such as P-017. It appears in file names and reports.</source>
        <translation>Buchstaben, Ziffern und Bindestriche, etwa P-017. Der Code erscheint in Dateinamen und Berichten.</translation>
    </message>
    <message>
        <source>MEASUREMENTS</source>
        <translation>MESSWERTE</translation>
    </message>
    <message>
        <source>HOW TO MEASURE IN CT</source>
        <translation>MESSUNG IM CT</translation>
    </message>
    <message>
        <source>Cochlear view: the oblique plane through the basal turn, perpendicular to the modiolus (Xu et al. 2000; Escudé et al. 2006; coordinates as in Verbist et al. 2010).</source>
        <translation>Cochleaansicht: schräge Ebene durch die Basalwindung, senkrecht zum Modiolus (Xu et al. 2000; Escudé et al. 2006; Koordinaten nach Verbist et al. 2010).</translation>
    </message>
    <message>
        <source>COMPUTED FROM THE MEASUREMENTS</source>
        <translation>AUS DEN MESSWERTEN BERECHNET</translation>
    </message>
    <message>
        <source>H: cochlear height (optional)</source>
        <translation>H: Höhe der Cochlea (optional)</translation>
    </message>
    <message>
        <source>New patient</source>
        <translation>Neuer Patient</translation>
    </message>
    <message>
        <source>Save changes</source>
        <translation>Änderungen speichern</translation>
    </message>
    <message>
        <source>Measure a CT…</source>
        <translation>CT vermessen …</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PatientHistoryList</name>
    <message>
        <source>Scans, plans, insertions and outcomes</source>
        <translation>CTs, Pläne, Insertionen und Ergebnisse</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PatientPicker</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Importing: %1 %</source>
        <translation>Import: %1 %</translation>
    </message>
    <message>
        <source>Exporting %1: %2 %</source>
        <translation>Export von %1: %2 %</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Bearbeiten …</translation>
    </message>
    <message>
        <source>Saved patients</source>
        <translation>Gespeicherte Patienten</translation>
    </message>
    <message>
        <source>Find patients</source>
        <translation>Patienten suchen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>No patient is saved yet.</source>
        <translation>Noch kein Patient gespeichert.</translation>
    </message>
    <message>
        <source>No patient matches “%1”.</source>
        <translation>Kein Patient passt zu „%1“.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Show archived</source>
        <translation>Archivierte zeigen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren …</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivieren</translation>
    </message>
    <message>
        <source>%1 is archived; nothing is deleted.</source>
        <translation>%1 ist archiviert; nichts wird gelöscht.</translation>
    </message>
    <message>
        <source>%1 is in the list again.</source>
        <translation>%1 ist wieder in der Liste.</translation>
    </message>
    <message>
        <source>Folder for the export</source>
        <translation>Ordner für den Export</translation>
    </message>
    <message>
        <source>%1 is exported to %2.</source>
        <translation>%1 ist nach %2 exportiert.</translation>
    </message>
    <message>
        <source>Folder of an exported patient</source>
        <translation>Ordner eines exportierten Patienten</translation>
    </message>
    <message>
        <source>The patient is imported.</source>
        <translation>Der Patient ist importiert.</translation>
    </message>
    <message>
        <source>Find by code, ear, tag or note</source>
        <translation>Code, Ohr, Schlagwort oder Notiz suchen</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabelle …</translation>
    </message>
    <message>
        <source>Save all patients as CSV, a row per ear: measures, newest plan and newest insertion, with a dictionary of the columns. It names nobody.</source>
        <translation>Alle Patienten als CSV speichern, eine Zeile je Ohr: Messwerte, neuester Plan und neueste Insertion, mit einer Erklärung der Spalten. Niemand wird genannt.</translation>
    </message>
    <message>
        <source>Table of all patients</source>
        <translation>Tabelle aller Patienten</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Reading plans and replaying insertions: %1 %</source>
        <translation>Pläne werden gelesen und Insertionen wiedergegeben: %1 %</translation>
    </message>
    <message>
        <source>The table is in %1.</source>
        <translation>Die Tabelle ist in %1.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PatientSection</name>
    <message>
        <source>from CT</source>
        <translation>aus CT</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Ear</source>
        <translation>Ohr</translation>
    </message>
    <message>
        <source>Cochlea</source>
        <translation>Cochlea</translation>
    </message>
    <message>
        <source>right ear</source>
        <translation>rechtes Ohr</translation>
    </message>
    <message>
        <source>left ear</source>
        <translation>linkes Ohr</translation>
    </message>
    <message>
        <source>A, B and H</source>
        <translation>A, B und H</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>cochlea: %1</source>
        <translation>Cochlea: %1</translation>
    </message>
    <message>
        <source>patient %1</source>
        <translation>Patient %1</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>eingegeben</translation>
    </message>
    <message>
        <source>A left ear is the mirror image of a right ear; the forces are identical.</source>
        <translation>Ein linkes Ohr ist das Spiegelbild eines rechten; die Kräfte sind identisch.</translation>
    </message>
    <message>
        <source>Cochlear duct length</source>
        <translation>Länge des Ductus cochlearis</translation>
    </message>
    <message>
        <source>Scala width at round window</source>
        <translation>Skalenbreite am runden Fenster</translation>
    </message>
    <message>
        <source>Scala height at round window</source>
        <translation>Skalenhöhe am runden Fenster</translation>
    </message>
    <message>
        <source>A: basal-turn diameter</source>
        <translation>A: Durchmesser der Basalwindung</translation>
    </message>
    <message>
        <source>B: basal-turn width</source>
        <translation>B: Breite der Basalwindung</translation>
    </message>
    <message>
        <source>H: cochlear height</source>
        <translation>H: Höhe der Cochlea</translation>
    </message>
    <message>
        <source>The published scala tympani, scaled by three CT measurements.</source>
        <translation>Die veröffentlichte Scala tympani, skaliert nach drei CT-Messwerten.</translation>
    </message>
    <message>
        <source>Average of 15 human scalae tympani, scaled by the basal-turn diameters. Adapted from Froehlich et al. 2024, CC BY 4.0.</source>
        <translation>Mittel aus 15 menschlichen Scalae tympani, skaliert nach den Durchmessern der Basalwindung. Nach Froehlich et al. 2024, CC BY 4.0.</translation>
    </message>
    <message>
        <source>Average cochlea</source>
        <translation>Durchschnittliche Cochlea</translation>
    </message>
    <message>
        <source>Average of 15 human scalae tympani as measured. Adapted from Froehlich, Schurzig, Rau, Lenarz (2024), PLOS ONE, doi 10.1371/journal.pone.0295121, CC BY 4.0.</source>
        <translation>Mittel aus 15 menschlichen Scalae tympani, wie gemessen. Nach Froehlich, Schurzig, Rau, Lenarz (2024), PLOS ONE, doi 10.1371/journal.pone.0295121, CC BY 4.0.</translation>
    </message>
    <message>
        <source>Clark spiral</source>
        <translation>Clark-Spirale</translation>
    </message>
    <message>
        <source>Spiral with a constant cross-section, for comparison with earlier models.</source>
        <translation>Spirale mit konstantem Querschnitt, zum Vergleich mit früheren Modellen.</translation>
    </message>
    <message>
        <source>%1 %2. Enter a valid value or press Esc.</source>
        <translation>%1 %2. Gültigen Wert eingeben oder Esc drücken.</translation>
    </message>
    <message>
        <source>%1 not given</source>
        <translation>%1 nicht angegeben</translation>
    </message>
    <message>
        <source>CDL and section</source>
        <translation>CDL und Schnitt</translation>
    </message>
    <message>
        <source>Patient code</source>
        <translation>Patientencode</translation>
    </message>
    <message>
        <source>Patient code (no names)</source>
        <translation>Patientencode (kein Name)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PhaseLine</name>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>Outer wall</source>
        <translation>Außenwand</translation>
    </message>
    <message>
        <source>Basal turn</source>
        <translation>Basalwindung</translation>
    </message>
    <message>
        <source>Full depth</source>
        <translation>Volle Tiefe</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außerhalb</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>The tip is inside the opening and the array does not contact the wall beyond it.</source>
        <translation>Die Spitze ist in der Öffnung, und der Träger berührt die Wand dahinter nicht.</translation>
    </message>
    <message>
        <source>The array contacts the outer wall and slides along it.</source>
        <translation>Der Träger berührt die Außenwand und gleitet an ihr entlang.</translation>
    </message>
    <message>
        <source>The tip is %1° or more past the round window.</source>
        <translation>Die Spitze ist mindestens %1° hinter dem runden Fenster.</translation>
    </message>
    <message>
        <source>The stop travel is reached; part of the array stays outside.</source>
        <translation>Der Stopp ist erreicht; ein Teil des Trägers bleibt außerhalb.</translation>
    </message>
    <message>
        <source>The array is fully inserted.</source>
        <translation>Der Träger ist vollständig inseriert.</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PlanBeside</name>
    <message>
        <source>Plan beside outcome</source>
        <translation>Plan neben Ergebnis</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>The depth of the array, and the angle of each contact; 1 at the tip</source>
        <translation>Die Tiefe des Trägers und der Winkel jedes Kontakts; 1 an der Spitze</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Measured in the CT after surgery, with its 95 % interval</source>
        <translation>Gemessen im CT nach der Operation, mit 95-%-Intervall</translation>
    </message>
    <message>
        <source>Percentile</source>
        <translation>Perzentil</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Inserted length</source>
        <translation>Inserierte Länge</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Contact %1</source>
        <translation>Kontakt %1</translation>
    </message>
    <message>
        <source>Median and band of the plan; above stands what it holds. Of a contact, of the simulations in which it is inside.</source>
        <translation>Median und Band des Plans; darüber steht, was es enthält. Bei einem Kontakt aus den Simulationen, in denen er innen liegt.</translation>
    </message>
    <message>
        <source>Share of the plan’s simulations below the value found, with its error; of a contact from the quantiles of the band</source>
        <translation>Anteil der Simulationen des Plans unter dem gefundenen Wert, mit dessen Fehler; bei einem Kontakt aus den Quantilen des Bands</translation>
    </message>
    <message>
        <source>Angular insertion depth</source>
        <translation>Insertionswinkel</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PlanCells</name>
    <message>
        <source>clin. %1</source>
        <translation>klin. %1</translation>
    </message>
    <message>
        <source>transl. %1</source>
        <translation>Transl. %1</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PlanHeader</name>
    <message>
        <source>A %1</source>
        <translation>A %1</translation>
    </message>
    <message>
        <source>B %1</source>
        <translation>B %1</translation>
    </message>
    <message>
        <source>H %1</source>
        <translation>H %1</translation>
    </message>
    <message>
        <source>H not measured (population mean ± SD used)</source>
        <translation>H nicht gemessen (Populationsmittel ± SD verwendet)</translation>
    </message>
    <message>
        <source>95 % intervals, errors as measured</source>
        <translation>95-%-Intervalle, Fehler wie gemessen</translation>
    </message>
    <message>
        <source>95 % intervals, errors assumed: SD %1 mm</source>
        <translation>95-%-Intervalle, Fehler angenommen: SD %1 mm</translation>
    </message>
    <message>
        <source>A: basal-turn diameter; B: basal-turn width, perpendicular to A; H: height. Every simulation takes other values within these errors.</source>
        <translation>A: Durchmesser der basalen Windung; B: Breite der basalen Windung, senkrecht zu A; H: Höhe. Jede Simulation nimmt andere Werte innerhalb dieser Fehler.</translation>
    </message>
    <message>
        <source>95 % intervals, errors as measured, that of %1 (entered) assumed: SD %2 mm</source>
        <translation>95-%-Intervalle, Fehler wie gemessen, der von %1 (eingegeben) angenommen: SD %2 mm</translation>
    </message>
    <message>
        <source>Approach: %1</source>
        <translation>Zugang: %1</translation>
    </message>
    <message>
        <source>The line of approach in the CT is another one now: %1. Compute makes a plan with it.</source>
        <translation>Die Zugangslinie im CT ist inzwischen eine andere: %1. Berechnen erstellt einen Plan mit ihr.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PlanList</name>
    <message>
        <source>Arrays of the plan</source>
        <translation>Träger des Plans</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PlanNotes</name>
    <message>
        <source>Notes on this plan</source>
        <translation>Notizen zu diesem Plan</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PlanPage</name>
    <message>
        <source>changed by hand, </source>
        <translation>von Hand geändert, </translation>
    </message>
    <message>
        <source>Plan an insertion</source>
        <translation>Eine Insertion planen</translation>
    </message>
    <message>
        <source>Choose a patient with the measures A and B, or measure a CT on the page CT. Choose the arrays to be compared and press Compute. Each array is inserted many times; the table shows what to expect, as bands.</source>
        <translation>Einen Patienten mit den Maßen A und B wählen oder auf der Seite CT ein CT vermessen. Die Träger wählen, die verglichen werden, und „Berechnen“ drücken. Jeder Träger wird viele Male eingeführt; die Tabelle zeigt in Bändern, was zu erwarten ist.</translation>
    </message>
    <message>
        <source>This plan was interrupted before its first bands; Compute continues it.</source>
        <translation>Dieser Plan wurde vor seinen ersten Bändern unterbrochen; „Berechnen“ setzt ihn fort.</translation>
    </message>
    <message>
        <source>Opening the plan…</source>
        <translation>Der Plan wird geöffnet …</translation>
    </message>
    <message>
        <source>Preparing…</source>
        <translation>Vorbereitung …</translation>
    </message>
    <message>
        <source>Canceled. What is done is kept; Compute continues there.</source>
        <translation>Abgebrochen. Was fertig ist, bleibt; „Berechnen“ setzt dort fort.</translation>
    </message>
    <message>
        <source>Back to the table</source>
        <translation>Zurück zur Tabelle</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Enter, or a double click on a row. Ctrl and Shift select several rows.</source>
        <translation>Eingabetaste oder Doppelklick auf eine Zeile. Strg und Umschalt wählen mehrere Zeilen.</translation>
    </message>
    <message>
        <source>Compare %1 arrays</source>
        <translation>%1 Träger vergleichen</translation>
    </message>
    <message>
        <source>Open array</source>
        <translation>Träger öffnen</translation>
    </message>
    <message>
        <source>Insert this array</source>
        <translation>Diesen Träger inserieren</translation>
    </message>
    <message>
        <source>Sets patient and array on the page Insert, where the force is compared with this plan.</source>
        <translation>Stellt Patient und Träger auf der Seite Insertion ein, wo die Kraft mit diesem Plan verglichen wird.</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>Report of the plan</source>
        <translation>Bericht des Plans</translation>
    </message>
    <message>
        <source>Preparing the report…</source>
        <translation>Der Bericht wird vorbereitet …</translation>
    </message>
    <message>
        <source>This plan was interrupted before its first bands, and an array, the scenario, a distribution or the program was changed since; Compute makes a new one.</source>
        <translation>Dieser Plan wurde vor seinen ersten Bändern unterbrochen, und seither wurde ein Träger, das Szenario, eine Verteilung oder das Programm geändert; „Berechnen“ macht einen neuen.</translation>
    </message>
    <message>
        <source>An array, the scenario, a distribution or the program was changed since this plan: it is shown as it was made, and Compute makes a new one.</source>
        <translation>Seit diesem Plan wurde ein Träger, das Szenario, eine Verteilung oder das Programm geändert: Er wird gezeigt, wie er gemacht wurde, und „Berechnen“ macht einen neuen.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>%1 simulations, %2 insertions</source>
        <translation>%1 Simulationen, %2 Insertionen</translation>
    </message>
    <message>
        <source>Report of this plan as PDF or DICOM: a page for the record and an appendix</source>
        <translation>Bericht dieses Plans als PDF oder DICOM: eine Seite für die Akte und ein Anhang</translation>
    </message>
    <message>
        <source>%1%2, %3. Medians; bands: %4</source>
        <translation>%1%2, %3. Mediane; Bänder: %4</translation>
    </message>
    <message>
        <source>Computing the plan</source>
        <translation>Der Plan wird berechnet</translation>
    </message>
    <message>
        <source>%1

%2

The first bands come after 8 simulations of each array.</source>
        <translation>%1

%2

Die ersten Bänder kommen nach 8 Simulationen jedes Trägers.</translation>
    </message>
    <message>
        <source> · </source>
        <translation> · </translation>
    </message>
    <message>
        <source>%1 of at most %2 insertions.</source>
        <translation>%1 von höchstens %2 Insertionen.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 Another page can be shown meanwhile.</source>
        <translation>%1 Währenddessen kann eine andere Seite gezeigt werden.</translation>
    </message>
    <message>
        <source>Less than a minute left.</source>
        <translation>Noch weniger als eine Minute.</translation>
    </message>
    <message>
        <source>At most about %1 min left.</source>
        <translation>Noch höchstens etwa %1 min.</translation>
    </message>
    <message>
        <source>Send to the archive…</source>
        <translation>An das Archiv senden …</translation>
    </message>
    <message>
        <source>Report of this plan into the study of the patient’s CT, as DICOM</source>
        <translation>Bericht dieses Plans in die Studie des CT, als DICOM</translation>
    </message>
    <message>
        <source>Report of the plan (PDF)</source>
        <translation>Bericht des Plans (PDF)</translation>
    </message>
    <message>
        <source>%1 The insertion is into the cochlea of the plan.</source>
        <translation>%1 Inseriert wird in die Cochlea des Plans.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PlanPanel</name>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Saved plans</source>
        <translation>Gespeicherte Pläne</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>PATIENT</source>
        <translation>PATIENT</translation>
    </message>
    <message>
        <source>SAVED PLANS</source>
        <translation>GESPEICHERTE PLÄNE</translation>
    </message>
    <message>
        <source>ARRAYS</source>
        <translation>TRÄGER</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Choose all arrays</source>
        <translation>Alle Träger wählen</translation>
    </message>
    <message>
        <source>Choose no array</source>
        <translation>Keinen Träger wählen</translation>
    </message>
    <message>
        <source>Esc. What is done is kept, and Compute continues there.</source>
        <translation>Esc. Was fertig ist, bleibt, und „Berechnen“ setzt dort fort.</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keiner</translation>
    </message>
    <message>
        <source>choose a plan</source>
        <translation>einen Plan wählen</translation>
    </message>
    <message>
        <source>1 array</source>
        <translation>1 Träger</translation>
    </message>
    <message>
        <source>%1 arrays</source>
        <translation>%1 Träger</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 · %2 · interrupted</source>
        <translation>%1 · %2 · unterbrochen</translation>
    </message>
    <message>
        <source>Choose a patient with A and B first.</source>
        <translation>Zuerst einen Patienten mit A und B wählen.</translation>
    </message>
    <message>
        <source>Choose an array first.</source>
        <translation>Zuerst einen Träger wählen.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Example: %1</source>
        <translation>Beispiel: %1</translation>
    </message>
    <message>
        <source>Choose a patient</source>
        <translation>Patient wählen</translation>
    </message>
    <message>
        <source>Simulations, at most</source>
        <translation>Simulationen, höchstens</translation>
    </message>
    <message>
        <source>%1 simulations at most</source>
        <translation>höchstens %1 Simulationen</translation>
    </message>
    <message>
        <source>%1 · %2 · being computed</source>
        <translation>%1 · %2 · wird berechnet</translation>
    </message>
    <message>
        <source>No friction in a living ear is known. The first one is estimated from force curves in fresh cochleae of pigs, median 0.165; simulations take it from 0.08 to 0.33. 0.12 is recalled for arrays on endosteum; with the friction measured on a tissue simulant arrays stop at 240 to 350°.</source>
        <translation>Eine Reibung im lebenden Ohr ist nicht bekannt. Die erste ist aus Kraftkurven in frischen Cochleae von Schweinen geschätzt, Median 0,165; Simulationen nehmen sie von 0,08 bis 0,33. 0,12 ist für Elektrodenträger auf Endost erinnert; mit der an einem Gewebe-Simulans gemessenen Reibung halten Träger bei 240 bis 350°.</translation>
    </message>
    <message>
        <source>A simulation has a cochlea within the errors of the measures, an approach, a stiffness and a surgeon. Fewer are run if the median angle is known to 5° and the median peak force to 5 %.</source>
        <translation>Eine Simulation hat eine Cochlea innerhalb der Fehler der Maße, einen Zugang, eine Steifigkeit und einen Chirurgen. Es werden weniger gerechnet, wenn der mittlere Winkel auf 5° und die mittlere Maximalkraft auf 5 % bekannt sind.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PlanTable</name>
    <message>
        <source>peak %1</source>
        <translation>Spitze %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1; clinics report %2</source>
        <translation>%1; Kliniken berichten %2</translation>
    </message>
    <message>
        <source>%1, %2: %3. %4 simulations</source>
        <translation>%1, %2: %3. %4 Simulationen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PlanView</name>
    <message>
        <source>Unrolled scala tympani</source>
        <translation>Abgewickelte Scala tympani</translation>
    </message>
    <message>
        <source>Insertion force over depth</source>
        <translation>Insertionskraft über der Tiefe</translation>
    </message>
    <message>
        <source>%1 · computing the picture…</source>
        <translation>%1 · das Bild wird gerechnet …</translation>
    </message>
    <message>
        <source>%1 in the cochlea, 3D</source>
        <translation>%1 in der Cochlea, 3D</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>Tabelle speichern …</translation>
    </message>
    <message>
        <source>Save the contacts for whoever programs the processor, as CSV with a dictionary of its columns</source>
        <translation>Kontakte für die Prozessoranpassung als CSV mit einem Verzeichnis der Spalten speichern</translation>
    </message>
    <message>
        <source>Bone and landmarks</source>
        <translation>Knochen und Landmarken</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PlaneView</name>
    <message>
        <source>Text of the note</source>
        <translation>Text der Notiz</translation>
    </message>
    <message>
        <source>Text of the markup</source>
        <translation>Text der Markierung</translation>
    </message>
    <message>
        <source>%1. Drag its points; Del removes it; a double click writes its text. ± is the 95 % interval of placing points to voxels.</source>
        <translation>%1. Die Punkte ziehen; Entf entfernt; ein Doppelklick beschriftet. ± ist das 95-%-Intervall dafür, dass die Punkte auf Voxel gesetzt sind.</translation>
    </message>
    <message>
        <source>This place is outside the CT. Click into the picture.</source>
        <translation>Diese Stelle liegt außerhalb des CT. Klicken Sie in das Bild.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PopulationField</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>must be %1 to %2 mm</source>
        <translation>muss %1 bis %2 mm sein</translation>
    </message>
    <message>
        <source>%1%2 SD · ± %3 mm (95 %)</source>
        <translation>%1%2 SD · ± %3 mm (95 %)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>optional</translation>
    </message>
    <message>
        <source>Source of the value</source>
        <translation>Quelle des Werts</translation>
    </message>
    <message>
        <source>Enter a value from %1 to %2 mm</source>
        <translation>Wert von %1 bis %2 mm eingeben</translation>
    </message>
    <message>
        <source>%1–%2 mm · ± %3 mm (95 %)</source>
        <translation>%1–%2 mm · ± %3 mm (95 %)</translation>
    </message>
    <message>
        <source>range %1–%2 mm · ± %3 mm (95 %)</source>
        <translation>Bereich %1–%2 mm · ± %3 mm (95 %)</translation>
    </message>
    <message>
        <source>optional; estimated from A and B</source>
        <translation>optional; aus A und B geschätzt</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>Mittel %1</translation>
    </message>
    <message>
        <source>%1%2 SD: check it · ± %3 mm (95 %)</source>
        <translation>%1%2 SD: prüfen · ± %3 mm (95 %)</translation>
    </message>
    <message>
        <source>%1 SD below population mean (%2)</source>
        <translation>%1 SD unter dem Populationsmittel (%2)</translation>
    </message>
    <message>
        <source>%1 SD above population mean (%2)</source>
        <translation>%1 SD über dem Populationsmittel (%2)</translation>
    </message>
    <message>
        <source>%1: check the measurement</source>
        <translation>%1: Messung prüfen</translation>
    </message>
    <message>
        <source>%1 · ± %2 mm (95 %)</source>
        <translation>%1 · ± %2 mm (95 %)</translation>
    </message>
    <message>
        <source>estimated from A and B</source>
        <translation>aus A und B geschätzt</translation>
    </message>
    <message>
        <source>%1 mm, SD %2</source>
        <translation>%1 mm, SD %2</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::RecentScans</name>
    <message>
        <source>without a code</source>
        <translation>ohne Code</translation>
    </message>
    <message>
        <source>%1 · opened %2</source>
        <translation>%1 · geöffnet %2</translation>
    </message>
    <message>
        <source>No CT was opened yet, or the list was cleared.</source>
        <translation>Noch kein CT wurde geöffnet, oder die Liste wurde gelöscht.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::RecentWork</name>
    <message>
        <source>RECENT PATIENTS</source>
        <translation>LETZTE PATIENTEN</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>All patients: search and edit</source>
        <translation>Alle Patienten: suchen und bearbeiten</translation>
    </message>
    <message>
        <source>LAST INSERTIONS</source>
        <translation>LETZTE INSERTIONEN</translation>
    </message>
    <message>
        <source>Continue: %1</source>
        <translation>Fortsetzen: %1</translation>
    </message>
    <message>
        <source>Replay %1 · %2</source>
        <translation>Wiedergabe %1 · %2</translation>
    </message>
    <message>
        <source>All recorded insertions</source>
        <translation>Alle aufgezeichneten Insertionen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ReferenceRow</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Reference: %1</source>
        <translation>Referenz: %1</translation>
    </message>
    <message>
        <source>It has %1.</source>
        <translation>Sie hat %1.</translation>
    </message>
    <message>
        <source>Removes the reference from chart and 3D view.</source>
        <translation>Entfernt die Referenz aus Diagramm und 3D-Ansicht.</translation>
    </message>
    <message>
        <source>It has %1. Its array is not shown in the 3D view.</source>
        <translation>Sie hat %1. Ihr Träger wird in der 3D-Ansicht nicht gezeigt.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ReplayBar</name>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Abspielen oder anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>◂</source>
        <translation>◂</translation>
    </message>
    <message>
        <source>▸</source>
        <translation>▸</translation>
    </message>
    <message>
        <source>−</source>
        <translation>−</translation>
    </message>
    <message>
        <source>Slower (comma)</source>
        <translation>Langsamer (Komma)</translation>
    </message>
    <message>
        <source>+</source>
        <translation>+</translation>
    </message>
    <message>
        <source>Close replay</source>
        <translation>Wiedergabe beenden</translation>
    </message>
    <message>
        <source>Back to the insertion (Esc)</source>
        <translation>Zurück zur Insertion (Esc)</translation>
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
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>replay · %1 · not a medical device</source>
        <translation>Wiedergabe · %1 · kein Medizinprodukt</translation>
    </message>
    <message>
        <source>Back 1 ms (Left)</source>
        <translation>1 ms zurück (Links)</translation>
    </message>
    <message>
        <source>Forward 1 ms (Right)</source>
        <translation>1 ms vor (Rechts)</translation>
    </message>
    <message>
        <source>Faster (period)</source>
        <translation>Schneller (Punkt)</translation>
    </message>
    <message>
        <source>Back 1 ms</source>
        <translation>1 ms zurück</translation>
    </message>
    <message>
        <source>Forward 1 ms</source>
        <translation>1 ms vor</translation>
    </message>
    <message>
        <source>%1 s, %2 mm, %3 mN: %4</source>
        <translation>%1 s, %2 mm, %3 mN: %4</translation>
    </message>
    <message>
        <source>Recorded time since the first motion; after the insertion time it includes the rest</source>
        <translation>Aufgezeichnete Zeit seit der ersten Bewegung; nach der Insertionsdauer enthält sie die Ruhe</translation>
    </message>
    <message>
        <source>%1 of %2 s recorded</source>
        <translation>%1 von %2 s aufgezeichnet</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ReplayControl</name>
    <message>
        <source>Space plays or pauses. ← and → step by 1 ms.</source>
        <translation>Leertaste spielt ab oder hält an. ← und → springen um 1 ms.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ReplayPlayer</name>
    <message>
        <source>verifying…</source>
        <translation>wird geprüft …</translation>
    </message>
    <message>
        <source>differs from the recording: %1</source>
        <translation>weicht von der Aufzeichnung ab: %1</translation>
    </message>
    <message>
        <source>differs from sample %1 (%2)</source>
        <translation>weicht ab Abtastwert %1 ab (%2)</translation>
    </message>
    <message>
        <source>verified up to sample %1</source>
        <translation>geprüft bis Abtastwert %1</translation>
    </message>
    <message>
        <source>verified: identical replay</source>
        <translation>geprüft: identische Wiedergabe</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ResultCard</name>
    <message>
        <source>Close; the recording is kept</source>
        <translation>Schließen; die Aufzeichnung bleibt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>Save a report of this insertion as PDF</source>
        <translation>Einen Bericht dieser Insertion als PDF speichern</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compare with the insertion before</source>
        <translation>Mit der Insertion davor vergleichen</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Insert once more, with a new recording</source>
        <translation>Noch einmal inserieren, mit einer neuen Aufzeichnung</translation>
    </message>
    <message>
        <source>outside %1</source>
        <translation>außerhalb %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Contacts…</source>
        <translation>Kontakte …</translation>
    </message>
    <message>
        <source>Save the contacts for whoever programs the processor, as CSV with a dictionary of its columns</source>
        <translation>Kontakte für die Prozessoranpassung als CSV mit einem Verzeichnis der Spalten speichern</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>clinics report</source>
        <translation>Kliniken berichten</translation>
    </message>
    <message>
        <source>Send…</source>
        <translation>Senden …</translation>
    </message>
    <message>
        <source>Report of this insertion into the study of the patient’s CT, as DICOM to an archive</source>
        <translation>Bericht dieser Insertion in die Studie des CTs des Patienten, als DICOM an ein Archiv</translation>
    </message>
    <message>
        <source>The greatest force at which the hands of plans stop. This insertion went on above it, so its depth, angle and contacts are not those that a plan or a clinic reports.</source>
        <translation>Die größte Kraft, bei der die Hände der Pläne stoppen. Diese Insertion ging darüber hinaus; Tiefe, Winkel und Kontakte sind daher nicht die, die ein Plan oder eine Klinik nennt.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::RunsTable</name>
    <message>
        <source>left</source>
        <translation>link</translation>
    </message>
    <message>
        <source>right</source>
        <translation>recht</translation>
    </message>
    <message>
        <source>%1 · changed by hand</source>
        <translation>%1 · von Hand geändert</translation>
    </message>
    <message>
        <source>%1 · %2
%3 · %4 ear · %5</source>
        <translation>%1 · %2
%3 · %4es Ohr · %5</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>rupture at %1°</source>
        <translation>Ruptur bei %1°</translation>
    </message>
    <message>
        <source>%1 mN</source>
        <translation>%1 mN</translation>
    </message>
    <message>
        <source>%1 (rib %2)</source>
        <translation>%1 (Rippe %2)</translation>
    </message>
    <message>
        <source>advance off-stylet</source>
        <translation>Advance-off-Stylet</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Insertion</source>
        <translation>Insertion</translation>
    </message>
    <message>
        <source>At cursor</source>
        <translation>Am Cursor</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Maximalkraft</translation>
    </message>
    <message>
        <source>at depth</source>
        <translation>bei Tiefe</translation>
    </message>
    <message>
        <source>Without ribs</source>
        <translation>Ohne Rippen</translation>
    </message>
    <message>
        <source>Insertion work</source>
        <translation>Insertionsarbeit</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Rückzüge</translation>
    </message>
    <message>
        <source>Tip angle</source>
        <translation>Winkel der Spitze</translation>
    </message>
    <message>
        <source>Translocation</source>
        <translation>Translokation</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>Peak force with no marker rib at the opening: that of the array in the cochlea.</source>
        <translation>Maximalkraft ohne Markierungsrippe an der Öffnung: die des Elektrodenträgers in der Cochlea.</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1 mJ</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 of 100</source>
        <translation>%1 von 100</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>At %1</source>
        <translation>Bei %1</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>Mittl. Geschw.</translation>
    </message>
    <message>
        <source>Inward motion up to the maximum depth by its time, pauses included.</source>
        <translation>Bewegung einwärts bis zur maximalen Tiefe durch ihre Zeit, Pausen eingeschlossen.</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Insertion time</source>
        <translation>Insertionsdauer</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SavedPatientRow</name>
    <message>
        <source>Saved patients</source>
        <translation>Gespeicherte Patienten</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>Open a patient</source>
        <translation>Patient öffnen</translation>
    </message>
    <message>
        <source>Search all patients…</source>
        <translation>Alle Patienten durchsuchen …</translation>
    </message>
    <message>
        <source>New patient…</source>
        <translation>Neuer Patient …</translation>
    </message>
    <message>
        <source>Save changes</source>
        <translation>Änderungen speichern</translation>
    </message>
    <message>
        <source>Save patient</source>
        <translation>Patient speichern</translation>
    </message>
    <message>
        <source>Keeps these numbers under the patient code.</source>
        <translation>Speichert diese Werte unter dem Patientencode.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Saves these numbers as a new version of %1.</source>
        <translation>Speichert diese Werte als neue Version von %1.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ScenarioHeader</name>
    <message>
        <source>MODIFIED</source>
        <translation>GEÄNDERT</translation>
    </message>
    <message>
        <source>Locked during an insertion</source>
        <translation>Während der Insertion gesperrt</translation>
    </message>
    <message>
        <source>Restore the published values</source>
        <translation>Veröffentlichte Werte wiederherstellen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>SCENARIO</source>
        <translation>SZENARIO</translation>
    </message>
    <message>
        <source>Hide the panel (B)</source>
        <translation>Seitenleiste ausblenden (B)</translation>
    </message>
    <message>
        <source>Hide the panel</source>
        <translation>Seitenleiste ausblenden</translation>
    </message>
    <message>
        <source>The setup can be changed before and after an insertion. Press Reset.</source>
        <translation>Die Einstellungen lassen sich vor und nach einer Insertion ändern. „Zurücksetzen“ drücken.</translation>
    </message>
    <message>
        <source>%1 · modified from %2</source>
        <translation>%1 · geändert gegenüber %2</translation>
    </message>
    <message>
        <source>%1. Changed: %2. %3</source>
        <translation>%1. Geändert: %2. %3</translation>
    </message>
    <message>
        <source>Differs from the preset: %1.</source>
        <translation>Weicht von der Vorlage ab: %1.</translation>
    </message>
    <message>
        <source>Restore the preset</source>
        <translation>Vorlage wiederherstellen</translation>
    </message>
    <message>
        <source>Changed: %1. %2</source>
        <translation>Geändert: %1. %2</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Z)</source>
        <translation>%1 (Strg+Z)</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Shift+Z)</source>
        <translation>%1 (Strg+Umschalt+Z)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SceneLabels</name>
    <message>
        <source>Round window</source>
        <translation>Rundes Fenster</translation>
    </message>
    <message>
        <source>Axis of the basal turn</source>
        <translation>Achse der Basalwindung</translation>
    </message>
    <message>
        <source>Line of approach</source>
        <translation>Zugangslinie</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::Scrubber</name>
    <message>
        <source>Position in the replay</source>
        <translation>Position in der Wiedergabe</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::Section</name>
    <message>
        <source>Collapse or expand</source>
        <translation>Ein- oder ausklappen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SendDialog</name>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>Folder of the CT…</source>
        <translation>Ordner des CT …</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Send to the archive</source>
        <translation>An das Archiv senden</translation>
    </message>
    <message>
        <source>Folder of the patient’s CT; the objects take name and number from it</source>
        <translation>Ordner des CT; daraus stammen Name und Nummer der Objekte</translation>
    </message>
    <message>
        <source>No archive is entered yet: see Settings, DICOM archives.</source>
        <translation>Noch ist kein Archiv eingetragen: siehe Einstellungen, DICOM-Archive.</translation>
    </message>
    <message>
        <source>What is sent names the patient, as the CT does. It goes into the study of that CT and into no other; the archive must have it under the same patient number and birth date. Results are for research and training, not a diagnosis.</source>
        <translation>Was gesendet wird, nennt den Patienten wie das CT. Es geht in die Studie dieses CT und in keine andere; das Archiv muss sie unter derselben Patientennummer und demselben Geburtsdatum haben. Ergebnisse dienen der Forschung und Ausbildung, sie sind keine Diagnose.</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>Wird gesendet …</translation>
    </message>
    <message>
        <source>The CT that this was made from is not open. Choose its folder.</source>
        <translation>Das CT, aus dem dies entstand, ist nicht geöffnet. Wählen Sie seinen Ordner.</translation>
    </message>
    <message>
        <source>The CT is the one that is open on the page CT.</source>
        <translation>Das CT ist das auf der Seite CT geöffnete.</translation>
    </message>
    <message>
        <source>CT: %1</source>
        <translation>CT: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Canceling…</source>
        <translation>Wird abgebrochen …</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SeriesRows</name>
    <message>
        <source>Series</source>
        <translation>Serien</translation>
    </message>
    <message>
        <source>Series no.</source>
        <translation>Serie Nr.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ServersSection</name>
    <message>
        <source>Archives</source>
        <translation>Archive</translation>
    </message>
    <message>
        <source>C-GET, without a port of this machine</source>
        <translation>C-GET, ohne Port dieses Rechners</translation>
    </message>
    <message>
        <source>C-MOVE, to a port of this machine</source>
        <translation>C-MOVE, an einen Port dieses Rechners</translation>
    </message>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>Verschlüsselt (TLS)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>%1 answers.</source>
        <translation>%1 antwortet.</translation>
    </message>
    <message>
        <source>DICOM archives (PACS)</source>
        <translation>DICOM-Archive (PACS)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>as you call it</source>
        <translation>wie Sie es nennen</translation>
    </message>
    <message>
        <source>AE title</source>
        <translation>AE-Titel</translation>
    </message>
    <message>
        <source>of the archive</source>
        <translation>des Archivs</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>name or IPv4 address</source>
        <translation>Name oder IPv4-Adresse</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Own AE title</source>
        <translation>Eigener AE-Titel</translation>
    </message>
    <message>
        <source>Own port</source>
        <translation>Eigener Port</translation>
    </message>
    <message>
        <source>Authority (PEM)</source>
        <translation>Zertifizierungsstelle (PEM)</translation>
    </message>
    <message>
        <source>Own certificate (PEM)</source>
        <translation>Eigenes Zertifikat (PEM)</translation>
    </message>
    <message>
        <source>Own key (PEM)</source>
        <translation>Eigener Schlüssel (PEM)</translation>
    </message>
    <message>
        <source>Choose the file: %1</source>
        <translation>Datei wählen: %1</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>PEM (*.pem *.crt *.key);;All files (*)</source>
        <translation>PEM (*.pem *.crt *.key);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Saved. Test it.</source>
        <translation>Gespeichert. Prüfen Sie es.</translation>
    </message>
    <message>
        <source>%1 was removed.</source>
        <translation>%1 wurde entfernt.</translation>
    </message>
    <message>
        <source>Asking %1…</source>
        <translation>%1 wird gefragt …</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>The administrator of the archive has to enter: AE title %1, address %2, port %3, and allow it to query, to move to this port and to store. The firewall must let the archive in at this port.</source>
        <translation>Der Administrator des Archivs muss eintragen: AE-Titel %1, Adresse %2, Port %3, und Suchen, Übertragen an diesen Port (C-MOVE) und Speichern erlauben. Die Firewall muss das Archiv an diesem Port einlassen.</translation>
    </message>
    <message>
        <source>The administrator of the archive has to enter: AE title %1, address %2, and allow it to query, to get (C-GET) and to store. No port is needed.</source>
        <translation>Der Administrator des Archivs muss eintragen: AE-Titel %1, Adresse %2, und Suchen, Abrufen (C-GET) und Speichern erlauben. Ein Port ist nicht nötig.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SessionList</name>
    <message>
        <source>Recorded insertions</source>
        <translation>Aufgezeichnete Insertionen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SessionTable</name>
    <message>
        <source>unreadable</source>
        <translation>unlesbar</translation>
    </message>
    <message>
        <source>left</source>
        <translation>link</translation>
    </message>
    <message>
        <source>right</source>
        <translation>recht</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 mN at %2 mm</source>
        <translation>%1 mN bei %2 mm</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Advance off-stylet</source>
        <translation>Advance off-stylet</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Ear</source>
        <translation>Ohr</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Peak force at depth</source>
        <translation>Maximalkraft bei Tiefe</translation>
    </message>
    <message>
        <source>Tip angle</source>
        <translation>Winkel der Spitze</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>Insertion time</source>
        <translation>Insertionsdauer</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SessionTasks</name>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>%1 is shown as reference in the next insertions.</source>
        <translation>%1 wird in den nächsten Insertionen als Referenz gezeigt.</translation>
    </message>
    <message>
        <source>Replaying %1 for the report…</source>
        <translation>%1 wird für den Bericht wiedergegeben …</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SessionsPage</name>
    <message>
        <source>Recorded insertions</source>
        <translation>Aufgezeichnete Insertionen</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message numerus="yes">
        <source>%n in the library</source>
        <translation>
            <numerusform>eine in der Sammlung</numerusform>
            <numerusform>%n in der Sammlung</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>%n moved to the trash.</source>
        <translation>
            <numerusform>Eine ist im Papierkorb.</numerusform>
            <numerusform>%n sind im Papierkorb.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
    <message>
        <source>Reading recording %1 of %2. Esc cancels.</source>
        <translation>Aufzeichnung %1 von %2 wird gelesen. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Search by patient, array, date or name</source>
        <translation>Suche nach Patient, Träger, Datum oder Name</translation>
    </message>
    <message>
        <source>Search recordings</source>
        <translation>Aufzeichnungen suchen</translation>
    </message>
    <message>
        <source>List the recordings read so far (Esc)</source>
        <translation>Bisher gelesene Aufzeichnungen auflisten (Esc)</translation>
    </message>
    <message>
        <source>Replay the recording (Enter)</source>
        <translation>Aufzeichnung wiedergeben (Eingabe)</translation>
    </message>
    <message>
        <source>Plot two or more recordings on common axes</source>
        <translation>Zwei oder mehr Aufzeichnungen auf gemeinsamen Achsen</translation>
    </message>
    <message>
        <source>Use as reference</source>
        <translation>Als Referenz</translation>
    </message>
    <message>
        <source>Show its force as reference trace in the next insertions</source>
        <translation>Ihre Kraft in den nächsten Insertionen als Referenzkurve zeigen</translation>
    </message>
    <message>
        <source>Rename the recording (F2)</source>
        <translation>Aufzeichnung umbenennen (F2)</translation>
    </message>
    <message>
        <source>Move to the trash (Delete)</source>
        <translation>In den Papierkorb verschieben (Entf)</translation>
    </message>
    <message>
        <source>Restore from the trash (Ctrl+Z)</source>
        <translation>Aus dem Papierkorb wiederherstellen (Strg+Z)</translation>
    </message>
    <message>
        <source>Canceled: %1 of %2 recordings listed. Open this page again to continue.</source>
        <translation>Abgebrochen: %1 von %2 Aufzeichnungen aufgelistet. Seite erneut öffnen, um fortzufahren.</translation>
    </message>
    <message>
        <source>No recorded insertions</source>
        <translation>Keine aufgezeichneten Insertionen</translation>
    </message>
    <message>
        <source>Every insertion is recorded automatically. Recordings can be replayed, compared and reported here.</source>
        <translation>Jede Insertion wird automatisch aufgezeichnet. Aufzeichnungen lassen sich hier wiedergeben, vergleichen und als Bericht speichern.</translation>
    </message>
    <message>
        <source>No results</source>
        <translation>Keine Treffer</translation>
    </message>
    <message>
        <source>No recording matches “%1” by patient, array, date or name.</source>
        <translation>Keine Aufzeichnung passt mit Patient, Träger, Datum oder Name zu „%1“.</translation>
    </message>
    <message>
        <source>This insertion is being recorded. Reset ends the recording.</source>
        <translation>Diese Insertion wird aufgezeichnet. „Zurücksetzen“ beendet die Aufzeichnung.</translation>
    </message>
    <message>
        <source>Select several with Ctrl or Shift to compare.</source>
        <translation>Mehrere mit Strg oder Umschalt auswählen, um sie zu vergleichen.</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>This insertion has ended; its rest is recorded until nothing moves.</source>
        <translation>Diese Insertion ist beendet; ihre Ruhe wird aufgezeichnet, bis sich nichts mehr bewegt.</translation>
    </message>
    <message>
        <source>Save a report as PDF or DICOM</source>
        <translation>Bericht als PDF oder DICOM speichern</translation>
    </message>
    <message>
        <source>Only insertions can be compared; the selection has a recording that is none.</source>
        <translation>Nur Insertionen können verglichen werden; in der Auswahl ist eine Aufzeichnung, die keine ist.</translation>
    </message>
    <message>
        <source>Send…</source>
        <translation>Senden …</translation>
    </message>
    <message>
        <source>Report of the insertion into the study of the patient’s CT, as DICOM to an archive</source>
        <translation>Bericht der Insertion in die Studie des CTs des Patienten, als DICOM an ein Archiv</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SettingsOverlay</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Colors</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>wie das System</translation>
    </message>
    <message>
        <source>Hold the array (Space or button)</source>
        <translation>Träger halten (Leertaste oder Schaltfläche)</translation>
    </message>
    <message>
        <source>while pressed</source>
        <translation>solange gedrückt</translation>
    </message>
    <message>
        <source>press to hold, press again to release</source>
        <translation>drücken zum Halten, erneut drücken zum Loslassen</translation>
    </message>
    <message>
        <source>Single-key shortcuts</source>
        <translation>Tastenkürzel aus einer Taste</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Institution, for reports (optional)</source>
        <translation>Einrichtung, für Berichte (optional)</translation>
    </message>
    <message>
        <source>Operator, for reports (optional)</source>
        <translation>Operateur, für Berichte (optional)</translation>
    </message>
    <message>
        <source>Log file: %1</source>
        <translation>Protokolldatei: %1</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Logo for reports</source>
        <translation>Logo für Berichte</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Logo, for reports</source>
        <translation>Logo, für Berichte</translation>
    </message>
    <message>
        <source>Changes reload the window.</source>
        <translation>Änderungen laden das Fenster neu.</translation>
    </message>
    <message>
        <source>Settings are locked during an insertion. Press Reset first.</source>
        <translation>Während der Insertion gesperrt. Zuerst „Zurücksetzen“ drücken.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Removes the list of where CTs were opened, which the history of patients uses, too. No CT and no measure is deleted.</source>
        <translation>Entfernt die Liste, wo CTs geöffnet wurden; auch der Verlauf der Patienten nutzt sie. Kein CT und kein Messwert wird gelöscht.</translation>
    </message>
    <message>
        <source>It is no longer known where CTs were opened.</source>
        <translation>Wo CTs geöffnet wurden, ist nicht mehr bekannt.</translation>
    </message>
    <message>
        <source>The list cannot be removed. Check the permissions of the folder of the log file.</source>
        <translation>Die Liste lässt sich nicht entfernen. Prüfen Sie die Rechte des Ordners der Protokolldatei.</translation>
    </message>
    <message>
        <source>Recent CTs</source>
        <translation>Letzte CTs</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SetupHistory</name>
    <message>
        <source>restore the preset</source>
        <translation>Vorlage wiederherstellen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SidePanel</name>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Wall force</source>
        <translation>Wandkraft</translation>
    </message>
    <message>
        <source>Basilar membrane</source>
        <translation>Basilarmembran</translation>
    </message>
    <message>
        <source>Stylet and tweezers</source>
        <translation>Stilett und Pinzette</translation>
    </message>
    <message>
        <source>Show the panel (B)</source>
        <translation>Seitenleiste einblenden (B)</translation>
    </message>
    <message>
        <source>Show the panel</source>
        <translation>Seitenleiste einblenden</translation>
    </message>
    <message>
        <source>Contact forces</source>
        <translation>Kontaktkräfte</translation>
    </message>
    <message>
        <source>Published measurements</source>
        <translation>Veröffentlichte Messungen</translation>
    </message>
    <message>
        <source>Published measurements, mean ± SD, in the chart of force over travel.</source>
        <translation>Veröffentlichte Messungen, Mittelwert ± SD, im Diagramm der Kraft über den Vorschub.</translation>
    </message>
    <message>
        <source>Not comparable: array, technique, cochlea, friction or speed differ from the published experiment.</source>
        <translation>Nicht vergleichbar: Träger, Technik, Cochlea, Reibung oder Geschwindigkeit weichen vom veröffentlichten Versuch ab.</translation>
    </message>
    <message>
        <source>Bone and landmarks</source>
        <translation>Knochen und Landmarken</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SpeedPad</name>
    <message>
        <source>Hold here to insert</source>
        <translation>Hier halten zum Einführen</translation>
    </message>
    <message>
        <source>Release to pause</source>
        <translation>Loslassen zum Anhalten</translation>
    </message>
    <message>
        <source>slow</source>
        <translation>langsam</translation>
    </message>
    <message>
        <source>fast</source>
        <translation>schnell</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StartPage</name>
    <message>
        <source>Watch a demo insertion</source>
        <translation>Demo-Insertion ansehen</translation>
    </message>
    <message>
        <source>Keys 1, 2 and 3 do the same. For research and training; not a medical device.</source>
        <translation>Die Tasten 1, 2 und 3 tun dasselbe. Für Forschung und Übung; kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Electrode array insertion</source>
        <translation>Insertion eines Elektrodenträgers</translation>
    </message>
    <message>
        <source>Choose an anatomy</source>
        <translation>Anatomie wählen</translation>
    </message>
    <message>
        <source>New patient</source>
        <translation>Neuer Patient</translation>
    </message>
    <message>
        <source>Average cochlea</source>
        <translation>Mittlere Cochlea</translation>
    </message>
    <message>
        <source>Average of 15 human cochleae. Insert automatically or with mouse and keyboard and follow the insertion force.</source>
        <translation>Mittel aus 15 menschlichen Cochleae. Automatisch oder mit Maus und Tastatur einführen und die Insertionskraft verfolgen.</translation>
    </message>
    <message>
        <source>A Contour array is inserted automatically into the published cochlea; the published measurements are shown for comparison.</source>
        <translation>Ein Contour-Träger wird automatisch in die veröffentlichte Cochlea eingeführt; die veröffentlichten Messungen werden zum Vergleich gezeigt.</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Measure the patient’s CT, or enter A, B and H. Each value is compared with the population.</source>
        <translation>Das CT des Patienten vermessen oder A, B und H eingeben. Jeder Wert wird mit der Population verglichen.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StatusLine</name>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StereoWindow</name>
    <message>
        <source>Perilymph stereo view</source>
        <translation>Perilymph Stereoansicht</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StoredStudies</name>
    <message>
        <source>Studies made here</source>
        <translation>Hier erstellte Studien</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>STUDIES MADE HERE</source>
        <translation>HIER ERSTELLTE STUDIEN</translation>
    </message>
    <message>
        <source>%1 · complete</source>
        <translation>%1 · vollständig</translation>
    </message>
    <message>
        <source>%1 · not begun</source>
        <translation>%1 · nicht begonnen</translation>
    </message>
    <message>
        <source>%1 · %2 of %3</source>
        <translation>%1 · %2 von %3</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StudiesPage</name>
    <message>
        <source>%1 · changed by hand</source>
        <translation>%1 · von Hand geändert</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open study…</source>
        <translation>Studie öffnen …</translation>
    </message>
    <message>
        <source>Open study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Results of studies (*.sqlite);;All files (*)</source>
        <translation>Ergebnisse von Studien (*.sqlite);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>Canceled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>%1 of %2 insertions</source>
        <translation>%1 von %2 Insertionen</translation>
    </message>
    <message>
        <source>Running insertion %1 again…</source>
        <translation>Insertion %1 wird erneut ausgeführt …</translation>
    </message>
    <message>
        <source>A study runs many insertions: arrays, cochleae and techniques. Make one here, or open what perilymph-cli study or an earlier study has written.</source>
        <translation>Eine Studie rechnet viele Insertionen: Träger, Cochleae und Techniken. Erstellen Sie hier eine, oder öffnen Sie, was perilymph-cli study oder eine frühere Studie geschrieben hat.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>New study…</source>
        <translation>Neue Studie …</translation>
    </message>
    <message>
        <source>Esc. Of a study that runs, what is done is kept.</source>
        <translation>Esc. Von einer laufenden Studie bleibt, was fertig ist.</translation>
    </message>
    <message>
        <source>Runs the rest of the study that was canceled</source>
        <translation>Rechnet den Rest der abgebrochenen Studie</translation>
    </message>
    <message>
        <source>Export the shown insertions, groups, differences and slopes as CSV, with units.</source>
        <translation>Die gezeigten Insertionen, Gruppen, Differenzen und Steigungen als CSV mit Einheiten exportieren.</translation>
    </message>
    <message>
        <source>Preparing the study…</source>
        <translation>Die Studie wird vorbereitet …</translation>
    </message>
    <message>
        <source>%1, about %2 left. You can switch pages meanwhile.</source>
        <translation>%1, noch etwa %2. Sie können inzwischen die Seite wechseln.</translation>
    </message>
    <message>
        <source>Canceled. %1 of %2 insertions are kept; Continue runs the rest.</source>
        <translation>Abgebrochen. %1 von %2 Insertionen bleiben; Fortsetzen rechnet den Rest.</translation>
    </message>
    <message>
        <source>Canceling…</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>The study is complete. Its settings, study.toml, are beside it.</source>
        <translation>Die Studie ist vollständig. Ihre Einstellungen, study.toml, liegen daneben.</translation>
    </message>
    <message>
        <source>Export to folder</source>
        <translation>In Ordner exportieren</translation>
    </message>
    <message>
        <source>%1 files saved to %2.</source>
        <translation>%1 Dateien in %2 gespeichert.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StudyDetails</name>
    <message>
        <source>Click a point to see its insertion. With the keyboard: arrow keys, Home for the lowest and End for the highest value.</source>
        <translation>Einen Punkt anklicken, um seine Insertion zu sehen. Mit der Tastatur: Pfeiltasten, Pos1 für den kleinsten, Ende für den größten Wert.</translation>
    </message>
    <message>
        <source>Replay this insertion</source>
        <translation>Diese Insertion wiedergeben</translation>
    </message>
    <message>
        <source>Runs it again, as the study, its seed and its number say, and replays it (Enter)</source>
        <translation>Rechnet sie erneut, wie Studie, Startwert und Nummer es sagen, und gibt sie wieder (Eingabe)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StudyPanel</name>
    <message>
        <source>Horizontal axis</source>
        <translation>Waagerechte Achse</translation>
    </message>
    <message>
        <source>Vertical axis</source>
        <translation>Senkrechte Achse</translation>
    </message>
    <message>
        <source>Color by</source>
        <translation>Farbe nach</translation>
    </message>
    <message>
        <source>Open study…</source>
        <translation>Studie öffnen …</translation>
    </message>
    <message>
        <source>study.sqlite, or a shard, as &apos;perilymph-cli study&apos; writes them</source>
        <translation>study.sqlite oder ein Teil, wie &apos;perilymph-cli study&apos; sie schreibt</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>VERTICAL</source>
        <translation>SENKRECHT</translation>
    </message>
    <message>
        <source>HORIZONTAL</source>
        <translation>WAAGERECHT</translation>
    </message>
    <message>
        <source>COLOR BY</source>
        <translation>FARBE NACH</translation>
    </message>
    <message>
        <source>COCHLEAR SIZE: A, MM</source>
        <translation>GRÖSSE DER COCHLEA: A, MM</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>New study…</source>
        <translation>Neue Studie …</translation>
    </message>
    <message>
        <source>Statistics of</source>
        <translation>Statistik über</translation>
    </message>
    <message>
        <source>STATISTICS OF</source>
        <translation>STATISTIK ÜBER</translation>
    </message>
    <message>
        <source>Cochlear size, %1: “%2” is no number and limits nothing. Enter millimeters, or empty the field.</source>
        <translation>Größe der Cochlea, %1: „%2“ ist keine Zahl und begrenzt nichts. Millimeter eingeben oder das Feld leeren.</translation>
    </message>
    <message>
        <source>Cochlear size: from %1 to %2 holds no insertion. Exchange the limits.</source>
        <translation>Größe der Cochlea: Von %1 bis %2 liegt keine Insertion. Die Grenzen tauschen.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StudyPlot</name>
    <message>
        <source>Insertions of the study</source>
        <translation>Insertionen der Studie</translation>
    </message>
    <message>
        <source>stopped before full depth</source>
        <translation>vor voller Tiefe gestoppt</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StudyRows</name>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>Geboren</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StudyWork</name>
    <message>
        <source>Insertion %1 was run again: peak force %2 mN, as in the study.</source>
        <translation>Insertion %1 wurde erneut ausgeführt: Maximalkraft %2 mN, wie in der Studie.</translation>
    </message>
    <message>
        <source>Insertion %1 was run again: peak force %2 mN; the study, run by another version, has %3 mN.</source>
        <translation>Insertion %1 wurde erneut ausgeführt: Maximalkraft %2 mN; die Studie einer anderen Version hat %3 mN.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SummaryTables</name>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>%1 % (%2–%3)</source>
        <translation>%1 % (%2–%3)</translation>
    </message>
    <message>
        <source>All insertions</source>
        <translation>Alle Insertionen</translation>
    </message>
    <message>
        <source>Groups of insertions</source>
        <translation>Gruppen von Insertionen</translation>
    </message>
    <message>
        <source>Differences of groups</source>
        <translation>Differenzen der Gruppen</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>Slope, %1/%2</source>
        <translation>Steigung, %1/%2</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Complete (95 %)</source>
        <translation>Vollständig (95 %)</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Angle, °</source>
        <translation>Winkel, °</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Tiefe, mm</translation>
    </message>
    <message>
        <source>Peak force, mN</source>
        <translation>Größte Kraft, mN</translation>
    </message>
    <message>
        <source>%1 of %2 complete: %3 % (%4–%5)</source>
        <translation>%1 von %2 vollständig: %3 % (%4–%5)</translation>
    </message>
    <message>
        <source>%1 − %2</source>
        <translation>%1 − %2</translation>
    </message>
    <message>
        <source>%1 pairs, %2 cochleae</source>
        <translation>%1 Paare, %2 Cochleae</translation>
    </message>
    <message>
        <source>Welch, %1 and %2</source>
        <translation>Welch, %1 und %2</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>%1 (%2–%3); %4</source>
        <translation>%1 (%2–%3); %4</translation>
    </message>
    <message>
        <source>%1 of %2 (%3–%4 %)</source>
        <translation>%1 von %2 (%3–%4 %)</translation>
    </message>
    <message>
        <source>%1, %2 not prepared</source>
        <translation>%1, %2 nicht vorbereitet</translation>
    </message>
    <message>
        <source>Median (quartiles); mean. They, differences and lines are of all insertions that ran, the stopped ones with what they reached.</source>
        <translation>Median (Quartile); Mittelwert. Sie, Differenzen und Geraden gelten für alle ausgeführten Insertionen, die gestoppten mit dem, was sie erreichten.</translation>
    </message>
    <message>
        <source>Median (quartiles); mean. They, differences and lines are of complete insertions only: without the stopped ones they look deeper and gentler.</source>
        <translation>Median (Quartile); Mittelwert. Sie, Differenzen und Geraden gelten nur für vollständige Insertionen: ohne die gestoppten erscheinen sie tiefer und sanfter.</translation>
    </message>
    <message>
        <source>Difference of means (95 %)</source>
        <translation>Differenz der Mittelwerte (95 %)</translation>
    </message>
    <message>
        <source>Intervals of 95 %: Wilson for complete insertions; in it and in those of the lines insertions that share a cochlea count as independent; of differences of means, Student over cochleae of pairs that share the draw, Welch for groups without pairs; not corrected for several comparisons. Lines: least squares, with the 95 % band of the mean.</source>
        <translation>95-%-Intervalle: Wilson für vollständige Insertionen; darin und in denen der Geraden gelten Insertionen in derselben Cochlea als unabhängig; für Differenzen der Mittelwerte Student über Cochleae aus Paaren mit gleichen Zufallswerten, Welch für Gruppen ohne Paare; nicht für mehrere Vergleiche korrigiert. Geraden: kleinste Quadrate, mit dem 95-%-Band des Mittelwerts.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SurfaceView</name>
    <message>
        <source>Bone and measured cochlea, 3D</source>
        <translation>Knochen und gemessene Cochlea, 3D</translation>
    </message>
    <message>
        <source>Computing the bone…</source>
        <translation>Knochen wird berechnet …</translation>
    </message>
    <message>
        <source>Bone, cut across the axis of the basal turn</source>
        <translation>Knochen, quer zur Achse der Basalwindung geschnitten</translation>
    </message>
    <message>
        <source>Bone of the CT, cut open from below</source>
        <translation>Knochen des CT, von unten aufgeschnitten</translation>
    </message>
    <message>
        <source>Drag the handle on the line of approach, or Shift+arrow keys: turn it about the opening. Home: along the axis of the opening.</source>
        <translation>Griff der Zugangslinie ziehen oder Umschalt+Pfeiltasten: um die Öffnung drehen. Pos1: in die Achse der Öffnung legen.</translation>
    </message>
    <message>
        <source>Approach: %1, %2</source>
        <translation>Zugang: %1, %2</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SurgeryForm</name>
    <message>
        <source>More that you know</source>
        <translation>Was Sie noch wissen</translation>
    </message>
    <message>
        <source>Implanted array</source>
        <translation>Implantierter Träger</translation>
    </message>
    <message>
        <source>Stopped because</source>
        <translation>Beendet wegen</translation>
    </message>
    <message>
        <source>Mark reached</source>
        <translation>Marke erreicht</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Choose the array</source>
        <translation>Träger wählen</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Why the array was not pushed further. A stop by resistance is what a plan predicts.</source>
        <translation>Warum der Träger nicht weiter geschoben wurde. Ein Ende durch Widerstand ist das, was ein Plan vorhersagt.</translation>
    </message>
    <message>
        <source>Stopped because of</source>
        <translation>Beendet wegen</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Intended mark reached</source>
        <translation>Vorgesehene Marke erreicht</translation>
    </message>
    <message>
        <source>Intended depth</source>
        <translation>Vorgesehene Tiefe</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Contacts outside</source>
        <translation>Kontakte außen</translation>
    </message>
    <message>
        <source>Days from surgery to CT</source>
        <translation>Tage von der OP bis zum CT</translation>
    </message>
    <message>
        <source>Lubricant</source>
        <translation>Gleitmittel</translation>
    </message>
    <message>
        <source>Lot of the array</source>
        <translation>Charge des Trägers</translation>
    </message>
    <message>
        <source>Contacts intended inside</source>
        <translation>Vorgesehene Kontakte innen</translation>
    </message>
    <message>
        <source>Length outside</source>
        <translation>Länge außen</translation>
    </message>
    <message>
        <source>Contact at first resistance</source>
        <translation>Kontakt beim ersten Widerstand</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Pull-backs</source>
        <translation>Rückzüge</translation>
    </message>
    <message>
        <source>Tilt of the approach</source>
        <translation>Neigung des Zugangs</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn of the approach</source>
        <translation>Drehung des Zugangs</translation>
    </message>
    <message>
        <source>%1 is “%2”, which is not a number; leave it empty if it is not known.</source>
        <translation>%1 ist „%2“, was keine Zahl ist; leer lassen, wenn es nicht bekannt ist.</translation>
    </message>
    <message>
        <source>%1 is %2; a whole number is expected.</source>
        <translation>%1 ist %2; erwartet wird eine ganze Zahl.</translation>
    </message>
    <message>
        <source>Day of the CT</source>
        <translation>Tag des CT</translation>
    </message>
    <message>
        <source>As the images state it; type it where they state none. With the days from surgery it tells which plans were made before surgery.</source>
        <translation>Wie die Bilder ihn angeben; tragen Sie ihn ein, wo sie keinen angeben. Mit den Tagen seit der Operation sagt er, welche Pläne vor der Operation erstellt wurden.</translation>
    </message>
    <message>
        <source>Day of the CT is “%1”; a day up to today is expected, such as 2026-11-20.</source>
        <translation>Tag des CT ist „%1“; erwartet wird ein Tag bis heute, etwa 2026-11-20.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::TopBar</name>
    <message>
        <source>Perilymph</source>
        <translation>Perilymph</translation>
    </message>
    <message>
        <source>Settings (Ctrl+,)</source>
        <translation>Einstellungen (Strg+,)</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>MODIFIED</source>
        <translation>GEÄNDERT</translation>
    </message>
    <message>
        <source>fault · no force</source>
        <translation>Fehler · keine Kraft</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>wird vorbereitet</translation>
    </message>
    <message>
        <source>replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Keyboard and mouse (F1)</source>
        <translation>Tastatur und Maus (F1)</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Tastatur und Maus</translation>
    </message>
    <message>
        <source>Differs from the preset: %1.</source>
        <translation>Weicht von der Vorlage ab: %1.</translation>
    </message>
    <message>
        <source>A recording is shown. No device is active.</source>
        <translation>Eine Aufzeichnung wird gezeigt. Kein Gerät ist aktiv.</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>%1, %2 samples per second</source>
        <translation>%1, %2 Abtastwerte pro Sekunde</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Remove the force of the device at once (Esc)</source>
        <translation>Kraft des Geräts sofort abschalten (Esc)</translation>
    </message>
    <message>
        <source>Stop: remove the force of the device</source>
        <translation>Stopp: Kraft des Geräts abschalten</translation>
    </message>
    <message>
        <source>stopped · no force</source>
        <translation>gestoppt · keine Kraft</translation>
    </message>
    <message>
        <source>%1. Press Start to continue.</source>
        <translation>%1. Zum Fortfahren „Start“ drücken.</translation>
    </message>
    <message>
        <source>ended · no force</source>
        <translation>beendet · keine Kraft</translation>
    </message>
    <message>
        <source>%1 (Alt+Home)</source>
        <translation>%1 (Alt+Pos1)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ValidatePage</name>
    <message>
        <source>Insertion %1 of %2</source>
        <translation>Insertion %1 von %2</translation>
    </message>
    <message>
        <source>Insertions</source>
        <translation>Insertionen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>insertions</source>
        <translation>Insertionen</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Building the cochlea…</source>
        <translation>Die Cochlea wird berechnet …</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Hält an …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>✓ met</source>
        <translation>✓ erfüllt</translation>
    </message>
    <message>
        <source>✗ missed</source>
        <translation>✗ verfehlt</translation>
    </message>
    <message>
        <source>Reproduce the published experiment</source>
        <translation>Veröffentlichten Versuch reproduzieren</translation>
    </message>
    <message>
        <source>Save curves as CSV, results as JSON and figures as SVG.</source>
        <translation>Kurven als CSV, Ergebnisse als JSON und Abbildungen als SVG speichern.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Save to folder</source>
        <translation>In Ordner speichern</translation>
    </message>
    <message>
        <source>%1 of %2 insertions completed, seed %3. Mean SD over travel %4 mN.</source>
        <translation>%1 von %2 Insertionen vollständig, Startwert %3. Mittlere SD über den Vorschub %4 mN.</translation>
    </message>
    <message>
        <source>Causes of the spread: insertion %1 of %2</source>
        <translation>Ursachen der Streuung: Insertion %1 von %2</translation>
    </message>
    <message>
        <source>Enter a whole number of insertions from %1 to %2.</source>
        <translation>Ganze Zahl von Insertionen von %1 bis %2 eingeben.</translation>
    </message>
    <message>
        <source>%1 of %2 criteria met</source>
        <translation>%1 von %2 Kriterien erfüllt</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) saved to %1.</source>
        <translation>
            <numerusform>%n Datei gespeichert in %1.</numerusform>
            <numerusform>%n Dateien gespeichert in %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Simulates repeated insertions with realistic variability in start position, alignment, array curvature and friction. Their mean is compared with the published forces. One force was used to calibrate the array; the others are predictions from one choice of each constant. A mean is met within 1.96 standard errors.</source>
        <translation>Simuliert wiederholte Insertionen mit realistischer Variabilität von Startposition, Ausrichtung, Krümmung des Trägers und Reibung. Ihr Mittelwert wird mit den veröffentlichten Kräften verglichen. Eine Kraft diente der Kalibrierung des Trägers; die anderen sind Vorhersagen mit je einer Wahl jeder Konstante. Ein Mittelwert ist getroffen, wenn er innerhalb von 1,96 Standardfehlern liegt.</translation>
    </message>
    <message>
        <source>Validate</source>
        <translation>Validierung</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ValidationWork</name>
    <message>
        <source>Canceled. No results were saved.</source>
        <translation>Abgebrochen. Keine Ergebnisse gespeichert.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::VersionQuestion</name>
    <message>
        <source>New version</source>
        <translation>Neue Version</translation>
    </message>
    <message>
        <source>Other code</source>
        <translation>Anderer Code</translation>
    </message>
    <message>
        <source>left</source>
        <translation>linke</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechte</translation>
    </message>
    <message>
        <source>%1 %2 exists.</source>
        <translation>%1 %2 gibt es schon.</translation>
    </message>
    <message>
        <source>%1 %2 exists, saved %3.</source>
        <translation>%1 %2 gibt es schon, gespeichert am %3.</translation>
    </message>
    <message>
        <source>saved, mm</source>
        <translation>gespeichert, mm</translation>
    </message>
    <message>
        <source>new, mm</source>
        <translation>neu, mm</translation>
    </message>
    <message>
        <source>difference, mm</source>
        <translation>Differenz, mm</translation>
    </message>
    <message>
        <source>± 95 %</source>
        <translation>± 95 %</translation>
    </message>
    <message>
        <source>Use this code</source>
        <translation>Diesen Code verwenden</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ViewMenu</name>
    <message>
        <source>View ▾</source>
        <translation>Ansicht ▾</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>2</source>
        <translation>2</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>3</source>
        <translation>3</translation>
    </message>
    <message>
        <source>4</source>
        <translation>4</translation>
    </message>
    <message>
        <source>Follow the tip</source>
        <translation>Der Spitze folgen</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>VIEWS</source>
        <translation>ANSICHTEN</translation>
    </message>
    <message>
        <source>One</source>
        <translation>Eine</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Strg+1</translation>
    </message>
    <message>
        <source>Two: picture and charts</source>
        <translation>Zwei: Bild und Kurven</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Strg+2</translation>
    </message>
    <message>
        <source>Four</source>
        <translation>Vier</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Strg+4</translation>
    </message>
    <message>
        <source>STEREO (G)</source>
        <translation>STEREO (G)</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Anaglyph, red and cyan</source>
        <translation>Anaglyphe, rot und cyan</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Interlaced</source>
        <translation>Zeilenweise</translation>
    </message>
    <message>
        <source>Quad-buffered</source>
        <translation>Vierfach gepuffert</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Balanced</source>
        <translation>Ausgewogen</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Voll</translation>
    </message>
    <message>
        <source>Quad-buffered: %1</source>
        <translation>Vierfach gepuffert: %1</translation>
    </message>
    <message>
        <source>SOUND</source>
        <translation>TON</translation>
    </message>
    <message>
        <source>Camera, layout, stereo and rendering quality</source>
        <translation>Kamera, Anordnung, Stereo und Darstellungsqualität</translation>
    </message>
    <message>
        <source>CAMERA</source>
        <translation>KAMERA</translation>
    </message>
    <message>
        <source>Surgeon’s view, rotated 110°</source>
        <translation>Sicht des Operateurs, um 110° gedreht</translation>
    </message>
    <message>
        <source>Through the opening</source>
        <translation>Durch die Öffnung</translation>
    </message>
    <message>
        <source>Basal-turn section</source>
        <translation>Schnitt der Basalwindung</translation>
    </message>
    <message>
        <source>RENDERING</source>
        <translation>DARSTELLUNG</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>searching for an audio device</source>
        <translation>Audiogerät wird gesucht</translation>
    </message>
    <message>
        <source>Force sound: one octave per 100 mN</source>
        <translation>Kraftton: eine Oktave je 100 mN</translation>
    </message>
    <message>
        <source>Force sound: %1</source>
        <translation>Kraftton: %1</translation>
    </message>
    <message>
        <source>Plays a tone while the insertion force is 5 mN or more: 220 Hz at zero force, one octave higher per 100 mN.</source>
        <translation>Gibt einen Ton aus, solange die Insertionskraft mindestens 5 mN beträgt: 220 Hz ohne Kraft, eine Oktave höher je 100 mN.</translation>
    </message>
    <message>
        <source>Quad-buffered, separate window</source>
        <translation>Vierfach gepuffert, eigenes Fenster</translation>
    </message>
    <message>
        <source>Stereo view through the left and right buffers of the display; Esc closes it.</source>
        <translation>Stereoansicht über linken und rechten Puffer der Anzeige; Esc schließt sie.</translation>
    </message>
</context>
</TS>
