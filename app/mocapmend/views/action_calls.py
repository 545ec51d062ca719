"""What the actions of the table do to the files and to the workspace of the open document."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from mocapmend.views import language

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
    "language_system": lambda m: language.choose("system", m),
    "language_en": lambda m: language.choose("en", m),
    "language_zh_CN": lambda m: language.choose("zh_CN", m),
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
    "refine": lambda f: f.refining.ask(),
}
"""By action id."""

PROOF_COMMANDS: "dict[str, Callable[[ProofActions], object]]" = {
    "save_recipe": lambda p: p.ask_and_save_recipe(),
    "replay_recipe": lambda p: p.ask_and_replay(),
    "save_plan": lambda p: p.ask_and_save_plan(),
    "load_plan": lambda p: p.ask_and_load_plan(),
    "check_copy": lambda p: p.ask_and_check(),
}
"""By action id."""


def _candidate(number: int) -> "Callable[[Workspace], object]":
    return lambda w: w.repair.pick_candidate(number)


COMMANDS: "dict[str, Callable[[Workspace], object]]" = {
    "undo": lambda w: w.undo(),
    "redo": lambda w: w.redo(),
    "rename": lambda w: w.rename(),
    "exchange_names": lambda w: w.naming.renaming.exchange_names(),
    "this_is": lambda w: w.naming.ask_label(),
    "next_nameless": lambda w: w.naming.by_hand.step(),
    "label_from": lambda w: w.naming.ask_recordings(),
    "apply_labels": lambda w: w.naming.pane.apply(),
    "next_gap": lambda w: w.gap_actions.step(1),
    "previous_gap": lambda w: w.gap_actions.step(-1),
    "next_gap_here": lambda w: w.gap_actions.step_here(1),
    "previous_gap_here": lambda w: w.gap_actions.step_here(-1),
    "select_all": lambda w: w.select_all(),
    "select_none": lambda w: w.view.select(()),
    "select_in_view": lambda w: w.scene.select_in_view(add=False),
    "add_in_view": lambda w: w.scene.select_in_view(add=True),
    "search_bad": lambda w: w.search.search(),
    "fix_problem": lambda w: w.bad_actions.fix(),
    "fix_kind": lambda w: w.bad_actions.fix_kind(),
    "fix_all": lambda w: w.bad_actions.fix_all(),
    "dismiss_problem": lambda w: w.bad_actions.dismiss(),
    "set_aside": lambda w: w.bad_actions.set_aside(),
    "believe": lambda w: w.bad_actions.believe(),
    "exchange": lambda w: w.bad_actions.exchange(),
    "next_method": lambda w: w.repair.step_method(1),
    "previous_method": lambda w: w.repair.step_method(-1),
    "apply": lambda w: w.apply(go_on=False),
    "apply_next": lambda w: w.apply(go_on=True),
    "leave_open": lambda w: w.gap_actions.leave_open(),
    "never_fill": lambda w: w.gap_actions.never_fill(),
    "explain_gap": lambda w: w.ask_why_open(),
    "widen": lambda w: w.gap_actions.widen(1),
    "narrow": lambda w: w.gap_actions.widen(-1),
    "plan": lambda w: w.show_plan(),
    "fill_all": lambda w: w.fill_all(),
    "smooth": lambda w: w.smooth.apply(),
    "unsmooth": lambda w: w.smooth.take_off(),
    "clear_fill": lambda w: w.gap_actions.reopen(),
    **{f"candidate_{number}": _candidate(number) for number in range(1, 9)},
    "play": lambda w: w.player.toggle(),
    "next_frame": lambda w: w.step_frames(1),
    "previous_frame": lambda w: w.step_frames(-1),
    "forward": lambda w: w.step_seconds(1.0),
    "back": lambda w: w.step_seconds(-1.0),
    "first_frame": lambda w: w.go_to_frame(0),
    "last_frame": lambda w: w.go_to_frame(w.view.frames - 1),
    "faster": lambda w: w.player.step_speed(1),
    "slower": lambda w: w.player.step_speed(-1),
    "next_event": lambda w: w.time.step_event(1),
    "previous_event": lambda w: w.time.step_event(-1),
    "select_from": lambda w: w.time.select_from_here(),
    "select_to": lambda w: w.time.select_to_here(),
    "select_no_frames": lambda w: w.view.set_span(None),
    "zoom_in": lambda w: w.zoom_time(0.5),
    "zoom_out": lambda w: w.zoom_time(2.0),
    "zoom_all": lambda w: w.zoom_all(),
    "show_queue": lambda w: w.show_pane(w.queue),
    "compare_with": lambda w: w.comparing.ask(),
    "end_comparing": lambda w: w.comparing.end(),
    "zoom_gap": lambda w: w.time.frame_gap(),
    "zoom_span": lambda w: w.time.zoom_to_span(),
    "next_page": lambda w: w.time.turn_page(1),
    "previous_page": lambda w: w.time.turn_page(-1),
    "show_timeline": lambda w: w.show_pane(w.timeline),
    "show_repairs": lambda w: w.show_pane(w.repairs),
    "show_report": lambda w: w.show_pane(w.report),
    "turn_left": lambda w: w.scene.turn(-1, 0),
    "turn_right": lambda w: w.scene.turn(1, 0),
    "turn_up": lambda w: w.scene.turn(0, 1),
    "turn_down": lambda w: w.scene.turn(0, -1),
    "nearer": lambda w: w.scene.approach(1),
    "farther": lambda w: w.scene.approach(-1),
    "centre_marker": lambda w: w.scene.centre_on(w.view.marker),
    "longer_trails": lambda w: w.step_trails(1),
    "shorter_trails": lambda w: w.step_trails(-1),
    "show_analog": lambda w: w.show_analog(),
    "next_plots": lambda w: w.plots.step_plots(1),
    "previous_plots": lambda w: w.plots.step_plots(-1),
    "next_bone": lambda w: w.plots.step_bone(1),
    "first_layout": lambda w: w.restore_first_layout(),
    "show_smooth": lambda w: w.show_pane(w.smooth),
    "show_history": lambda w: w.show_pane(w.history),
    "show_labels": lambda w: w.show_pane(w.naming.pane),
    "view_front": lambda w: w.scene.look("front"),
    "view_back": lambda w: w.scene.look("back"),
    "view_left": lambda w: w.scene.look("left"),
    "view_right": lambda w: w.scene.look("right"),
    "view_top": lambda w: w.scene.look("top"),
    "view_oblique": lambda w: w.scene.look("oblique"),
}
"""By action id."""

SWITCHES: "dict[str, Callable[[Workspace, bool], None]]" = {
    "compare": lambda w, on: w.repair.set_comparing(on),
    "pick_donors": lambda w, on: w.pick_donors(on),
    "follow": lambda w, on: w.scene.set_follow(on),
    "sticks": lambda w, on: w.scene.set_layer("sticks", on),
    "segments": lambda w, on: w.scene.set_layer("segments", on),
    "labels": lambda w, on: w.scene.set_layer("labels", on),
    "trails": lambda w, on: w.scene.set_layer("trails", on),
    "all_trails": lambda w, on: w.scene.set_layer("all_trails", on),
    "before_after": lambda w, on: w.scene.set_layer("before_after", on),
    "companion": lambda w, on: w.comparing.set_shown(on),
    "measure": lambda w, on: w.scene.set_layer("measure", on),
    "ground": lambda w, on: w.scene.set_layer("ground", on),
    "plates": lambda w, on: w.scene.set_layer("plates", on),
    "separate": lambda w, on: w.trajectories.set_separate(on),
    "plot_position": lambda w, on: w.plots.show_plots("plot_position", on),
    "plot_speed": lambda w, on: w.plots.show_plots("plot_speed", on),
    "plot_acceleration": lambda w, on: w.plots.show_plots("plot_acceleration", on),
    "plot_residual": lambda w, on: w.plots.show_plots("plot_residual", on),
    "plot_bone": lambda w, on: w.plots.show_plots("plot_bone", on),
    "same_scale": lambda w, on: w.plots.set_same_scale(on),
    "loop": lambda w, on: w.player.set_loop(on),
    "most_missing_first": lambda w, on: w.time.set_most_missing_first(on),
}
"""By id of a checkable action."""
