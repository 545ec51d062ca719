"""What the methods are called in a paper, and the work that they are taken from."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Source:
    """A method as a paper names it.

    Attributes
    ----------
    phrase : str
        What goes after "filled by".
    references : tuple of str
        The work that the method is taken from, or is an own form of.
    """

    phrase: str
    references: tuple[str, ...] = ()


@dataclass(frozen=True)
class SmoothingSource(Source):
    """A smoothing method as a paper names it; the phrase goes after "smoothed by".

    Attributes
    ----------
    choice : str
        What chooses how much is smoothed, where the user does not.
    """

    choice: str = ""


def _source(phrase: str, *references: str) -> Source:
    return Source(phrase, references)


_GLOERSEN = (
    "Gløersen Ø, Federolf P (2016). Predicting missing marker trajectories in human motion data "
    "using marker intercorrelations. PLoS ONE 11(3):e0152616."
)
_FEDEROLF = "Federolf P (2013). PLoS ONE 8(10):e78689."
_WOLTRING = (
    "Woltring HJ (1986). A Fortran package for generalized, cross-validatory spline smoothing and "
    "differentiation. Advances in Engineering Software 8(2):104–113."
)
_SAVITZKY = (
    "Savitzky A, Golay MJE (1964). Smoothing and differentiation of data by simplified least "
    "squares procedures. Analytical Chemistry 36(8):1627–1639."
)
_RAUCH = (
    "Rauch HE, Tung F, Striebel CT (1965). Maximum likelihood estimates of linear dynamic systems. "
    "AIAA Journal 3(8):1445–1450."
)
_WANG = (
    "Wang, Lu, Han (2018). Distorted human motion capture data recovery based on skeleton "
    "constraint. Computer Systems & Applications 27(5):17–25."
)

SOURCES = {
    "constant": _source("holding the last or next sample"),
    "linear": _source("linear interpolation"),
    "cubic": _source("cubic spline interpolation"),
    "pchip": _source("monotone piecewise cubic interpolation"),
    "woltring": _source(
        "a quintic smoothing spline with generalised cross-validation",
        _WOLTRING,
    ),
    "cyclic": _source("the same phase of neighbouring motion cycles"),
    "rigid": _source(
        "rigid-body motion of markers that keep their distance to the missing one",
        "Kabsch W (1976). A solution for the best rotation to relate two sets of vectors. "
        "Acta Crystallographica A32:922–923.",
    ),
    "pattern": _source("the translation of a donor marker"),
    "local-frame": _source("ridge regression in a frame that moves with other markers"),
    "pca-r1": _source("principal components of all markers, strategy R1", _GLOERSEN, _FEDEROLF),
    "pca-r2": _source("principal components of all markers, strategy R2", _GLOERSEN, _FEDEROLF),
    "burke-lasenby": _source(
        "low-dimensional Kalman smoothing",
        "Burke M, Lasenby J (2016). Estimating missing marker positions using low dimensional "
        "Kalman smoothing. Journal of Biomechanics 49(9):1854–1858.",
    ),
    "tsmc": _source(
        "matrix completion of trajectory segments",
        "Tan, Hou, Chau (2013). Human motion capture data recovery using trajectory-based "
        "matrix completion. Electronics Letters 49(12):752–754.",
    ),
    "pose-code": _source(
        "sparse codes of poses",
        "Xiao, Feng, Zhuang (2013). Chinese patent CN103020984, Zhejiang University.",
    ),
    "bone-dictionary": _source("sparse codes of motion with constant bone lengths", _WANG),
    "smbs": _source(
        "sparse motion bases", "Xiao et al. (2015). Signal Processing 110:108–122.", _WANG
    ),
    "kalman": _source(
        "a constant-velocity Kalman smoother",
        "Wang, Lü, Mu (2021). Techniques of Automation and Applications 40(4):116–119.",
    ),
    "auto": _source(
        "a blend of Gaussian-process regressions on the other markers and on time, weighted for "
        "each gap by tests on hidden stretches",
        "Rasmussen CE, Williams CKI (2006). Gaussian Processes for Machine Learning. MIT Press.",
        "Breiman L (1996). Stacked regressions. Machine Learning 24:49–64.",
    ),
}
"""By method id. Most methods deviate from the papers: the modules of the methods say how."""

SMOOTHING = {
    "butterworth": SmoothingSource(
        "a zero-lag Butterworth low-pass filter",
        (
            "Winter DA (2009). Biomechanics and Motor Control of Human Movement, 4th ed. Wiley.",
            "Mallows CL (1973). Some comments on Cp. Technometrics 15(4):661–675.",
        ),
        "residual analysis",
    ),
    "savgol": SmoothingSource(
        "a Savitzky-Golay filter",
        (_SAVITZKY,),
        "generalised cross-validation",
    ),
    "gcv": SmoothingSource("a quintic spline", (_WOLTRING,), "generalised cross-validation"),
    "kalman-smoother": SmoothingSource(
        "a Kalman smoother of each coordinate",
        (
            _RAUCH,
            "de Jong P (1991). The diffuse Kalman filter. Annals of Statistics 19(2):1073–1083.",
        ),
        "maximum likelihood",
    ),
}
"""By id of the smoothing method."""
