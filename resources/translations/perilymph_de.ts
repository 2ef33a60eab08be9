<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_US">
<context>
    <name>Display</name>
    <message>
        <source>this display has no buffers for two eyes</source>
        <translation>dieser Bildschirm hat keine Puffer für zwei Augen</translation>
    </message>
</context>
<context>
    <name>KioskTurn</name>
    <message>
        <source>below the peaks measured in patients</source>
        <translation>unter den an Patienten gemessenen Spitzen</translation>
    </message>
    <message>
        <source>above the peaks measured in patients</source>
        <translation>über den an Patienten gemessenen Spitzen</translation>
    </message>
    <message>
        <source>among the peaks measured in patients</source>
        <translation>unter den an Patienten gemessenen Spitzen gelegen</translation>
    </message>
    <message>
        <source>Measured in patients: peaks of %1 to %2 mN (Rau et al. 2024). A comparison, not a judgment of safety.</source>
        <translation>An Patienten gemessen: Spitzen von %1 bis %2 mN (Rau et al. 2024). Ein Vergleich, kein Urteil über Sicherheit.</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>For research and training use. Not a medical device.</source>
        <translation>Für Forschung und Übung. Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Report of an insertion</source>
        <translation>Bericht einer Einführung</translation>
    </message>
</context>
<context>
    <name>perilymph::gui</name>
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
        <source>138 cochleae, Pietsch et al. 2017, Sci Rep.</source>
        <translation>138 Cochleae, Pietsch et al. 2017, Sci Rep.</translation>
    </message>
    <message>
        <source>Sections vary by 9 to 15 % (Avci et al. 2014) about a mean of %1 mm (Froehlich et al. 2024, n = 15).</source>
        <translation>Schnitte schwanken um 9 bis 15 % (Avci et al. 2014) um ein Mittel von %1 mm (Froehlich et al. 2024, n = 15).</translation>
    </message>
    <message>
        <source>Organ of Corti 33.13 ± 2.11 mm, n = 9 (Stakhovskaya et al. 2007). The published model has 35.58 mm.</source>
        <translation>Corti-Organ 33,13 ± 2,11 mm, n = 9 (Stakhovskaya et al. 2007). Das veröffentlichte Modell hat 35,58 mm.</translation>
    </message>
    <message>
        <source>Definitions of H differ, so only limits are given.</source>
        <translation>H wird verschieden definiert, daher nur Grenzen.</translation>
    </message>
    <message>
        <source>%1 mN</source>
        <translation>%1 mN</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>%1, %2 ear</source>
        <translation>%1, %2es Ohr</translation>
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
        <source>Array</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>%1 (UTC), by %2</source>
        <translation>%1 (UTC), von %2</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>greatest of %1 recorded ticks</source>
        <translation>größte von %1 aufgezeichneten Takten</translation>
    </message>
    <message>
        <source>Peak force on the hand</source>
        <translation>Spitzenkraft an der Hand</translation>
    </message>
    <message>
        <source>%1 at %2 of travel, %3 deep</source>
        <translation>%1 bei %2 Weg, %3 tief</translation>
    </message>
    <message>
        <source>axial, %1</source>
        <translation>axial, %1</translation>
    </message>
    <message>
        <source>Greatest wall force</source>
        <translation>Größte Wandkraft</translation>
    </message>
    <message>
        <source>normal to the wall, of one node; %1</source>
        <translation>normal zur Wand, eines Knotens; %1</translation>
    </message>
    <message>
        <source>Greatest force on the basilar membrane</source>
        <translation>Größte Kraft auf die Basilarmembran</translation>
    </message>
    <message>
        <source>Work of the hand</source>
        <translation>Arbeit der Hand</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1 mJ</translation>
    </message>
    <message>
        <source>force over the way of the base, trapezoids over ticks</source>
        <translation>Kraft über den Weg der Basis, Trapeze über Takte</translation>
    </message>
    <message>
        <source>Deepest</source>
        <translation>Größte Tiefe</translation>
    </message>
    <message>
        <source>length of array past the opening</source>
        <translation>Länge des Trägers hinter der Öffnung</translation>
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
        <source>depth; angle of the tip from the round window</source>
        <translation>Tiefe; Winkel der Spitze ab rundem Fenster</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>since the array began to move, pauses included</source>
        <translation>seit der Träger sich bewegt, mit Pausen</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Umkehrungen</translation>
    </message>
    <message>
        <source>a way back of 0.1 mm or more</source>
        <translation>ein Rückweg von 0,1 mm oder mehr</translation>
    </message>
    <message>
        <source>Peak at the basal turn</source>
        <translation>Spitze an der Basalwindung</translation>
    </message>
    <message>
        <source>%1 at %2 of travel</source>
        <translation>%1 bei %2 Weg</translation>
    </message>
    <message>
        <source>of the curve smoothed over 0.5 mm</source>
        <translation>der über 0,5 mm geglätteten Kurve</translation>
    </message>
    <message>
        <source>Ticks not settled</source>
        <translation>Nicht gelöste Takte</translation>
    </message>
    <message>
        <source>the solver left more than its tolerance</source>
        <translation>der Löser ließ mehr als seine Toleranz</translation>
    </message>
    <message>
        <source>%1 %: %2</source>
        <translation>%1 %: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 of 100, the mean of four criteria. It knows no trauma.</source>
        <translation>%1 von 100, das Mittel von vier Kriterien. Es weiß nichts von Verletzung.</translation>
    </message>
    <message>
        <source>The array, and where its values come from:</source>
        <translation>Der Träger, und woher seine Werte kommen:</translation>
    </message>
    <message>
        <source>Forces are computed by a model, not measured in an ear.</source>
        <translation>Kräfte sind von einem Modell berechnet, nicht in einem Ohr gemessen.</translation>
    </message>
    <message>
        <source>The array is a model after published data, no labeling of the product.</source>
        <translation>Der Träger ist ein Modell nach veröffentlichten Daten, keine Angabe zum Produkt.</translation>
    </message>
    <message>
        <source>No number here says whether an insertion is harmless; thresholds of trauma differ between ears and are not known for the force on the hand.</source>
        <translation>Keine Zahl hier sagt, ob eine Einführung schadet; Schwellen der Verletzung sind von Ohr zu Ohr verschieden und für die Kraft an der Hand nicht bekannt.</translation>
    </message>
    <message>
        <source>The published experiment is drawn as its printed values; nothing is known between them.</source>
        <translation>Der veröffentlichte Versuch ist mit seinen gedruckten Werten gezeichnet; dazwischen ist nichts bekannt.</translation>
    </message>
    <message>
        <source>%1 ticks were lost while recording.</source>
        <translation>%1 Takte gingen beim Aufzeichnen verloren.</translation>
    </message>
    <message>
        <source>%1 ticks computed again, every bit the same</source>
        <translation>%1 Takte neu berechnet, jedes Bit gleich</translation>
    </message>
    <message>
        <source>differs from tick %1 on, in %2</source>
        <translation>weicht ab Takt %1 ab, in %2</translation>
    </message>
    <message>
        <source>could not be compared</source>
        <translation>ließ sich nicht vergleichen</translation>
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
        <translation>Abspielen</translation>
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
        <source>fingerprint of cochlea, array and laws</source>
        <translation>Fingerabdruck von Cochlea, Träger und Gesetzen</translation>
    </message>
    <message>
        <source>Array&apos;s file</source>
        <translation>Datei des Trägers</translation>
    </message>
    <message>
        <source>fingerprint</source>
        <translation>Fingerabdruck</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>Report of an insertion</source>
        <translation>Bericht einer Einführung</translation>
    </message>
    <message>
        <source>Perilymph, for research and training use. Not a medical device; no patient may be treated by what it shows.</source>
        <translation>Perilymph, für Forschung und Übung. Kein Medizinprodukt; kein Patient darf nach dem behandelt werden, was es zeigt.</translation>
    </message>
    <message>
        <source>Along the modiolus, to scale; the tip %1 mm past the opening.</source>
        <translation>Entlang des Modiolus, maßstäblich; die Spitze %1 mm hinter der Öffnung.</translation>
    </message>
    <message>
        <source>How it was done</source>
        <translation>Wie sie ausgeführt wurde</translation>
    </message>
    <message>
        <source>What it was computed from</source>
        <translation>Woraus sie berechnet wurde</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>How to know it again</source>
        <translation>Woran sie wiederzuerkennen ist</translation>
    </message>
    <message>
        <source>In numbers</source>
        <translation>In Zahlen</translation>
    </message>
    <message>
        <source>Force over travel</source>
        <translation>Kraft über Weg</translation>
    </message>
    <message>
        <source>The array at its deepest place</source>
        <translation>Der Träger an seiner tiefsten Stelle</translation>
    </message>
    <message>
        <source>travel, mm</source>
        <translation>Weg, mm</translation>
    </message>
    <message>
        <source>axial force, N</source>
        <translation>Axialkraft, N</translation>
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
        <translation>diese Einführung</translation>
    </message>
    <message>
        <source>felt by surgeons %1 mN</source>
        <translation>für Operateure spürbar %1 mN</translation>
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
        <source>the tip is outside</source>
        <translation>die Spitze ist außerhalb</translation>
    </message>
    <message>
        <source>no contact is inside yet</source>
        <translation>noch kein Kontakt ist innen</translation>
    </message>
    <message>
        <source>mean %1 mm, %2 inside</source>
        <translation>Mittel %1 mm, %2 innen</translation>
    </message>
    <message>
        <source>wall force, mN per mm</source>
        <translation>Wandkraft, mN je mm</translation>
    </message>
    <message>
        <source>normal force, %1 mm for %2 mN</source>
        <translation>Normalkraft, %1 mm für %2 mN</translation>
    </message>
    <message>
        <source>friction, × %1</source>
        <translation>Reibung, × %1</translation>
    </message>
    <message>
        <source>published experiment, printed values ± SD</source>
        <translation>veröffentlichter Versuch, gedruckte Werte ± SD</translation>
    </message>
    <message>
        <source>angle from round window, °; width, mm</source>
        <translation>Winkel ab rundem Fenster, °; Breite, mm</translation>
    </message>
    <message>
        <source>Press Start, then hold the device’s button and push.</source>
        <translation>Start drücken, dann den Knopf des Geräts halten und schieben.</translation>
    </message>
    <message>
        <source>Coupling %1 N/m, softer than asked: Devices (H).</source>
        <translation>Kopplung %1 N/m, weicher als gewünscht: Geräte (H).</translation>
    </message>
    <message>
        <source>Hold the device’s button: the array follows the hand.</source>
        <translation>Knopf des Geräts halten: Der Träger folgt der Hand.</translation>
    </message>
    <message>
        <source>Array held. Letting go of the button lets it rest.</source>
        <translation>Träger gehalten. Loslassen lässt ihn ruhen.</translation>
    </message>
    <message>
        <source>NOT recording</source>
        <translation>KEINE Aufzeichnung</translation>
    </message>
    <message>
        <source>recording, %1 ticks lost</source>
        <translation>Aufzeichnung, %1 Takte verloren</translation>
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
        <source>late ticks: %1</source>
        <translation>verspätete Takte: %1</translation>
    </message>
    <message>
        <source>%1 overruns</source>
        <translation>%1 zu lang</translation>
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
        <source>The hand stopped answering.</source>
        <translation>Die Hand antwortet nicht mehr.</translation>
    </message>
    <message>
        <source>The computed motion left every bound.</source>
        <translation>Die berechnete Bewegung verließ jede Grenze.</translation>
    </message>
    <message>
        <source>The insertion was stopped.</source>
        <translation>Die Einführung wurde angehalten.</translation>
    </message>
    <message>
        <source> The force is off and the array rests. Press Reset to start again.</source>
        <translation> Die Kraft ist aus, und der Träger ruht. Mit „Neu“ beginnt es von vorn.</translation>
    </message>
    <message>
        <source>This insertion is not being recorded: %1</source>
        <translation>Diese Einführung wird nicht aufgezeichnet: %1</translation>
    </message>
    <message>
        <source>Full depth. Withdraw or Reset.</source>
        <translation>Volle Tiefe. Zurückziehen oder Neu.</translation>
    </message>
    <message>
        <source>The array is out. Reset to insert again.</source>
        <translation>Der Träger ist draußen. Neu, um wieder einzuführen.</translation>
    </message>
    <message>
        <source>Press Start, then hold Space and turn the wheel.</source>
        <translation>Start drücken, dann Leertaste halten und am Rad drehen.</translation>
    </message>
    <message>
        <source>Hold Space, then turn the wheel or press Down.</source>
        <translation>Leertaste halten, dann am Rad drehen oder Ab drücken.</translation>
    </message>
    <message>
        <source>Array held. Wheel or Down advances, Up withdraws.</source>
        <translation>Träger gehalten. Rad oder Ab schiebt vor, Auf zieht zurück.</translation>
    </message>
    <message>
        <source>Building the cochlea; then the insertion starts…</source>
        <translation>Die Cochlea wird gebaut; danach beginnt die Einführung …</translation>
    </message>
    <message>
        <source>Building the cochlea…</source>
        <translation>Die Cochlea wird gebaut …</translation>
    </message>
    <message>
        <source>no stylet</source>
        <translation>kein Stilett</translation>
    </message>
    <message>
        <source>%1 mm out</source>
        <translation>%1 mm heraus</translation>
    </message>
    <message>
        <source>in</source>
        <translation>drin</translation>
    </message>
    <message>
        <source>%1 ms there and back</source>
        <translation>%1 ms hin und zurück</translation>
    </message>
    <message>
        <source>at most %1 ms there and back</source>
        <translation>höchstens %1 ms hin und zurück</translation>
    </message>
    <message>
        <source>device gone</source>
        <translation>Gerät weg</translation>
    </message>
    <message>
        <source>device %1/s, jitter %2 ms</source>
        <translation>Gerät %1/s, Schwankung %2 ms</translation>
    </message>
    <message>
        <source>below the %1 mN that surgeons feel</source>
        <translation>unter den %1 mN, die Operateure fühlen</translation>
    </message>
    <message>
        <source>felt by surgeons, above %1 mN</source>
        <translation>fühlbar für Operateure, über %1 mN</translation>
    </message>
    <message>
        <source>felt; like peaks in patients, %1 to %2 mN</source>
        <translation>fühlbar; wie Spitzen an Patienten, %1 bis %2 mN</translation>
    </message>
    <message>
        <source>felt; above the peaks in patients, %1 mN</source>
        <translation>fühlbar; über den Spitzen an Patienten, %1 mN</translation>
    </message>
    <message>
        <source>on the partition %1 mN</source>
        <translation>auf die Trennwand %1 mN</translation>
    </message>
    <message>
        <source>on the partition %1 mN; it ruptures at %2 to %3 mN</source>
        <translation>auf die Trennwand %1 mN; sie reißt bei %2 bis %3 mN</translation>
    </message>
    <message>
        <source>on the partition %1 mN: it ruptures at %2 to %3 mN</source>
        <translation>auf die Trennwand %1 mN: Sie reißt bei %2 bis %3 mN</translation>
    </message>
    <message>
        <source>start or pause; hold the array with mouse and keyboard</source>
        <translation>starten oder anhalten; Träger halten mit Maus und Tastatur</translation>
    </message>
    <message>
        <source>advance or withdraw the array while it is held</source>
        <translation>Träger vor oder zurück, solange er gehalten wird</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>dasselbe</translation>
    </message>
    <message>
        <source>withdraw</source>
        <translation>zurückziehen</translation>
    </message>
    <message>
        <source>reset: a fresh insertion and recording</source>
        <translation>neu: eine frische Einführung und Aufzeichnung</translation>
    </message>
    <message>
        <source>undo and redo a change of the setup</source>
        <translation>eine Änderung des Aufbaus zurücknehmen und wiederholen</translation>
    </message>
    <message>
        <source>pull the stylet</source>
        <translation>Stilett ziehen</translation>
    </message>
    <message>
        <source>surgeon’s view, down the opening, overview, section</source>
        <translation>Sicht des Operateurs, in die Öffnung, Übersicht, Schnitt</translation>
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
        <source>turn the model</source>
        <translation>Modell drehen</translation>
    </message>
    <message>
        <source>move the model</source>
        <translation>Modell verschieben</translation>
    </message>
    <message>
        <source>magnify</source>
        <translation>vergrößern</translation>
    </message>
    <message>
        <source>Drag; Shift+drag</source>
        <translation>Ziehen; Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>turn the model; move it</source>
        <translation>Modell drehen; verschieben</translation>
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
        <translation>abspielen oder anhalten; zurück zur Einführung</translation>
    </message>
    <message>
        <source>Left, Right; with Shift</source>
        <translation>Links, Rechts; mit Umschalt</translation>
    </message>
    <message>
        <source>step by 1 tick; by 100</source>
        <translation>um 1 Takt; um 100</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Pos1, Ende</translation>
    </message>
    <message>
        <source>to the beginning, to the end</source>
        <translation>zum Anfang, zum Ende</translation>
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
        <source>one, two or four views in turn</source>
        <translation>eine, zwei oder vier Ansichten im Wechsel</translation>
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
        <source>enlarge a view, and back</source>
        <translation>eine Ansicht vergrößern und zurück</translation>
    </message>
    <message>
        <source>start over: the first screen</source>
        <translation>von vorn: die erste Seite</translation>
    </message>
    <message>
        <source>insert, compare, validate, sessions</source>
        <translation>Einführen, Vergleichen, Prüfen, Sitzungen</translation>
    </message>
    <message>
        <source>devices: which there are, and how the hand is doing</source>
        <translation>Geräte: welche es gibt und wie es der Hand geht</translation>
    </message>
    <message>
        <source>hide or show the panel</source>
        <translation>das Feld links verbergen oder zeigen</translation>
    </message>
    <message>
        <source>out of the panel’s fields</source>
        <translation>aus den Feldern links heraus</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>full screen, and back</source>
        <translation>ganzer Bildschirm und zurück</translation>
    </message>
    <message>
        <source>keep a picture of the window</source>
        <translation>ein Bild des Fensters behalten</translation>
    </message>
    <message>
        <source>this list</source>
        <translation>diese Liste</translation>
    </message>
    <message>
        <source>user guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>leave what lies on the page; let go of the array</source>
        <translation>verlassen, was auf der Seite liegt; Träger loslassen</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>to the next button or field</source>
        <translation>zum nächsten Knopf oder Feld</translation>
    </message>
    <message>
        <source>The picture is kept: %1</source>
        <translation>Das Bild liegt hier: %1</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::Application</name>
    <message>
        <source>The window could not do that: %1</source>
        <translation>Das Fenster konnte das nicht: %1</translation>
    </message>
    <message>
        <source>The window could not do that, and does not know why.</source>
        <translation>Das Fenster konnte das nicht und weiß nicht, warum.</translation>
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
        <source>A stylet stays in until full depth.</source>
        <translation>Ein Stilett bleibt bis zur vollen Tiefe drin.</translation>
    </message>
    <message>
        <source>Advance off stylet</source>
        <translation>Vom Stilett schieben</translation>
    </message>
    <message>
        <source>The stylet is held still at its depth and the array pushed off it.</source>
        <translation>Das Stilett wird in seiner Tiefe gehalten und der Träger davon geschoben.</translation>
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
        <source>Of the scripted hand.</source>
        <translation>Der Hand des Skripts.</translation>
    </message>
    <message>
        <source>Full depth at</source>
        <translation>Volle Tiefe bei</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Travel at which the insertion is complete.</source>
        <translation>Weg, bei dem die Einführung vollendet ist.</translation>
    </message>
    <message>
        <source>speed %1 mm/s</source>
        <translation>Tempo %1 mm/s</translation>
    </message>
    <message>
        <source>full depth at %1 mm</source>
        <translation>volle Tiefe bei %1 mm</translation>
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
        <source>Coefficients of dry friction between array and wall: starting, dynamic.</source>
        <translation>Beiwerte trockener Reibung zwischen Träger und Wand: Haften, Gleiten.</translation>
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
        <source>A drilled round opening; ribs meet its edge.</source>
        <translation>Eine gebohrte runde Öffnung; Rippen treffen auf ihren Rand.</translation>
    </message>
    <message>
        <source>Round window</source>
        <translation>Rundes Fenster</translation>
    </message>
    <message>
        <source>1.37 by 1.91 mm, the mean of 20 (Benha Med J 2018;35:246).</source>
        <translation>1,37 mal 1,91 mm, das Mittel von 20 (Benha Med J 2018;35:246).</translation>
    </message>
    <message>
        <source>No rim</source>
        <translation>Kein Rand</translation>
    </message>
    <message>
        <source>Nothing but the wall.</source>
        <translation>Nichts als die Wand.</translation>
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
        <source>The array as an elastic rod of nodes.</source>
        <translation>Der Träger als elastischer Stab aus Knoten.</translation>
    </message>
    <message>
        <source>Point set</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>The published model: a few spheres on springs, limits and all.</source>
        <translation>Das veröffentlichte Modell: einige Kugeln an Federn, mit allen Grenzen.</translation>
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
        <source>Of the rod, or points of the set.</source>
        <translation>Des Stabs, oder Punkte.</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 Knoten</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>abgeglichen</translation>
    </message>
    <message>
        <source>Stiffness and curvature fitted to printed forces: %1.</source>
        <translation>Steifigkeit und Krümmung an gedruckte Kräfte angepasst: %1.</translation>
    </message>
    <message>
        <source>no depth is known to hold the stylet at</source>
        <translation>keine Tiefe bekannt, das Stilett zu halten</translation>
    </message>
    <message>
        <source>this array has no stylet</source>
        <translation>dieser Träger hat kein Stilett</translation>
    </message>
    <message>
        <source>starting %1 · dynamic %2</source>
        <translation>Haften %1 · Gleiten %2</translation>
    </message>
    <message>
        <source>Full depth</source>
        <translation>Volle Tiefe</translation>
    </message>
    <message>
        <source>%1 %2. Correct it, or press Esc in its field.</source>
        <translation>%1 %2. Berichtigen, oder Esc im Feld drücken.</translation>
    </message>
    <message>
        <source>%1 to %2 by speed</source>
        <translation>%1 bis %2, je Tempo</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::BoardView</name>
    <message>
        <source>Today’s gentlest</source>
        <translation>Heute am sanftesten</translation>
    </message>
    <message>
        <source>lowest peak force at full depth</source>
        <translation>kleinste Spitzenkraft bei voller Tiefe</translation>
    </message>
    <message>
        <source>Nobody has been to full depth yet. Be the first.</source>
        <translation>Noch war niemand bei voller Tiefe. Seien Sie die Ersten.</translation>
    </message>
    <message>
        <source>%1 mN</source>
        <translation>%1 mN</translation>
    </message>
    <message>
        <source>you, just now</source>
        <translation>Sie, gerade eben</translation>
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
        <translation>Neu</translation>
    </message>
    <message>
        <source>Start or pause the insertion (Space)</source>
        <translation>Einführung starten oder anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Pull the array out again (Backspace)</source>
        <translation>Den Träger wieder herausziehen (Rücktaste)</translation>
    </message>
    <message>
        <source>Start over with a new recording (Ctrl+R)</source>
        <translation>Neu beginnen, mit eigener Aufzeichnung (Strg+R)</translation>
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
        <source>The cochlea is being built; then the insertion can start.</source>
        <translation>Die Cochlea wird gebaut; danach kann die Einführung beginnen.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::BuildingNote</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Go back to the cochlea and the array that are shown (Esc)</source>
        <translation>Zurück zur Cochlea und zum Träger, die zu sehen sind (Esc)</translation>
    </message>
    <message>
        <source>Building the cochlea… %1 s</source>
        <translation>Die Cochlea wird gebaut … %1 s</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ComparePage</name>
    <message>
        <source>Insertions side by side</source>
        <translation>Einführungen nebeneinander</translation>
    </message>
    <message>
        <source>Choose two or more on the page Sessions and press Compare: their forces over travel stand here on common axes, with the printed forces of the published experiment.</source>
        <translation>Wählen Sie auf der Seite Sitzungen zwei oder mehr und drücken Sie Vergleichen: Hier stehen dann ihre Kräfte über dem Weg auf gemeinsamen Achsen, mit den gedruckten Kräften des veröffentlichten Versuchs.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Ausgeben …</translation>
    </message>
    <message>
        <source>Table and curves as CSV, the figure as SVG and PNG, into a folder.</source>
        <translation>Tabelle und Kurven als CSV, das Bild als SVG und PNG, in einen Ordner.</translation>
    </message>
    <message>
        <source>○  published experiment, printed values ± SD</source>
        <translation>○  veröffentlichter Versuch, gedruckte Werte ± SD</translation>
    </message>
    <message>
        <source>Force over travel</source>
        <translation>Kraft über Weg</translation>
    </message>
    <message>
        <source>The insertions in numbers</source>
        <translation>Die Einführungen in Zahlen</translation>
    </message>
    <message>
        <source>Insertion</source>
        <translation>Einführung</translation>
    </message>
    <message>
        <source>At the cursor</source>
        <translation>Am Zeiger</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>at depth</source>
        <translation>bei Tiefe</translation>
    </message>
    <message>
        <source>Work of the hand</source>
        <translation>Arbeit der Hand</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Umkehrungen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Final angle</source>
        <translation>Winkel am Ende</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Wertung</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n recording(s)…</source>
        <translation>
            <numerusform>Eine Aufzeichnung wird gelesen …</numerusform>
            <numerusform>%n Aufzeichnungen werden gelesen …</numerusform>
        </translation>
    </message>
    <message>
        <source>Esc ends it.</source>
        <translation>Esc beendet es.</translation>
    </message>
    <message>
        <source>They cannot be compared</source>
        <translation>Sie lassen sich nicht vergleichen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Choose two or more on the page Sessions and press Compare.</source>
        <translation>Wählen Sie auf der Seite Sitzungen zwei oder mehr und drücken Sie Vergleichen.</translation>
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
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>At %1 mm</source>
        <translation>Bei %1 mm</translation>
    </message>
    <message>
        <source>Score of %1. How it was done, not what it did to the ear: it knows no trauma.</source>
        <translation>Wertung von %1. Wie es getan wurde, nicht was es im Ohr tat: Sie weiß nichts von Verletzung.</translation>
    </message>
    <message>
        <source>%1 %2 %: %3. Band: %4. Source: %5.</source>
        <translation>%1 %2 %: %3. Band: %4. Quelle: %5.</translation>
    </message>
    <message>
        <source>Folder for table, curves and figure</source>
        <translation>Ordner für Tabelle, Kurven und Bild</translation>
    </message>
    <message>
        <source>Four files are in %1.</source>
        <translation>Vier Dateien liegen in %1.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ComparisonPlot</name>
    <message>
        <source>Axial force over travel</source>
        <translation>Axialkraft über Weg</translation>
    </message>
    <message>
        <source>travel of the tip from its start, mm</source>
        <translation>Weg der Spitze ab Beginn, mm</translation>
    </message>
    <message>
        <source>axial force on the hand, N</source>
        <translation>Axialkraft an der Hand, N</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
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
        <source>%1 · %2 · a report every %3 ms</source>
        <translation>%1 · %2 · ein Bericht alle %3 ms</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Close (H)</source>
        <translation>Schließen (H)</translation>
    </message>
    <message>
        <source>No HID device is plugged in.</source>
        <translation>Kein HID-Gerät ist angeschlossen.</translation>
    </message>
    <message>
        <source>Hands that need no hardware: the script, and mouse and keyboard.</source>
        <translation>Hände ohne Gerät: das Skript sowie Maus und Tastatur.</translation>
    </message>
    <message>
        <source>Use as hand</source>
        <translation>Als Hand nehmen</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>The hand: %1</source>
        <translation>Die Hand: %1</translation>
    </message>
    <message>
        <source>Loop: %1 ticks a second, %2 late, %3 overruns, 99 % below %4 ms.</source>
        <translation>Schleife: %1 Takte je Sekunde, %2 verspätet, %3 zu lang, 99 % unter %4 ms.</translation>
    </message>
    <message>
        <source>Reports: %1 a second; median %2 ms apart, 99 % below %3 ms, longest %4 ms.</source>
        <translation>Berichte: %1 je Sekunde; Median %2 ms Abstand, 99 % unter %3 ms, längster %4 ms.</translation>
    </message>
    <message>
        <source>%1 lost, %2 repeated, %3 old, %4 not understood.</source>
        <translation>%1 verloren, %2 wiederholt, %3 veraltet, %4 nicht verstanden.</translation>
    </message>
    <message>
        <source>It needs no hardware and feels no force.</source>
        <translation>Sie braucht kein Gerät und fühlt keine Kraft.</translation>
    </message>
    <message>
        <source>A force is taken in %1 ms, 99 % below %2 ms; %3.</source>
        <translation>Eine Kraft wird in %1 ms abgenommen, 99 % unter %2 ms; %3.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::FlatViews</name>
    <message>
        <source>Unrolled scala tympani</source>
        <translation>Abgerollte Scala tympani</translation>
    </message>
    <message>
        <source>angle from round window; width, mm</source>
        <translation>Winkel ab rundem Fenster; Breite, mm</translation>
    </message>
    <message>
        <source>The scala seen along the modiolus and rolled out. Bars: normal force of the wall on each millimeter of array; rings: forces of floor and roof.</source>
        <translation>Die Skala entlang des Modiolus gesehen und abgerollt. Balken: Normalkraft der Wand je Millimeter Träger; Ringe: Kräfte von Boden und Dach.</translation>
    </message>
    <message>
        <source>Section at the tip</source>
        <translation>Schnitt an der Spitze</translation>
    </message>
    <message>
        <source>The half-plane through the modiolar axis at the tip, to scale; its angle counts from the round window. The arrow is the wall’s normal force on the last millimeter of array. Where the wall yields, the array reaches past its line.</source>
        <translation>Die Halbebene durch die Modiolusachse an der Spitze, maßstäblich; ihr Winkel zählt ab dem runden Fenster. Der Pfeil ist die Normalkraft der Wand auf den letzten Millimeter Träger. Wo die Wand nachgibt, reicht der Träger über ihre Linie.</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>to modiolus, mm</source>
        <translation>zum Modiolus, mm</translation>
    </message>
    <message>
        <source>From the center line of the array at each contact, 1 at the tip, to the inner wall on the way to the modiolar axis.</source>
        <translation>Von der Mittellinie des Trägers an jedem Kontakt, 1 an der Spitze, zur Innenwand auf dem Weg zur Modiolusachse.</translation>
    </message>
    <message>
        <source>at %1°</source>
        <translation>bei %1°</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ForceCharts</name>
    <message>
        <source>Force over travel</source>
        <translation>Kraft über Weg</translation>
    </message>
    <message>
        <source>axial, N</source>
        <translation>axial, N</translation>
    </message>
    <message>
        <source>Force components</source>
        <translation>Kraftkomponenten</translation>
    </message>
    <message>
        <source>last 5 s, mN</source>
        <translation>letzte 5 s, mN</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ForceLabel</name>
    <message>
        <source>Felt: median of ten otologic surgeons, %1 mN (Kratchman 2016, Audiol Neurotol 21:244).</source>
        <translation>Fühlbar: Median von zehn Ohrchirurgen, %1 mN (Kratchman 2016, Audiol Neurotol 21:244).</translation>
    </message>
    <message>
        <source>The force on the partition is the sum of what the whole array presses normal to it; a rupture was measured under one point. No force is known to do no harm: trauma may occur below these forces (Mirsalehi 2017).</source>
        <translation>Die Kraft auf die Trennwand ist die Summe dessen, was der ganze Träger normal auf sie drückt; ein Riss wurde unter einem Punkt gemessen. Von keiner Kraft ist bekannt, dass sie nicht schadet: Verletzungen kommen auch unter diesen Kräften vor (Mirsalehi 2017).</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ForceSound</name>
    <message>
        <source>no sound output was found</source>
        <translation>keine Tonausgabe gefunden</translation>
    </message>
    <message>
        <source>the sound output does not take 16 bit at 44.1 kHz</source>
        <translation>die Tonausgabe nimmt keine 16 Bit bei 44,1 kHz</translation>
    </message>
    <message>
        <source>this build was made without sound</source>
        <translation>ohne Ton gebaut</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::GuideSheet</name>
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
        <source>The guide is not installed. It stands in the folder resources/guide of the source.</source>
        <translation>Das Handbuch ist nicht installiert. Es steht im Ordner resources/guide der Quellen.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::HandSection</name>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Scripted insertion</source>
        <translation>Nach Skript</translation>
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
        <source>Pull stylet (S)</source>
        <translation>Stilett ziehen (S)</translation>
    </message>
    <message>
        <source>Force shown</source>
        <translation>Kraft gezeigt</translation>
    </message>
    <message>
        <source>times</source>
        <translation>mal</translation>
    </message>
    <message>
        <source>Force at the hand’s device over the physical force. Script and mouse feel none.</source>
        <translation>Kraft am Gerät über der physikalischen Kraft. Skript und Maus fühlen keine.</translation>
    </message>
    <message>
        <source>Constant speed in, constant speed out.</source>
        <translation>Mit festem Tempo hinein und heraus.</translation>
    </message>
    <message>
        <source>The wheel or the up and down keys move the array while it is held.</source>
        <translation>Rad oder Auf und Ab bewegen den Träger, solange er gehalten wird.</translation>
    </message>
    <message>
        <source>Which devices there are, and which one may be the hand (H).</source>
        <translation>Welche Geräte es gibt und welches die Hand sein kann (H).</translation>
    </message>
    <message>
        <source>force shown %1 times</source>
        <translation>Kraft %1-mal gezeigt</translation>
    </message>
    <message>
        <source>The array follows the wheel only while this is pressed or Space is down.</source>
        <translation>Der Träger folgt dem Rad nur, solange dies oder die Leertaste gedrückt ist.</translation>
    </message>
    <message>
        <source>Stylet</source>
        <translation>Stilett</translation>
    </message>
    <message>
        <source>Force shown %1. Correct it, or press Esc in its field.</source>
        <translation>Kraft gezeigt %1. Berichtigen, oder Esc im Feld drücken.</translation>
    </message>
    <message>
        <source>Array held</source>
        <translation>Träger gehalten</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::InsertionViews</name>
    <message>
        <source>not on this display</source>
        <translation>nicht auf diesem Bildschirm</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::KeyList</name>
    <message>
        <source>Insertion</source>
        <translation>Einführung</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Three walks through the workstation, step by step (Shift+F1)</source>
        <translation>Drei Rundgänge durch den Arbeitsplatz, Schritt für Schritt (Umschalt+F1)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::KioskScreen</name>
    <message>
        <source>A simulation for research and training; not a medical device.</source>
        <translation>Eine Simulation für Forschung und Übung; kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Touch anywhere to try it yourself</source>
        <translation>Berühren und selbst versuchen</translation>
    </message>
    <message>
        <source>Hold to pull back</source>
        <translation>Halten: zurück</translation>
    </message>
    <message>
        <source>Use the handle</source>
        <translation>Mit dem Griff</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>Von vorn</translation>
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
        <source>Use the screen</source>
        <translation>Am Bildschirm</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::KioskWindow</name>
    <message>
        <source>A cochlear implant gives hearing back by an electrode array in the inner ear. A surgeon pushes it in by hand, through an opening of a millimeter or two.</source>
        <translation>Ein Cochlea-Implantat gibt Gehör zurück, durch einen Elektrodenträger im Innenohr. Von Hand wird er eingeführt, durch eine Öffnung von ein bis zwei Millimetern.</translation>
    </message>
    <message>
        <source>The cochlea winds up like a snail’s shell. The array has to follow it without pressing on the delicate membrane along its way.</source>
        <translation>Die Cochlea windet sich wie ein Schneckenhaus. Der Träger muss ihr folgen, ohne auf die zarte Membran an seinem Weg zu drücken.</translation>
    </message>
    <message>
        <source>What the hand feels are thousandths of a newton. Here the force is computed a thousand times a second, and can be practiced.</source>
        <translation>Was die Hand fühlt, sind Tausendstel eines Newtons. Hier wird die Kraft tausendmal in der Sekunde berechnet und lässt sich üben.</translation>
    </message>
    <message>
        <source>Inserting a cochlear implant</source>
        <translation>Ein Cochlea-Implantat einführen</translation>
    </message>
    <message>
        <source>This cannot be tried now</source>
        <translation>Das geht gerade nicht</translation>
    </message>
    <message>
        <source>The staff of the booth can help.</source>
        <translation>Fragen Sie bitte am Stand.</translation>
    </message>
    <message>
        <source>Your turn</source>
        <translation>Sie sind dran</translation>
    </message>
    <message>
        <source>Hold the handle’s button and push gently. Keep the force low until the array is in.</source>
        <translation>Halten Sie den Knopf des Griffs und schieben Sie sanft. Die Kraft soll klein bleiben, bis der Träger liegt.</translation>
    </message>
    <message>
        <source>Hold the green plate and the array moves in, the farther right the faster. Keep the force low until it is at full depth.</source>
        <translation>Halten Sie die grüne Fläche, und der Träger gleitet hinein, weiter rechts schneller. Die Kraft soll klein bleiben bis zur vollen Tiefe.</translation>
    </message>
    <message>
        <source>The array had to be stopped</source>
        <translation>Der Träger musste angehalten werden</translation>
    </message>
    <message>
        <source>The motion left what can be computed. The force is off. Try again.</source>
        <translation>Die Bewegung verließ das Berechenbare. Die Kraft ist aus. Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Full depth · peak force %1 mN · place %2 today</source>
        <translation>Volle Tiefe · Spitzenkraft %1 mN · heute Platz %2</translation>
    </message>
    <message>
        <source>Full depth · peak force %1 mN</source>
        <translation>Volle Tiefe · Spitzenkraft %1 mN</translation>
    </message>
    <message>
        <source>%1, in %2 s; turned back: %3.</source>
        <translation>%1, in %2 s; umgekehrt: %3.</translation>
    </message>
    <message>
        <source>Perilymph</source>
        <translation>Perilymph</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::MainWindow</name>
    <message>
        <source>The program ended unexpectedly. The insertion of then, to a depth of %1 mm, is kept in the library: %2.</source>
        <translation>Das Programm endete unerwartet. Die damalige Einführung, bis %1 mm Tiefe, liegt bei den Sitzungen: %2.</translation>
    </message>
    <message>
        <source>Show sessions</source>
        <translation>Sitzungen zeigen</translation>
    </message>
    <message>
        <source>Perilymph · %1</source>
        <translation>Perilymph · %1</translation>
    </message>
    <message>
        <source>Perilymph · replay of %1</source>
        <translation>Perilymph · %1 wird abgespielt</translation>
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
        <source>%1 to %2 %3. %4</source>
        <translation>%1 bis %2 %3. %4</translation>
    </message>
    <message>
        <source>must be %1 to %2 %3</source>
        <translation>muss %1 bis %2 %3 sein</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::OperationView</name>
    <message>
        <source>Surgeon’s view</source>
        <translation>Sicht des Operateurs</translation>
    </message>
    <message>
        <source>Down the opening</source>
        <translation>In die Öffnung</translation>
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
        <source>Across the basal turn</source>
        <translation>Quer zur Basalwindung</translation>
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
        <source>travel · depth %1 mm</source>
        <translation>Weg · Tiefe %1 mm</translation>
    </message>
    <message>
        <source>Microscope × %1</source>
        <translation>Mikroskop × %1</translation>
    </message>
    <message>
        <source>from round window</source>
        <translation>ab rundem Fenster</translation>
    </message>
    <message>
        <source>force on the hand</source>
        <translation>Kraft an der Hand</translation>
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
        <source>Three lengths</source>
        <translation>Drei Längen</translation>
    </message>
    <message>
        <source>A, B and H</source>
        <translation>A, B und H</translation>
    </message>
    <message>
        <source>Show this cochlea</source>
        <translation>Diese Cochlea zeigen</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>a code, not a name</source>
        <translation>ein Kürzel, kein Name</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>A patient’s numbers</source>
        <translation>Die Maße eines Patienten</translation>
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
        <source>MEASURED IN CT</source>
        <translation>IM CT GEMESSEN</translation>
    </message>
    <message>
        <source>Scala length, organ of Corti</source>
        <translation>Skalenlänge, Corti-Organ</translation>
    </message>
    <message>
        <source>Section width at round window</source>
        <translation>Schnittbreite am runden Fenster</translation>
    </message>
    <message>
        <source>Section height at round window</source>
        <translation>Schnitthöhe am runden Fenster</translation>
    </message>
    <message>
        <source>Length A, through the round window</source>
        <translation>Länge A, durch das runde Fenster</translation>
    </message>
    <message>
        <source>Width B, across A</source>
        <translation>Breite B, quer zu A</translation>
    </message>
    <message>
        <source>Height H</source>
        <translation>Höhe H</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>unbenannt</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PatientSection</name>
    <message>
        <source>typed</source>
        <translation>getippt</translation>
    </message>
    <message>
        <source>from CT</source>
        <translation>aus CT</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Vorgabe</translation>
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
        <source>A code, not a name.</source>
        <translation>Ein Kürzel, kein Name.</translation>
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
        <source>A left ear is the mirror image of a right one; its forces are the same.</source>
        <translation>Ein linkes Ohr ist das Spiegelbild eines rechten; seine Kräfte sind gleich.</translation>
    </message>
    <message>
        <source>Three lengths</source>
        <translation>Drei Längen</translation>
    </message>
    <message>
        <source>The published scala tympani, scaled by three lengths from CT.</source>
        <translation>Die veröffentlichte Scala tympani, nach drei Längen aus dem CT.</translation>
    </message>
    <message>
        <source>A, B and H</source>
        <translation>A, B und H</translation>
    </message>
    <message>
        <source>The mean of fifteen human scalae, scaled by the diameters of the basal turn. Adapted from Froehlich et al. 2024, CC BY 4.0.</source>
        <translation>Das Mittel von fünfzehn menschlichen Skalen, nach den Durchmessern der Basalwindung. Nach Froehlich et al. 2024, CC BY 4.0.</translation>
    </message>
    <message>
        <source>Mean of 15</source>
        <translation>Mittel von 15</translation>
    </message>
    <message>
        <source>The mean of fifteen human scalae as measured. Adapted from Froehlich, Schurzig, Rau, Lenarz (2024), PLOS ONE, doi 10.1371/journal.pone.0295121, CC BY 4.0.</source>
        <translation>Das Mittel von fünfzehn menschlichen Skalen, wie gemessen. Nach Froehlich, Schurzig, Rau, Lenarz (2024), PLOS ONE, doi 10.1371/journal.pone.0295121, CC BY 4.0.</translation>
    </message>
    <message>
        <source>Clark’s spiral</source>
        <translation>Clarks Spirale</translation>
    </message>
    <message>
        <source>A spiral of constant section, for comparison with older models.</source>
        <translation>Eine Spirale mit festem Schnitt, zum Vergleich mit älteren Modellen.</translation>
    </message>
    <message>
        <source>Scala length</source>
        <translation>Skalenlänge</translation>
    </message>
    <message>
        <source>Width at window</source>
        <translation>Breite am Fenster</translation>
    </message>
    <message>
        <source>Height at window</source>
        <translation>Höhe am Fenster</translation>
    </message>
    <message>
        <source>Length A</source>
        <translation>Länge A</translation>
    </message>
    <message>
        <source>Width B</source>
        <translation>Breite B</translation>
    </message>
    <message>
        <source>Height H</source>
        <translation>Höhe H</translation>
    </message>
    <message>
        <source>%1 %2. Correct it, or press Esc in its field.</source>
        <translation>%1 %2. Berichtigen, oder Esc im Feld drücken.</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>%1 left out</source>
        <translation>%1 ausgelassen</translation>
    </message>
    <message>
        <source>cochlea: %1</source>
        <translation>Cochlea: %1</translation>
    </message>
    <message>
        <source>patient %1</source>
        <translation>Patient %1</translation>
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
        <translation>Draußen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PopulationField</name>
    <message>
        <source>not given</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>a number is needed, %1 to %2 mm</source>
        <translation>eine Zahl ist nötig, %1 bis %2 mm</translation>
    </message>
    <message>
        <source>must be a number between %1 and %2 mm</source>
        <translation>muss eine Zahl zwischen %1 und %2 mm sein</translation>
    </message>
    <message>
        <source>left out: taken from A and B</source>
        <translation>ausgelassen: aus A und B genommen</translation>
    </message>
    <message>
        <source>%1%2 SD of population · CT error ± %3 mm</source>
        <translation>%1%2 SD der Bevölkerung · CT-Fehler ± %3 mm</translation>
    </message>
    <message>
        <source>allowed %1 to %2 mm · CT error ± %3 mm</source>
        <translation>erlaubt %1 bis %2 mm · CT-Fehler ± %3 mm</translation>
    </message>
    <message>
        <source>Where the number comes from.</source>
        <translation>Woher die Zahl kommt.</translation>
    </message>
    <message>
        <source>must be %1 to %2 mm</source>
        <translation>muss %1 bis %2 mm sein</translation>
    </message>
    <message>
        <source>%1%2 SD · CT ± %3 mm</source>
        <translation>%1%2 SD · CT ± %3 mm</translation>
    </message>
    <message>
        <source>%1 to %2 mm · CT ± %3 mm</source>
        <translation>%1 bis %2 mm · CT ± %3 mm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::PushPad</name>
    <message>
        <source>Hold here to insert</source>
        <translation>Hier halten zum Einführen</translation>
    </message>
    <message>
        <source>Let go to pause</source>
        <translation>Loslassen hält an</translation>
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
        <source>One tick back (Left)</source>
        <translation>Ein Takt zurück (Links)</translation>
    </message>
    <message>
        <source>▸</source>
        <translation>▸</translation>
    </message>
    <message>
        <source>One tick on (Right)</source>
        <translation>Ein Takt weiter (Rechts)</translation>
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
        <source>Faster (point)</source>
        <translation>Schneller (Punkt)</translation>
    </message>
    <message>
        <source>Close replay</source>
        <translation>Abspielen beenden</translation>
    </message>
    <message>
        <source>Back to the insertion (Esc)</source>
        <translation>Zurück zur Einführung (Esc)</translation>
    </message>
    <message>
        <source>One tick back</source>
        <translation>Ein Takt zurück</translation>
    </message>
    <message>
        <source>One tick on</source>
        <translation>Ein Takt weiter</translation>
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
        <source>%1 of %2 s · tick %3</source>
        <translation>%1 von %2 s · Takt %3</translation>
    </message>
    <message>
        <source>replay · %1 · not a medical device</source>
        <translation>Abspielen · %1 · kein Medizinprodukt</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ReplayControl</name>
    <message>
        <source>Space plays. Left and Right step by one tick.</source>
        <translation>Leertaste spielt ab. Links und Rechts gehen um einen Takt.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ReplayPlayer</name>
    <message>
        <source>comparing bits…</source>
        <translation>Bits werden verglichen …</translation>
    </message>
    <message>
        <source>is not as it was recorded: %1</source>
        <translation>ist nicht, wie es aufgezeichnet wurde: %1</translation>
    </message>
    <message>
        <source>differs from tick %1 on (%2)</source>
        <translation>weicht ab Takt %1 ab (%2)</translation>
    </message>
    <message>
        <source>replays bit for bit up to tick %1</source>
        <translation>gleich bis aufs Bit bis Takt %1</translation>
    </message>
    <message>
        <source>replays bit for bit</source>
        <translation>gleich bis aufs Bit</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ScenarioHead</name>
    <message>
        <source>MODIFIED</source>
        <translation>GEÄNDERT</translation>
    </message>
    <message>
        <source>Locked during an insertion</source>
        <translation>Gesperrt beim Einführen</translation>
    </message>
    <message>
        <source>Back to the published values</source>
        <translation>Zu den veröffentlichten Werten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>SCENARIO</source>
        <translation>SZENARIO</translation>
    </message>
    <message>
        <source>Hide the panel (B)</source>
        <translation>Feld verbergen (B)</translation>
    </message>
    <message>
        <source>Hide the panel</source>
        <translation>Feld verbergen</translation>
    </message>
    <message>
        <source>Changes are possible before an insertion and after it. Press Reset.</source>
        <translation>Änderungen gehen vor einer Einführung und danach. „Neu“ drücken.</translation>
    </message>
    <message>
        <source>Not the preset’s values: %1.</source>
        <translation>Nicht die Werte der Vorlage: %1.</translation>
    </message>
    <message>
        <source>Back to the preset’s values</source>
        <translation>Zu den Werten der Vorlage</translation>
    </message>
    <message>
        <source>Changed: %1. %2</source>
        <translation>Geändert: %1. %2</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Zurücknehmen: %1</translation>
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
    <name>perilymph::gui::Scrubber</name>
    <message>
        <source>Place in the replay</source>
        <translation>Stelle im Ablauf</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::Section</name>
    <message>
        <source>Fold or unfold</source>
        <translation>Auf- oder zuklappen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SessionTable</name>
    <message>
        <source>recording now</source>
        <translation>wird aufgezeichnet</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>unlesbar</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
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
        <source>Patient, ear</source>
        <translation>Patient, Ohr</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Deepest angle</source>
        <translation>Größter Winkel</translation>
    </message>
    <message>
        <source>Peak force at depth</source>
        <translation>Spitzenkraft bei Tiefe</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SessionTasks</name>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>%1 stands behind the next insertions as their ghost.</source>
        <translation>%1 steht als Geist hinter den nächsten Einführungen.</translation>
    </message>
    <message>
        <source>Replaying %1 for its report…</source>
        <translation>%1 wird für den Bericht abgespielt …</translation>
    </message>
    <message>
        <source>The report is %1.</source>
        <translation>Der Bericht ist %1.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SessionsPage</name>
    <message>
        <source>No insertion has been recorded yet</source>
        <translation>Noch ist keine Einführung aufgezeichnet</translation>
    </message>
    <message>
        <source>Every insertion is kept by itself. Here it can be found again, replayed, compared and written as a report.</source>
        <translation>Jede Einführung wird von selbst behalten. Hier lässt sie sich wiederfinden, abspielen, vergleichen und als Bericht schreiben.</translation>
    </message>
    <message>
        <source>Reading recording %1 of %2. Esc ends it.</source>
        <translation>Aufzeichnung %1 von %2 wird gelesen. Esc beendet es.</translation>
    </message>
    <message>
        <source>Find by patient, array, date, name</source>
        <translation>Suche nach Patient, Träger, Datum, Name</translation>
    </message>
    <message>
        <source>Find recordings</source>
        <translation>Aufzeichnungen suchen</translation>
    </message>
    <message>
        <source>Recorded insertions</source>
        <translation>Aufgezeichnete Einführungen</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Look at it again, tick by tick (Enter)</source>
        <translation>Noch einmal ansehen, Takt für Takt (Eingabe)</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Two or more over one axis</source>
        <translation>Zwei oder mehr über einer Achse</translation>
    </message>
    <message>
        <source>Use as ghost</source>
        <translation>Als Geist nehmen</translation>
    </message>
    <message>
        <source>Draw its curve behind the next insertions</source>
        <translation>Ihre Kurve hinter die nächsten Einführungen zeichnen</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>Write a report as PDF</source>
        <translation>Einen Bericht als PDF schreiben</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Give it another name (F2)</source>
        <translation>Anders nennen (F2)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Move it to the trash (Delete)</source>
        <translation>In den Papierkorb (Entf)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Bring it back (Ctrl+Z)</source>
        <translation>Zurückholen (Strg+Z)</translation>
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
    <message>
        <source>Nothing found</source>
        <translation>Nichts gefunden</translation>
    </message>
    <message>
        <source>No recording has “%1” in its patient, array, date or name.</source>
        <translation>Keine Aufzeichnung hat „%1“ in Patient, Träger, Datum oder Namen.</translation>
    </message>
    <message>
        <source>This insertion is being recorded. Reset ends its recording.</source>
        <translation>Diese Einführung wird aufgezeichnet. „Neu“ beendet die Aufzeichnung.</translation>
    </message>
    <message numerus="yes">
        <source>%n moved to the trash.</source>
        <translation>
            <numerusform>Eine ist im Papierkorb.</numerusform>
            <numerusform>%n sind im Papierkorb.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose several with Ctrl or Shift to compare them.</source>
        <translation>Mehrere mit Strg oder Umschalt wählen, um sie zu vergleichen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>List what was read so far (Esc)</source>
        <translation>Auflisten, was bisher gelesen wurde (Esc)</translation>
    </message>
    <message>
        <source>Ended early: %1 of %2 recordings are listed. Open this page again to read on.</source>
        <translation>Vorzeitig beendet: %1 von %2 Aufzeichnungen sind aufgelistet. Diese Seite erneut öffnen, um weiterzulesen.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Bericht als PDF</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SettingsSheet</name>
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
        <source>What the program notes about itself: %1</source>
        <translation>Was das Programm über sich notiert: %1</translation>
    </message>
    <message>
        <source>A choice reopens the window.</source>
        <translation>Eine Wahl öffnet das Fenster neu.</translation>
    </message>
    <message>
        <source>While the array is in the cochlea nothing can be chosen here. Reset first.</source>
        <translation>Solange der Träger in der Cochlea ist, lässt sich hier nichts wählen. Erst „Neu“ drücken.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::SetupHistory</name>
    <message>
        <source>back to the preset’s values</source>
        <translation>zu den Werten der Vorlage</translation>
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
        <source>Contact arrows</source>
        <translation>Kontaktpfeile</translation>
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
        <source>Published experiment</source>
        <translation>Veröffentlichter Versuch</translation>
    </message>
    <message>
        <source>Show the panel (B)</source>
        <translation>Feld zeigen (B)</translation>
    </message>
    <message>
        <source>Show the panel</source>
        <translation>Feld zeigen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StartPage</name>
    <message>
        <source>Insert an electrode array</source>
        <translation>Einen Elektrodenträger einführen</translation>
    </message>
    <message>
        <source>Into whose cochlea?</source>
        <translation>In wessen Cochlea?</translation>
    </message>
    <message>
        <source>Use a patient’s numbers</source>
        <translation>Maße eines Patienten</translation>
    </message>
    <message>
        <source>Three lengths from CT, or A, B and H, make this patient’s scala tympani. Each is compared with the population.</source>
        <translation>Drei Längen aus dem CT, oder A, B und H, ergeben die Scala tympani dieses Patienten. Jede wird mit der Bevölkerung verglichen.</translation>
    </message>
    <message>
        <source>Mean cochlea</source>
        <translation>Mittlere Cochlea</translation>
    </message>
    <message>
        <source>The average of fifteen human cochleae. Insert by script or with mouse and keyboard, and see the force over depth.</source>
        <translation>Das Mittel von fünfzehn menschlichen Cochleae. Einführen nach Skript oder mit Maus und Tastatur, und die Kraft über der Tiefe sehen.</translation>
    </message>
    <message>
        <source>Watch a demo insertion</source>
        <translation>Eine Vorführung ansehen</translation>
    </message>
    <message>
        <source>A Contour array goes into the published cochlea by itself, beside the forces that were measured in the experiment.</source>
        <translation>Ein Contour-Träger geht von selbst in die veröffentlichte Cochlea, neben den Kräften, die im Versuch gemessen wurden.</translation>
    </message>
    <message>
        <source>Keys 1, 2 and 3 do the same. For research and training; not a medical device.</source>
        <translation>Die Tasten 1, 2 und 3 tun dasselbe. Für Forschung und Übung; kein Medizinprodukt.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::StereoWindow</name>
    <message>
        <source>Perilymph, for two eyes</source>
        <translation>Perilymph, für zwei Augen</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::TopBar</name>
    <message>
        <source>Perilymph</source>
        <translation>Perilymph</translation>
    </message>
    <message>
        <source>Start over (Alt+Home)</source>
        <translation>Von vorn beginnen (Alt+Pos1)</translation>
    </message>
    <message>
        <source>Keys and mouse (F1)</source>
        <translation>Tasten und Maus (F1)</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
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
        <source>Insert</source>
        <translation>Einführen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Validate</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>MODIFIED</source>
        <translation>GEÄNDERT</translation>
    </message>
    <message>
        <source>Patient %1 · %2 ear</source>
        <translation>Patient %1 · %2es Ohr</translation>
    </message>
    <message>
        <source>%1 anatomy · %2 ear</source>
        <translation>Anatomie %1 · %2es Ohr</translation>
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
        <source>Not the preset’s values: %1.</source>
        <translation>Nicht die Werte der Vorlage: %1.</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>fault · no force</source>
        <translation>Fehler · keine Kraft</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>%1 Hz · %2 late</source>
        <translation>%1 Hz · %2 verspätet</translation>
    </message>
    <message>
        <source>%1. Ticks a second as measured, and ticks that began more than one period late.</source>
        <translation>%1. Takte je Sekunde, gemessen, und Takte, die über eine Periode zu spät begannen.</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>wird vorbereitet</translation>
    </message>
    <message>
        <source>replay</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>A recording is shown. No device is moved.</source>
        <translation>Eine Aufzeichnung wird gezeigt. Kein Gerät wird bewegt.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ValidatePage</name>
    <message>
        <source>Insertion %1 of %2</source>
        <translation>Einführung %1 von %2</translation>
    </message>
    <message>
        <source>The published experiment, repeated</source>
        <translation>Der veröffentlichte Versuch, wiederholt</translation>
    </message>
    <message>
        <source>Many insertions that differ as real ones do: where the tip starts, how the array is aligned, how curved it is, how slippery the wall. Their mean is held against the forces that were printed. Two forces were used to calibrate the array; the others are predictions.</source>
        <translation>Viele Einführungen, die sich unterscheiden wie wirkliche: wo die Spitze beginnt, wie der Träger ausgerichtet ist, wie gekrümmt er ist, wie glatt die Wand. Ihr Mittel wird mit den gedruckten Kräften verglichen. Zwei Kräfte dienten dem Abgleich des Trägers; die anderen sind Vorhersagen.</translation>
    </message>
    <message>
        <source>Insertions</source>
        <translation>Einführungen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern …</translation>
    </message>
    <message>
        <source>Curves as CSV, numbers as JSON, figures as SVG, into a folder.</source>
        <translation>Kurven als CSV, Zahlen als JSON, Bilder als SVG, in einen Ordner.</translation>
    </message>
    <message>
        <source>insertions</source>
        <translation>Einführungen</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Building the cochlea…</source>
        <translation>Die Cochlea wird gebaut …</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Hält an …</translation>
    </message>
    <message>
        <source>%1 insertions, seed %2. Spread over travel %3 mN.</source>
        <translation>%1 Einführungen, Startzahl %2. Streuung über den Weg %3 mN.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Repeat it</source>
        <translation>Wiederholen</translation>
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
        <source>Folder for curves, numbers and figures</source>
        <translation>Ordner für Kurven, Zahlen und Bilder</translation>
    </message>
    <message>
        <source>Six files are in %1.</source>
        <translation>Sechs Dateien liegen in %1.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ValidationWork</name>
    <message>
        <source>Canceled. Nothing was kept.</source>
        <translation>Abgebrochen. Nichts wurde behalten.</translation>
    </message>
</context>
<context>
    <name>perilymph::gui::ViewMenu</name>
    <message>
        <source>View ▾</source>
        <translation>Ansicht ▾</translation>
    </message>
    <message>
        <source>Where to look from, how many views, stereo, and how much is drawn</source>
        <translation>Von wo man sieht, wie viele Ansichten, Stereo, und wie viel gezeichnet wird</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>LOOK FROM</source>
        <translation>BLICK VON</translation>
    </message>
    <message>
        <source>Surgeon’s view, turned 110°</source>
        <translation>Sicht des Operateurs, um 110° gedreht</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Down the opening</source>
        <translation>In die Öffnung</translation>
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
        <source>Across the basal turn</source>
        <translation>Quer zur Basalwindung</translation>
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
        <source>DRAWING</source>
        <translation>ZEICHNEN</translation>
    </message>
    <message>
        <source>By the machine’s speed</source>
        <translation>Nach dem Tempo des Rechners</translation>
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
        <source>Quad-buffered, in a window of its own</source>
        <translation>Vierfach gepuffert, in eigenem Fenster</translation>
    </message>
    <message>
        <source>The picture for two eyes through the display’s two buffers, without words on it; Esc closes it.</source>
        <translation>Das Bild für zwei Augen über die zwei Puffer der Anzeige, ohne Schrift darauf; Esc schließt es.</translation>
    </message>
    <message>
        <source>SOUND</source>
        <translation>TON</translation>
    </message>
    <message>
        <source>looking for a sound output</source>
        <translation>Tonausgabe wird gesucht</translation>
    </message>
    <message>
        <source>Hear the force: an octave for each 100 mN</source>
        <translation>Die Kraft hören: eine Oktave je 100 mN</translation>
    </message>
    <message>
        <source>Hear the force: %1</source>
        <translation>Die Kraft hören: %1</translation>
    </message>
    <message>
        <source>A tone while the force on the hand is 5 mN or more: 220 Hz at no force, an octave higher for each 100 mN.</source>
        <translation>Ein Ton, solange die Kraft an der Hand mindestens 5 mN ist: 220 Hz ohne Kraft, je 100 mN eine Oktave höher.</translation>
    </message>
</context>
</TS>
