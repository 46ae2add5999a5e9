<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>kumite::studio::LabelPanel</name>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>%n action</numerusform>
            <numerusform>%n actions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::LabelReview</name>
    <message numerus="yes">
        <source>Accepted: %n action(s). Ctrl+Z takes all of it back.</source>
        <translation>
            <numerusform>Accepted: %n action. Ctrl+Z takes it back.</numerusform>
            <numerusform>Accepted: %n actions. Ctrl+Z takes all of them back.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::MessageStrip</name>
    <message numerus="yes">
        <source> And %n more.</source>
        <translation>
            <numerusform> And %n more.</numerusform>
            <numerusform> And %n more.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::ProgressBox</name>
    <message numerus="yes">
        <source>%n minima are still suspect. Half actions are hard to label: correct them in Segment first, or go on with N.</source>
        <translation>
            <numerusform>%n minimum is still suspect. Half actions are hard to label: correct it in Segment first, or go on with N.</numerusform>
            <numerusform>%n minima are still suspect. Half actions are hard to label: correct them in Segment first, or go on with N.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::Review</name>
    <message numerus="yes">
        <source>What you decided clears %n more.</source>
        <translation>
            <numerusform>What you decided clears one more.</numerusform>
            <numerusform>What you decided clears %n more.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n suspect(s) left.</source>
        <translation>
            <numerusform>%n suspect left.</numerusform>
            <numerusform>%n suspects left.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kumite::studio::Words</name>
    <message numerus="yes">
        <source>%n edit(s)</source>
        <translation>
            <numerusform>%n edit</numerusform>
            <numerusform>%n edits</numerusform>
        </translation>
    </message>
</context>
</TS>
