"""The menus, the steps of the tour and the tabs of several recordings."""

from functools import partial

from PySide6.QtWidgets import QMenu

from screens.stage import Stage, settle

STEPS = 6


def menus(stage: Stage, when: str) -> None:
    """Open each menu, and each menu inside it."""
    bar = stage.window.menuBar()
    for number, action in enumerate(bar.actions()):
        menu = action.menu()
        assert isinstance(menu, QMenu)
        corner = bar.mapToGlobal(bar.actionGeometry(action).bottomLeft())
        stage.dialog(f"menu_{when}_{number}", partial(menu.popup, corner))
        inner = [sub for each in menu.actions() if isinstance(sub := each.menu(), QMenu)]
        for place, sub in enumerate(inner):
            stage.dialog(f"menu_{when}_{number}_{place}", partial(sub.popup, corner))


def tour(stage: Stage) -> None:
    """Show the steps of the tour, from the start of the program."""
    window = stage.window
    window.start_tour()
    settle()
    stage.shoot("tour_1")
    stage.open_sample("sprint_basketball")
    for step in range(2, STEPS + 1):
        settle()
        stage.shoot(f"tour_{step}")
        tour = window._tour  # noqa: SLF001 - what a click on its button does
        assert tour is not None
        tour.callout.next_button.click()
    stage.close_all()


def tabs(stage: Stage) -> None:
    """Show several recordings, one of them with edits."""
    stage.open_sample("walk_cmu_02_01")
    stage.shoot("complete")
    stage.show_pane(stage.workspace.queue)
    stage.shoot("queue_empty")
    stage.open_sample("gait_plug_in_gait")
    stage.do("never_fill")
    stage.shoot("tabs")
    stage.dialog("unsaved_on_quit", stage.window.close)
