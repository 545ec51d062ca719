"""The one table of actions and shortcuts: it makes menus, toolbar and the shortcut help."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from PySide6.QtCore import QCoreApplication, QObject
from PySide6.QtGui import QAction, QKeySequence

from mocapmend.translate import QT_TRANSLATE_NOOP

Menu = Literal["File", "Edit", "Gaps", "Play", "View", "Help"]
MENUS: tuple[Menu, ...] = ("File", "Edit", "Gaps", "Play", "View", "Help")


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
    ActionSpec("next_gap", "Gaps", QT_TRANSLATE_NOOP("Actions", "Next gap"), ("N",)),
    ActionSpec("previous_gap", "Gaps", QT_TRANSLATE_NOOP("Actions", "Previous gap"), ("P",)),
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
        "next_method",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Next method"),
        ("M",),
        starts_group=True,
    ),
    ActionSpec(
        "previous_method", "Gaps", QT_TRANSLATE_NOOP("Actions", "Previous method"), ("Shift+M",)
    ),
    ActionSpec(
        "apply",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Apply the previewed repair"),
        ("Return", "Enter"),
    ),
    ActionSpec(
        "apply_next",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Apply and go to the next gap"),
        ("Shift+Return", "Shift+Enter"),
    ),
    ActionSpec(
        "fill_all",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Fill all gaps up to the limit"),
        ("Ctrl+Return",),
    ),
    ActionSpec(
        "clear_fill",
        "Gaps",
        QT_TRANSLATE_NOOP("Actions", "Turn this repair back into a gap"),
        ("Del",),
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
    ActionSpec("view_front", "View", QT_TRANSLATE_NOOP("Actions", "Front view"), ("Alt+1",)),
    ActionSpec("view_back", "View", QT_TRANSLATE_NOOP("Actions", "Back view"), ("Alt+2",)),
    ActionSpec("view_left", "View", QT_TRANSLATE_NOOP("Actions", "Left view"), ("Alt+3",)),
    ActionSpec("view_right", "View", QT_TRANSLATE_NOOP("Actions", "Right view"), ("Alt+4",)),
    ActionSpec("view_top", "View", QT_TRANSLATE_NOOP("Actions", "Top view"), ("Alt+5",)),
    ActionSpec("view_oblique", "View", QT_TRANSLATE_NOOP("Actions", "Oblique view"), ("Alt+6",)),
    ActionSpec(
        "follow", "View", QT_TRANSLATE_NOOP("Actions", "Follow the body"), ("F",), checkable=True
    ),
    ActionSpec(
        "labels", "View", QT_TRANSLATE_NOOP("Actions", "Marker labels"), ("L",), checkable=True
    ),
    ActionSpec(
        "trails",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Trail of the selection"),
        ("T",),
        checkable=True,
    ),
    ActionSpec(
        "separate",
        "View",
        QT_TRANSLATE_NOOP("Actions", "One set of plots per marker"),
        ("S",),
        checkable=True,
        starts_group=True,
    ),
    ActionSpec(
        "zoom_in", "View", QT_TRANSLATE_NOOP("Actions", "Zoom in on the time axis"), ("+", "=")
    ),
    ActionSpec(
        "zoom_out", "View", QT_TRANSLATE_NOOP("Actions", "Zoom out on the time axis"), ("-",)
    ),
    ActionSpec("zoom_all", "View", QT_TRANSLATE_NOOP("Actions", "Whole recording"), ("0",)),
    ActionSpec(
        "show_timeline",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Go to the timeline"),
        ("Ctrl+1",),
        starts_group=True,
    ),
    ActionSpec(
        "show_repairs", "View", QT_TRANSLATE_NOOP("Actions", "Go to the repairs"), ("Ctrl+2",)
    ),
    ActionSpec(
        "show_report", "View", QT_TRANSLATE_NOOP("Actions", "Go to the report"), ("Ctrl+3",)
    ),
    ActionSpec(
        "show_history",
        "View",
        QT_TRANSLATE_NOOP("Actions", "Go to the history"),
        ("Ctrl+Shift+H",),
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


def text_of(spec: ActionSpec) -> str:
    """Return what the user reads, in the user's language."""
    return QCoreApplication.translate("Actions", spec.text)


def submenu_of(spec: ActionSpec) -> str:
    """Return what the user reads of an action's submenu, in the user's language."""
    return QCoreApplication.translate("Actions", spec.submenu) if spec.submenu else ""


def standard_keys(spec: ActionSpec) -> list[QKeySequence]:
    """Return the keys of the table."""
    # By their texts: a key that is listed twice is ambiguous, and then does nothing.
    sequences = [QKeySequence(key) for key in spec.keys]
    # Some platforms have no key for some standard keys.
    return list({keys.toString(): keys for keys in sequences if not keys.isEmpty()}.values())


def set_keys(spec: ActionSpec, action: QAction, keys: Sequence[QKeySequence]) -> None:
    """Give an action keys, and a tool tip that tells them."""
    action.setShortcuts(keys)
    texts = ", ".join(key_texts(action))
    action.setToolTip(f"{text_of(spec)} ({texts})" if texts else text_of(spec))


def make_actions(parent: QObject) -> Mapping[str, QAction]:
    """Make the QAction of every entry of the table."""
    made = {}
    for spec in ACTIONS:
        action = QAction(text_of(spec), parent)
        action.setObjectName(spec.id)
        action.setCheckable(spec.checkable)
        set_keys(spec, action, standard_keys(spec))
        made[spec.id] = action
    return made


def key_texts(action: QAction) -> list[str]:
    """Return an action's shortcuts as this platform writes them."""
    native = QKeySequence.SequenceFormat.NativeText
    return [keys.toString(native) for keys in action.shortcuts() if not keys.isEmpty()]
