"""The system libraries that Qt's wheels expect on Linux, found by loading them."""

import ctypes
import importlib.util
import os
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterable, Sequence

from steps import SetupError, step

# What the wheels' own files need: `readelf -d` on QtGui, QtWidgets and the platform plugins.
OFFSCREEN = {
    "libEGL.so.1": "libegl1",
    "libGL.so.1": "libgl1",
    "libX11.so.6": "libx11-6",
    "libdbus-1.so.3": "libdbus-1-3",
    "libfontconfig.so.1": "libfontconfig1",
    "libgthread-2.0.so.0": "libglib2.0-0",
    "libxkbcommon.so.0": "libxkbcommon0",
}
X11 = {
    "libX11-xcb.so.1": "libx11-xcb1",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-glx.so.0": "libxcb-glx0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-image.so.0": "libxcb-image0",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-randr.so.0": "libxcb-randr0",
    "libxcb-render-util.so.0": "libxcb-render-util0",
    "libxcb-render.so.0": "libxcb-render0",
    "libxcb-shape.so.0": "libxcb-shape0",
    "libxcb-shm.so.0": "libxcb-shm0",
    "libxcb-sync.so.1": "libxcb-sync1",
    "libxcb-util.so.1": "libxcb-util1",
    "libxcb-xfixes.so.0": "libxcb-xfixes0",
    "libxcb-xkb.so.1": "libxcb-xkb1",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
}
WAYLAND = {
    "libwayland-client.so.0": "libwayland-client0",
    "libwayland-cursor.so.0": "libwayland-cursor0",
    "libwayland-egl.so.1": "libwayland-egl1",
}
INSTALL = ("install", "--yes", "--no-install-recommends")


def has_display() -> bool:
    """Tell whether a window can be opened."""
    if sys.platform != "linux":
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def needed(*, window: bool) -> dict[str, str]:
    """Return the libraries for drawing off screen, or for the window system in use.

    Parameters
    ----------
    window : bool
        Whether a window is to be opened.

    Returns
    -------
    dict
        File name of each library, and the Debian package that holds it.
    """
    wanted = dict(OFFSCREEN)
    if window and os.environ.get("DISPLAY"):
        wanted |= X11
    if window and os.environ.get("WAYLAND_DISPLAY"):
        wanted |= WAYLAND
    return wanted


def loads(name: str) -> bool:
    """Tell whether the dynamic loader finds a library."""
    try:
        ctypes.CDLL(name)
    except OSError:
        return False
    return True


def provide(*, window: bool, new_environment: bool) -> None:
    """Install the missing libraries, or say which command does.

    Parameters
    ----------
    window : bool
        Whether a window is to be opened.
    new_environment : bool
        Whether a virtual environment has to be made, for which Debian's Python lacks a part.

    Raises
    ------
    SetupError
        Something is missing and cannot be installed from here.
    """
    if sys.platform != "linux":
        return
    missing = {name: package for name, package in needed(window=window).items() if not loads(name)}
    if new_environment and importlib.util.find_spec("ensurepip") is None:
        major, minor = sys.version_info[:2]
        missing["ensurepip (a part of Python)"] = f"python{major}.{minor}-venv"
    if missing:
        install(missing.keys(), sorted(set(missing.values())))


def install(names: Iterable[str], packages: Sequence[str]) -> None:
    """Install Debian packages where that is allowed.

    Parameters
    ----------
    names : iterable of str
        What is missing, for the message.
    packages : sequence of str
        The packages that hold it.

    Raises
    ------
    SetupError
        No apt-get, no right to use it, or it failed.
    """
    listing = ", ".join(names)
    if shutil.which("apt-get") is None:
        raise SetupError(
            f"Missing on this system: {listing}.\nInstall them with the system's package manager "
            f"(on Debian the packages are: {' '.join(packages)}) and run the same command again."
        )
    rights = administrator()
    if rights is None:
        raise SetupError(f"Missing on this system: {listing}.\n{advice(packages)}")
    if not apt(rights, packages):
        raise SetupError(f"The system packages could not be installed. {advice(packages)}")


def administrator() -> list[str] | None:
    """Return what to put before a command to run it as root: nothing, sudo, or None if barred."""
    if os.geteuid() == 0:
        return []
    sudo = ["sudo", "-n"]
    if shutil.which("sudo") and subprocess.call([*sudo, "true"], stderr=subprocess.DEVNULL) == 0:
        return sudo
    return None


def advice(packages: Sequence[str]) -> str:
    """Return the sentence that names the command a person has to run."""
    line = f"apt-get update && apt-get {shlex.join([*INSTALL, *packages])}"
    if os.geteuid() != 0:
        line = f"{'sudo sh' if shutil.which('sudo') else 'su'} -c {shlex.quote(line)}"
    return f"Run this command, then try again:\n    {line}"


def apt(rights: Sequence[str], packages: Sequence[str]) -> bool:
    """Refresh the package lists and install; wait for another apt-get to finish first.

    A failed refresh is not the end: the lists at hand may still do.
    """
    prefix = [*rights, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get"]
    prefix += ["-o", "DPkg::Lock::Timeout=300", "-o", "Acquire::Retries=3"]
    step("Refreshing the list of system packages", [*prefix, "update"])
    return step("Installing system packages", [*prefix, *INSTALL, *packages])
