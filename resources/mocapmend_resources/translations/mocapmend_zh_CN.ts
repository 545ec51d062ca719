<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export repaired recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check a repaired copy…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save recipe…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay recipe…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select no marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next gap of this marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous gap of this marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave this gap open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never fill this gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut a frame off both edges of the gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a frame back at both edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply the previewed repair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply and go to the next gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn this repair back into a gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose repair {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose repair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare repairs side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick donors by clicking markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan for all gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save plan…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load plan…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill all gaps up to the limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play / pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One second forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One second back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select to here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop the selection, or everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Oblique view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from further left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from further right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from higher up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from lower down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Farther</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre the current marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in 3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marker labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trail of the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trails of all markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longer trails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shorter trails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sticks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Segments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force plates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before and after the edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom in on the time axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom out on the time axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom to the gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom to the selected frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lanes with most missing first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to pane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the repairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the queue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the analog channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>English</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>中文</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save this layout…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrange as at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next set of plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous set of plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position: x, y and z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bone length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next bone of the marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Same scale for x, y and z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One set of plots per marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find an action…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the log file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About mocapmend</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AnalogPane</name>
    <message>
        <source>Filter channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All channels in one plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analog channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading analog channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analog channels could not be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled: check a channel to read it again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AnalogPlots</name>
    <message>
        <source>Analog plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check a channel on the left to see it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file&apos;s values of this channel are no numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame {0} · {1} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BonesPage</name>
    <message>
        <source>Length ({0})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bone spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repaired frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread of the bone lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation of the length over its mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured (dashed)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repaired (solid)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Callout</name>
    <message>
        <source>Tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip the tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc; Help &gt; Tour shows it again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CandidateList</name>
    <message>
        <source>Key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repairs of the current gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not computed yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too little of the recording to test on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The least expected error of these</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Check</name>
    <message>
        <source>Changed marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check of {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Original: {0}&lt;br&gt;Copy: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These differences are allowed:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These are not:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Something went wrong inside the program. Your recording is unchanged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The log file has the details:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why it stayed open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaps that stayed open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click a gap to go there</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Documents</name>
    <message>
        <source>Open recordings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>EventLane</name>
    <message>
        <source>Event without a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} {1}</source>
        <comment>side, event</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FileActions</name>
    <message>
        <source>Open recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is open already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C3D (*.c3d)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TRC (*.trc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV, one line per frame (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV, one line per sample (*.long.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NumPy (*.npz)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export repaired recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export a truncated recording?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file ends before its data do. The copy will be as short as the original.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exporting {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report written to {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has repairs that are not exported yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace {0}?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a file of this name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings ({0})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened {0}, in which {3} gaps have been repaired before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened {0}, which is truncated: {1} of {2} frames are there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported {0} to {1}: {2} repaired samples, read back and compared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported {0} to {1}: {2} samples changed, all else is the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported {0} to {1}: the same as the original, byte for byte.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace the original recording?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is the file that you opened. Its missing samples will be overwritten with the repairs, and the undo history ends here. A new name keeps both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Filling</name>
    <message>
        <source>Fill all gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled: nothing was filled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fill {0} gaps ({1})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} gaps filled, {1} left open.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GapActions</name>
    <message>
        <source>No gap is left in the queue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gap is left to go to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no preview to apply: choose a gap first (N).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This method leaves the gap open; choose another (M).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fill {0} ({1})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clear the repair of {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no repair here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gap is open again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left open by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no gap here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>never fill {0} gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>allow to fill {0} gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ends of this gap go no further.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move the ends of a gap of {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no open gap here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HistoryPage</name>
    <message>
        <source>Nothing is edited yet. Edits are listed here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples set missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History of edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} repairs that the file had when it was opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HistoryPane</name>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a step, or use the arrow keys, to go back or forward to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} (undone)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} ✔ exported</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>JobIndicator</name>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LanePainter</name>
    <message>
        <source>Speed ({0}/s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration ({0}/s²)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual ({0})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length {0} ({1})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This file has no residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select two markers to see how far they are apart</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>The language changes at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Layouts</name>
    <message>
        <source>Save this layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the layout:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout saved: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layout {0} is of another version and does not fit: save it anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout deleted: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LimitsBox</name>
    <message>
        <source>length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest gap in frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expected error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest expected error in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> frames ({0} ms)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About mocapmend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inspects and repairs optical motion-capture recordings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} markers · {1} frames · {2} Hz · {3} s · {4}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window closes when the file is written.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MarkerModel</name>
    <message>
        <source>Marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: never seen in this recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} open gaps, longest {2} frames ({3} ms), {4} samples filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves as one with {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MarkerReportModel</name>
    <message>
        <source>Marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing (%)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames in which it was missing before, in %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now (%)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames in which it is missing now, in %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaps before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaps now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest gap before, in frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest gap before, in milliseconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest gap now, in frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unfilled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples that are missing now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filled by (%)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames that each method filled, in %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest expected error of its repairs, in mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MarkerTable</name>
    <message>
        <source>Filter markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markers</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MarkersPage</name>
    <message>
        <source>Markers before and after the repairs</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>Open recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Repair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;lots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} (gone)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove files that are gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None without markers</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MethodBox</name>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MethodsPage</name>
    <message>
        <source>Methods paragraph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Being computed…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the methods paragraph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready to paste into a paper, in English.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NamesEdit</name>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>◀ selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the selected markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the selected markers: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To take markers, Ctrl+click them in the list.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NotesBar</name>
    <message>
        <source>1 note on this file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} notes on this file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was odd in this file, and what was assumed:</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Overview</name>
    <message>
        <source>Overview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overview of the whole recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the window or its ends; click to go there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames {0} to {1}: {2} % of the samples are missing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Find an action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type what to do: an action, a pane, a recent file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What fits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing fits. Fewer letters find more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter does it, Escape closes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a recording first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only C3D recordings can be checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only one recording is open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This recording has no markers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not possible now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This file is gone: {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ParamsForm</name>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlanModel</name>
    <message>
        <source>Marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What would be done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} ({1} ms)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>… not computed yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✔ filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ stays open: {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlanPane</name>
    <message>
        <source>Which gaps are listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Would be filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Would stay open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By {0}: {1} gaps ({2} samples) would be filled, {3} would stay open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} are not computed yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click a gap, or press Enter, to go there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save plan…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load plan…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlotCanvas</name>
    <message>
        <source>+{0} more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlotPane</name>
    <message>
        <source>Bone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two markers whose distance is plotted (B for the next)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no bone here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>XYZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1:1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Previewer</name>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the preview was cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the preview failed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProofActions</name>
    <message>
        <source>Save recipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the recipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recipe written to {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay recipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plans (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan written to {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plans (*.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check a repaired copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C3D recordings (*.c3d *.C3D);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording was edited meanwhile: replay again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recipe has nothing to do here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replay {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} edits made again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} edits made again, by a recipe that was made for another file.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QueueModel</name>
    <message>
        <source>Marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Harm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Best</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Context</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What has become of the gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected error of the best repair that was tried, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected error times missing frames: what comes first is worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The method with the least expected error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the gap lies, and how many other markers are missing in its middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First and last missing frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repaired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>never to be filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start, {0} more missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end, {0} more missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inside, {0} more missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}, frames {1} to {2}: {3}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No repair that was tried could be tested here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QueuePane</name>
    <message>
        <source>Filter markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter the queue by marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try repairs on all gaps in the background, so that the worst come first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never to be filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up to 0.2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0.2 to 1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above 1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Queue of gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inside, {0} more missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gap passes the filter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No marker is missing anywhere: there is nothing to fill.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} gaps · ranked {1} of {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} gaps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RecentFiles</name>
    <message>
        <source>Looking for recent files</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>Looking for edits to recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovered 1 edit of {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovered {0} edits of {1}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RecoveryDialog</name>
    <message>
        <source>Recover edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program ended before these edits were exported. Recover opens the recording with the edits, which can still be undone; the file itself is not changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings with edits that can be recovered</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RepairModel</name>
    <message>
        <source>Marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Donors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: click to go there, Del turns the repair back into a gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computed from {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RepairPanel</name>
    <message>
        <source>Current gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>◀ Previous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next ▶</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square of the 3-D error, and the radius that holds 90 % of the errors, on stretches of this recording that were hidden for the test.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reopen the gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All gaps, with this method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what stayed open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No marker is missing anywhere: there is nothing to fill.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press N for the next gap, or click one on the timeline.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Never to be filled.&lt;/b&gt; Shift+X makes it a gap again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repaired with &lt;b&gt;{0}&lt;/b&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing the preview…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} open gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, never seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame {0}
1 frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames {0} to {1}
{2} frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} ({2} ms){3}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} + {1} measured frames at its ends cut off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Stays open:&lt;/b&gt; {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;⚠ Above the limit of {0} mm&lt;/b&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cubic spline: the other markers say less about this gap.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured on {0} hidden stretches of {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected error &lt;b&gt;unknown&lt;/b&gt;: too little of the recording to test on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected error &lt;b&gt;{0} mm&lt;/b&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, 90 % within {0} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Donors: {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RepairTable</name>
    <message>
        <source>Nothing is repaired yet. Repairs are listed here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReportPane</name>
    <message>
        <source>Tracking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Methods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check a copy…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages of the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>Wheelchair sprint, many gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gait, Plug-in Gait, with fragments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk, 41 markers, complete</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>segment {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before and after: no edits in this frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before and after: {0} filled, {1} moved, {2} removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure: select two markers for a distance, three for an angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: missing here ({1})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: no angle, two of them are at one place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} (not measured: {2})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ScenePicture</name>
    <message>
        <source>3D marker view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Segments: none are known for this recording</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search for an action or a key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make this the only key of the action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep its other keys too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the action its first keys again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menu</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D view: drag to orbit, Shift+drag to move, wheel to zoom, click to pick, double-click to centre. Plots and timeline: drag to scrub, wheel to zoom, Shift+wheel to move, double-click a gap to go there; Ctrl+click adds a marker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} (changed)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} belongs to “{1}”. Choose another key, or change that one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One of its first keys belongs to “{0}” now. Change that one first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Survey</name>
    <message>
        <source>Ranking</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TimeActions</name>
    <message>
        <source>This recording has no events.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No frames are selected: drag with Shift, or press I and O.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gap is chosen: press N for the next one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Timeline</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TimelineMarks</name>
    <message>
        <source>{0} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} frames, {1} s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TimelineTexts</name>
    <message>
        <source>{0}: measured here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: repaired, frames {1} to {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: missing from frame {1} to {2}, {3} frames ({4} ms)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}, frame {1}, {2} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame {0}, {1} s: {2} of {3} markers are missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current gap: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selected: frames {0} to {1}.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Step {0} of {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Welcome. Open a recording: drop a file here, or begin with a sample.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each lane is a marker, orange is where it is missing. Press {0} to go to the next gap, or double-click one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The yellow curve is the proposed repair with its 90 % band. Nothing is changed yet. {0} shows another method.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here is how far off the repair is expected to be. {0} applies it, {1} takes it back, and {2} repairs all gaps up to the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Report tab compares before and after ({0}), the History tab goes back to any step ({1}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} writes a repaired copy in which nothing else changes, and proves it. {1} finds everything that the program can do.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TrackingPage</name>
    <message>
        <source>Tracked now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Segments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the curves count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A segment is a group of markers that keep their distances to each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} % before, {2} % after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before (dashed)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after (solid)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TrainingBox</name>
    <message>
        <source>this recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse for a training set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a training set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Training sets (*.npz)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Trajectories</name>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trajectory plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a marker to see its trajectory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is chosen to be plotted: press V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame {0} · {1} s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Transport</name>
    <message>
        <source>Playback speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playback speed ([ and ])</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  Frame</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Open recordings (C3D, TRC, CSV, BVH, ASF/AMC, npz), or drop them here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove {0} from the list</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>Skeleton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This file has no analog channels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trails reach {0} s back and ahead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This method takes no donors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} gaps filled, {1} left open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not exported yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edited since {0} was exported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Queue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} analog channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} model outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This file has no marker samples: there is nothing to repair.

It holds {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing that can be shown</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
