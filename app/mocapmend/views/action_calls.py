"""What the actions of the table do to the files and to the workspace of the open document."""

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from mocapmend.views.file_actions import FileActions
    from mocapmend.views.main_window import MainWindow
    from mocapmend.views.proof_actions import ProofActions
    from mocapmend.views.workspace import Workspace

WINDOW_COMMANDS: "dict[str, Callable[[MainWindow], object]]" = {
    "quit": lambda m: m.close(),
    "next_document": lambda m: m.documents.step(1),
    "previous_document": lambda m: m.documents.step(-1),
    "save_layout": lambda m: m.layouts.ask_and_save(),
    "theme_system": lambda m: m.appearance.choose("system"),
    "theme_light": lambda m: m.appearance.choose("light"),
    "theme_dark": lambda m: m.appearance.choose("dark"),
    "text_larger": lambda m: m.appearance.step_text(1),
    "text_smaller": lambda m: m.appearance.step_text(-1),
    "text_normal": lambda m: m.appearance.step_text(0),
    "shortcuts": lambda m: m.show_shortcuts(),
    "palette": lambda m: m.show_palette(),
    "tour": lambda m: m.start_tour(),
    "log": lambda m: m.show_log(),
    "about": lambda m: m.show_about(),
}
"""By action id."""

FILE_COMMANDS: "dict[str, Callable[[FileActions], object]]" = {
    "open": lambda f: f.ask_and_open(),
    "export": lambda f: f.ask_and_export(),
    "save_report": lambda f: f.ask_and_save_report(),
    "close": lambda f: f.close(),
}
"""By action id."""

PROOF_COMMANDS: "dict[str, Callable[[ProofActions], object]]" = {
    "save_recipe": lambda p: p.ask_and_save_recipe(),
    "replay_recipe": lambda p: p.ask_and_replay(),
    "check_copy": lambda p: p.ask_and_check(),
}
"""By action id."""

COMMANDS: "dict[str, Callable[[Workspace], object]]" = {
    "undo": lambda w: w.document.undo_stack.undo(),
    "redo": lambda w: w.document.undo_stack.redo(),
    "next_gap": lambda w: w.step_gap(1),
    "previous_gap": lambda w: w.step_gap(-1),
    "next_gap_here": lambda w: w.step_gap(1, same_marker=True),
    "previous_gap_here": lambda w: w.step_gap(-1, same_marker=True),
    "next_method": lambda w: w.repair.step_method(1),
    "previous_method": lambda w: w.repair.step_method(-1),
    "apply": lambda w: w.apply_preview(),
    "apply_next": lambda w: w.apply_and_go_on(),
    "fill_all": lambda w: w.fill_all(),
    "clear_fill": lambda w: w.clear_fill(),
    "play": lambda w: w.player.toggle(),
    "next_frame": lambda w: w.step_frames(1),
    "previous_frame": lambda w: w.step_frames(-1),
    "forward": lambda w: w.step_seconds(1.0),
    "back": lambda w: w.step_seconds(-1.0),
    "first_frame": lambda w: w.go_to_frame(0),
    "last_frame": lambda w: w.go_to_frame(w.view.frames - 1),
    "faster": lambda w: w.player.step_speed(1),
    "slower": lambda w: w.player.step_speed(-1),
    "zoom_in": lambda w: w.zoom_time(0.5),
    "zoom_out": lambda w: w.zoom_time(2.0),
    "zoom_all": lambda w: w.zoom_all(),
    "first_layout": lambda w: w.restore_first_layout(),
    "show_timeline": lambda w: w.show_pane(w.timeline),
    "show_repairs": lambda w: w.show_pane(w.repairs),
    "show_report": lambda w: w.show_pane(w.report),
    "show_history": lambda w: w.show_pane(w.history),
    "view_front": lambda w: w.scene.look("front"),
    "view_back": lambda w: w.scene.look("back"),
    "view_left": lambda w: w.scene.look("left"),
    "view_right": lambda w: w.scene.look("right"),
    "view_top": lambda w: w.scene.look("top"),
    "view_oblique": lambda w: w.scene.look("oblique"),
}
"""By action id."""

SWITCHES: "dict[str, Callable[[Workspace, bool], None]]" = {
    "follow": lambda w, on: w.scene.set_follow(on),
    "labels": lambda w, on: w.scene.set_labels(on),
    "trails": lambda w, on: w.scene.set_trails(on),
    "separate": lambda w, on: w.trajectories.set_separate(on),
}
"""By id of a checkable action."""
