"""The one table of actions and shortcuts: it makes menus, toolbar and the shortcut help."""

from dataclasses import dataclass
from typing import Literal

from PySide6.QtGui import QKeySequence

from mocapmend.translate import QT_TRANSLATE_NOOP

Menu = Literal["File", "Edit", "Gaps", "Problems", "Repair", "Play", "View", "Plots", "Help"]
MENUS: tuple[Menu, ...] = (
    "File",
    "Edit",
    "Gaps",
    "Problems",
    "Repair",
    "Play",
    "View",
    "Plots",
    "Help",
)


@dataclass(frozen=True)
class ActionSpec:
    """An action: its name in the code, its place, what the user reads and presses.

    Attributes
    ----------
    id : str
        Name in the code.
    menu : str
        The menu that holds it.
    text : str
        What the user reads.
    keys : tuple
        Shortcuts: standard keys, so that each platform has its own, or texts.
    needs : str
        "nothing", "document" (any open file), "c3d" (one of that format), "markers" (a file
        that has some), or "several" (open files).
    checkable : bool
        Whether it switches something on and off.
    starts_group : bool
        Whether the menu draws a line above it.
    number : int
        Stands for {0} in the text.
    submenu : str
        What the user reads of the menu inside the menu that holds it, if there is one.
    """

    id: str
    menu: Menu
    text: str
    keys: tuple[str | QKeySequence.StandardKey, ...] = ()
    needs: Literal["nothing", "document", "c3d", "markers", "several"] = "markers"
    checkable: bool = False
    starts_group: bool = False
    number: int = 0
    submenu: str = ""


_Key = QKeySequence.StandardKey

ACTIONS: tuple[ActionSpec, ...] = (
    ActionSpec("open", "File", QT_TRANSLATE_NOOP("Actions", "Open…"), (_Key.Open,), "nothing"),
    ActionSpec(
        "export",
        "File",
        QT_TRANSLATE_NOOP("Actions", "Export repaired recording…"),
        (_Key.Save,),
        "document",
    ),
    ActionSpec("save_report", "File", QT_TRANSLATE_NOOP("Actions", "Save report…"), ("Ctrl+R",)),
    ActionSpec(
        "check_copy",
        "File",
        QT_TRANSLATE_NOOP("Actions", "Check a repaired copy…"),
        ("Ctrl+K",),
        "c3d",
        starts_group=True,
    ),
    ActionSpec("save_recipe", "File", QT_TRANSLATE_NOOP("Actions", "Save recipe…")),
    ActionSpec("replay_recipe", "File", QT_TRANSLATE_NOOP("Actions", "Replay recipe…")),
    ActionSpec(
        "close",
        "File",
        QT_TRANSLATE_NOOP("Actions", "Close file"),
        (_Key.Close,),
        "document",
        starts_group=True,
    ),
    ActionSpec(
        "quit", "File", QT_TRANSLATE_NOOP("Actions", "Quit"), (_Key.Quit, "Ctrl+Q"), "nothing"
    ),
    ActionSpec("undo", "Edit", QT_TRANSLATE_NOOP("Actions", "Undo"), (_Key.Undo,), "document"),
    ActionSpec(
        "redo",
        "Edit",
        QT_TRANSLATE_NOOP("Actions", "Redo"),
        (_Key.Redo, "Ctrl+Shift+Z", "Ctrl+Y"),
        "document",
    ),
    ActionSpec(
        "select_all",
        "Edit",
        QT_TRANSLATE_NOOP("Actions", "Select all markers"),
        (_Key.SelectAll,),
        starts_group=True,
    ),
    ActionSpec(
        "select_none", "Edit", QT_TRANSLATE_NOOP("Actions", "Select no marker"), ("Ctrl+Shift+A",)
    ),
    ActionSpec(
        "select_in_view", "Edit", QT_TRANSLATE_NOOP("Actions", "Select the markers in view"), ("A",)
    ),
    ActionSpec(
        "add_in_view",
        "Edit",
        QT_TRANSLATE_NOOP("Actions", "Add the markers in view"),
        ("Shift+A",),
    ),
    ActionSpec(
        "rename", "Edit", QT_TRANSLATE_NOOP("Actions", "Rename…"), ("F2",), starts_group=True
    ),
    ActionSpec(
        "exchange_names",
        "Edit",
        QT_TRANSLATE_NOOP("Actions", "Exchange the names of the two selected markers"),
        ("Shift+F2",),
    ),
    ActionSpec("this_is", "Edit", QT_TRANSLATE_NOOP("Actions", "This is…"), ("F3",)),
    ActionSpec(
        "next_nameless",
        "Edit",
        QT_TRANSLATE_NOOP("Actions", "Next point without a label"),
        ("Shift+F3",),
    ),
    ActionSpec(
        "label_from",
        "Edit",
        QT_TRANSLATE_NOOP("Actions", "Label from recordings…"),
        ("Ctrl+I",),
        starts_group=True,
    ),
    ActionSpec("apply_labels", "Edit", QT_TRANSLATE_NOOP("Actions", "Apply the proposed labels")),
    ActionSpec("next_gap", "Gaps", QT_TRANSLATE_NOOP("Actions", "Next gap or problem"), ("N",)),
    ActionSpec(
        "previous_gap", "Gaps", QT_TRANSLATE_NOOP("Actions", "Previous gap or problem"), ("P",)
    ),
    ActionSpec(
        "next_gap_here",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Next gap of this marker"),
        ("Shift+N",),
    ),
    ActionSpec(
        "previous_gap_here",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Previous gap of this marker"),
        ("Shift+P",),
    ),
    ActionSpec(
        "leave_open",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Leave this gap open"),
        ("X",),
        starts_group=True,
    ),
    ActionSpec(
        "never_fill", "Gaps", QT_TRANSLATE_NOOP("Actions", "Never fill this gap"), ("Shift+X",)
    ),
    ActionSpec(
        "explain_gap",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Say why this gap stays open…"),
        ("Alt+X",),
    ),
    ActionSpec(
        "widen",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Cut a frame off both edges of the gap"),
        ("W",),
        starts_group=True,
    ),
    ActionSpec(
        "narrow",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Give a frame back at both edges"),
        ("Shift+W",),
    ),
    ActionSpec(
        "search_bad",
        "Problems",
        QT_TRANSLATE_NOOP("Actions", "Look for bad samples"),
        ("Ctrl+F",),
    ),
    ActionSpec(
        "fix_problem",
        "Problems",
        QT_TRANSLATE_NOOP("Actions", "Fix this problem"),
        ("H",),
        starts_group=True,
    ),
    ActionSpec(
        "fix_kind",
        "Problems",
        QT_TRANSLATE_NOOP("Actions", "Fix all problems of this kind"),
        ("Shift+H",),
    ),
    ActionSpec(
        "fix_all", "Problems", QT_TRANSLATE_NOOP("Actions", "Fix all problems"), ("Ctrl+H",)
    ),
    ActionSpec(
        "dismiss_problem",
        "Problems",
        QT_TRANSLATE_NOOP("Actions", "This is no problem"),
        ("Shift+D",),
    ),
    ActionSpec(
        "set_aside",
        "Problems",
        QT_TRANSLATE_NOOP("Actions", "Set the selected samples aside"),
        ("U",),
        starts_group=True,
    ),
    ActionSpec(
        "believe",
        "Problems",
        QT_TRANSLATE_NOOP("Actions", "Believe samples that were set aside"),
        ("Shift+U",),
    ),
    ActionSpec(
        "exchange",
        "Problems",
        QT_TRANSLATE_NOOP("Actions", "Exchange the samples of the two selected markers"),
        ("Ctrl+E",),
    ),
    ActionSpec(
        "apply",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Apply the previewed repair"),
        ("Return", "Enter"),
    ),
    ActionSpec(
        "apply_next",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Apply and go to the next gap"),
        ("Shift+Return", "Shift+Enter"),
    ),
    ActionSpec(
        "clear_fill",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Turn this repair back into a gap"),
        ("Del",),
    ),
    *(
        ActionSpec(
            f"candidate_{number}",
            "Repair",
            QT_TRANSLATE_NOOP("Actions", "Choose repair {0}"),
            (str(number),),
            number=number,
            submenu=QT_TRANSLATE_NOOP("Actions", "Choose repair"),
        )
        for number in range(1, 9)
    ),
    ActionSpec(
        "next_method",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Next method"),
        ("M",),
        starts_group=True,
    ),
    ActionSpec(
        "previous_method", "Repair", QT_TRANSLATE_NOOP("Actions", "Previous method"), ("Shift+M",)
    ),
    ActionSpec(
        "compare",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Compare repairs side by side"),
        ("Q",),
        checkable=True,
    ),
    ActionSpec(
        "pick_donors",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Pick donors by clicking markers"),
        ("D",),
        checkable=True,
    ),
    ActionSpec(
        "plan",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Plan for all gaps"),
        ("Ctrl+Shift+Return",),
        starts_group=True,
    ),
    ActionSpec("save_plan", "Repair", QT_TRANSLATE_NOOP("Actions", "Save plan…")),
    ActionSpec("load_plan", "Repair", QT_TRANSLATE_NOOP("Actions", "Load plan…")),
    ActionSpec(
        "fill_all",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Fill all gaps up to the limit"),
        ("Ctrl+Return",),
    ),
    ActionSpec(
        "refine",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Refine by a network…"),
        ("Ctrl+Shift+R",),
        starts_group=True,
    ),
    ActionSpec(
        "smooth",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Smooth the chosen markers"),
        ("Ctrl+M",),
        starts_group=True,
    ),
    ActionSpec(
        "unsmooth",
        "Repair",
        QT_TRANSLATE_NOOP("Actions", "Take smoothing off the chosen markers"),
        ("Ctrl+Shift+M",),
    ),
    ActionSpec("play", "Play", QT_TRANSLATE_NOOP("Actions", "Play / pause"), ("Space",)),
    ActionSpec("next_frame", "Play", QT_TRANSLATE_NOOP("Actions", "Next frame"), ("Right",)),
    ActionSpec("previous_frame", "Play", QT_TRANSLATE_NOOP("Actions", "Previous frame"), ("Left",)),
    ActionSpec(
        "forward", "Play", QT_TRANSLATE_NOOP("Actions", "One second forward"), ("Shift+Right",)
    ),
    ActionSpec("back", "Play", QT_TRANSLATE_NOOP("Actions", "One second back"), ("Shift+Left",)),
    ActionSpec("first_frame", "Play", QT_TRANSLATE_NOOP("Actions", "First frame"), ("Home",)),
    ActionSpec("last_frame", "Play", QT_TRANSLATE_NOOP("Actions", "Last frame"), ("End",)),
    ActionSpec("faster", "Play", QT_TRANSLATE_NOOP("Actions", "Faster"), ("]",), starts_group=True),
    ActionSpec("slower", "Play", QT_TRANSLATE_NOOP("Actions", "Slower"), ("[",)),
    ActionSpec(
        "next_event",
        "Play",
        QT_TRANSLATE_NOOP("Actions", "Next event"),
        ("E",),
        starts_group=True,
    ),
    ActionSpec(
        "previous_event", "Play", QT_TRANSLATE_NOOP("Actions", "Previous event"), ("Shift+E",)
    ),
    ActionSpec(
        "select_from",
        "Play",
        QT_TRANSLATE_NOOP("Actions", "Select from here"),
        ("I",),
        starts_group=True,
    ),
    ActionSpec("select_to", "Play", QT_TRANSLATE_NOOP("Actions", "Select to here"), ("O",)),
    ActionSpec("select_no_frames", "Play", QT_TRANSLATE_NOOP("Actions", "Select none"), ("Esc",)),
    ActionSpec(
        "loop",
        "Play",
        QT_TRANSLATE_NOOP("Actions", "Loop the selection, or everything"),
        ("Shift+L",),
        checkable=True,
    ),
    ActionSpec(
        "view_front",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Front view"),
        ("Alt+1",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "view_back",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Back view"),
        ("Alt+2",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "view_left",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Left view"),
        ("Alt+3",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "view_right",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Right view"),
        ("Alt+4",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "view_top",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Top view"),
        ("Alt+5",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "view_oblique",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Oblique view"),
        ("Alt+6",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "turn_left",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Look from further left"),
        ("Alt+Left",),
        starts_group=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "turn_right",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Look from further right"),
        ("Alt+Right",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "turn_up",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Look from higher up"),
        ("Alt+Up",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "turn_down",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Look from lower down"),
        ("Alt+Down",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "nearer",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Nearer"),
        ("Alt++", "Alt+="),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "farther",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Farther"),
        ("Alt+-",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "centre_marker",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Centre the current marker"),
        ("Alt+0",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Look from"),
    ),
    ActionSpec(
        "follow",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Follow the body"),
        ("F",),
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "labels",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Marker labels"),
        ("L",),
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "trails",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Trail of the selection"),
        ("T",),
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "all_trails",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Trails of all markers"),
        ("Shift+T",),
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "longer_trails",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Longer trails"),
        ("Ctrl+T",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "shorter_trails",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Shorter trails"),
        ("Ctrl+Shift+T",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "sticks",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Sticks"),
        ("K",),
        checkable=True,
        starts_group=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "segments",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Segments"),
        ("Shift+K",),
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "ground",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Ground grid"),
        (),
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "plates",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Force plates"),
        (),
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "before_after",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Before and after the edits"),
        ("C",),
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "measure",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Measure the selection"),
        ("R",),
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Show in 3D"),
    ),
    ActionSpec(
        "compare_with",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Compare with recording…"),
        ("Ctrl+D",),
        starts_group=True,
    ),
    ActionSpec(
        "companion",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Show the compared recording"),
        ("Shift+C",),
        checkable=True,
    ),
    ActionSpec(
        "end_comparing",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Stop comparing"),
        ("Ctrl+Shift+D",),
    ),
    ActionSpec(
        "zoom_in",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Zoom in on the time axis"),
        ("+", "="),
        starts_group=True,
    ),
    ActionSpec(
        "zoom_out", "View", QT_TRANSLATE_NOOP("Actions", "Zoom out on the time axis"), ("-",)
    ),
    ActionSpec("zoom_all", "View", QT_TRANSLATE_NOOP("Actions", "Whole recording"), ("0",)),
    ActionSpec(
        "zoom_gap", "View", QT_TRANSLATE_NOOP("Actions", "Zoom to the gap or problem"), ("G",)
    ),
    ActionSpec(
        "zoom_span", "View", QT_TRANSLATE_NOOP("Actions", "Zoom to the selected frames"), ("Z",)
    ),
    ActionSpec("next_page", "View", QT_TRANSLATE_NOOP("Actions", "Next page"), ("Ctrl+Right",)),
    ActionSpec(
        "previous_page", "View", QT_TRANSLATE_NOOP("Actions", "Previous page"), ("Ctrl+Left",)
    ),
    ActionSpec(
        "most_missing_first",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Lanes with most missing first"),
        (),
        checkable=True,
    ),
    ActionSpec(
        "show_timeline",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Go to the timeline"),
        ("Ctrl+1",),
        starts_group=False,
        submenu=QT_TRANSLATE_NOOP("Actions", "Go to pane"),
    ),
    ActionSpec(
        "show_repairs",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Go to the repairs"),
        ("Ctrl+2",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Go to pane"),
    ),
    ActionSpec(
        "show_report",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Go to the report"),
        ("Ctrl+3",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Go to pane"),
    ),
    ActionSpec(
        "show_queue",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Go to the queue"),
        ("Ctrl+4",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Go to pane"),
    ),
    ActionSpec(
        "show_analog",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Go to the analog channels"),
        ("Ctrl+5",),
        "document",
        submenu=QT_TRANSLATE_NOOP("Actions", "Go to pane"),
    ),
    ActionSpec(
        "show_smooth",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Go to smoothing"),
        ("Ctrl+6",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Go to pane"),
    ),
    ActionSpec(
        "show_history",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Go to the history"),
        ("Ctrl+Shift+H",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Go to pane"),
    ),
    ActionSpec(
        "show_labels",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Go to the labels"),
        ("Ctrl+Shift+L",),
        submenu=QT_TRANSLATE_NOOP("Actions", "Go to pane"),
    ),
    ActionSpec(
        "next_document",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Next recording"),
        ("Ctrl+Tab", "Ctrl+PgDown"),
        "several",
        starts_group=True,
    ),
    ActionSpec(
        "previous_document",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Previous recording"),
        ("Ctrl+Shift+Tab", "Ctrl+PgUp"),
        "several",
    ),
    ActionSpec(
        "theme_system",
        "View",
        QT_TRANSLATE_NOOP("Actions", "As the system"),
        (),
        "nothing",
        checkable=True,
        starts_group=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Theme"),
    ),
    ActionSpec(
        "theme_light",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Light"),
        (),
        "nothing",
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Theme"),
    ),
    ActionSpec(
        "theme_dark",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Dark"),
        (),
        "nothing",
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Theme"),
    ),
    ActionSpec(
        "language_system",
        "View",
        QT_TRANSLATE_NOOP("Actions", "As the system"),
        (),
        "nothing",
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Language"),
    ),
    ActionSpec(
        "language_en",
        "View",
        QT_TRANSLATE_NOOP("Actions", "English"),
        (),
        "nothing",
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Language"),
    ),
    ActionSpec(
        "language_zh_CN",
        "View",
        QT_TRANSLATE_NOOP("Actions", "中文"),
        (),
        "nothing",
        checkable=True,
        submenu=QT_TRANSLATE_NOOP("Actions", "Language"),
    ),
    ActionSpec(
        "text_larger",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Larger"),
        ("Ctrl++", "Ctrl+="),
        "nothing",
        submenu=QT_TRANSLATE_NOOP("Actions", "Text size"),
    ),
    ActionSpec(
        "text_smaller",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Smaller"),
        ("Ctrl+-",),
        "nothing",
        submenu=QT_TRANSLATE_NOOP("Actions", "Text size"),
    ),
    ActionSpec(
        "text_normal",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Normal"),
        ("Ctrl+0",),
        "nothing",
        submenu=QT_TRANSLATE_NOOP("Actions", "Text size"),
    ),
    ActionSpec(
        "save_layout",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Save this layout…"),
        (),
        "markers",
        submenu=QT_TRANSLATE_NOOP("Actions", "Layouts"),
    ),
    ActionSpec(
        "first_layout",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Arrange as at first"),
        (),
        "markers",
        submenu=QT_TRANSLATE_NOOP("Actions", "Layouts"),
    ),
    ActionSpec("next_plots", "Plots", QT_TRANSLATE_NOOP("Actions", "Next set of plots"), ("V",)),
    ActionSpec(
        "previous_plots",
        "Plots",
        QT_TRANSLATE_NOOP("Actions", "Previous set of plots"),
        ("Shift+V",),
    ),
    ActionSpec(
        "plot_position",
        "Plots",
        QT_TRANSLATE_NOOP("Actions", "Position: x, y and z"),
        checkable=True,
        starts_group=True,
    ),
    ActionSpec("plot_speed", "Plots", QT_TRANSLATE_NOOP("Actions", "Speed"), checkable=True),
    ActionSpec(
        "plot_acceleration", "Plots", QT_TRANSLATE_NOOP("Actions", "Acceleration"), checkable=True
    ),
    ActionSpec("plot_residual", "Plots", QT_TRANSLATE_NOOP("Actions", "Residual"), checkable=True),
    ActionSpec("plot_bone", "Plots", QT_TRANSLATE_NOOP("Actions", "Bone length"), checkable=True),
    ActionSpec(
        "next_bone", "Plots", QT_TRANSLATE_NOOP("Actions", "Next bone of the marker"), ("B",)
    ),
    ActionSpec(
        "same_scale",
        "Plots",
        QT_TRANSLATE_NOOP("Actions", "Same scale for x, y and z"),
        ("Y",),
        checkable=True,
        starts_group=True,
    ),
    ActionSpec(
        "separate",
        "Plots",
        QT_TRANSLATE_NOOP("Actions", "One set of plots per marker"),
        ("S",),
        checkable=True,
    ),
    ActionSpec(
        "shortcuts",
        "Help",
        QT_TRANSLATE_NOOP("Actions", "Keyboard shortcuts"),
        ("?", "F1"),
        "nothing",
    ),
    ActionSpec(
        "palette",
        "Help",
        QT_TRANSLATE_NOOP("Actions", "Find an action…"),
        ("Ctrl+Shift+P",),
        "nothing",
    ),
    ActionSpec("tour", "Help", QT_TRANSLATE_NOOP("Actions", "Tour"), (), "nothing"),
    ActionSpec("log", "Help", QT_TRANSLATE_NOOP("Actions", "Show the log file"), (), "nothing"),
    ActionSpec("about", "Help", QT_TRANSLATE_NOOP("Actions", "About mocapmend"), (), "nothing"),
)
