"""Parameters that describe themselves, and the list of methods."""

import dataclasses
import json
from typing import Literal, get_args, get_origin, get_type_hints

import pytest

from mocapmend_algorithms.fill.registry import METHODS, method, parse_params, restore_params
from mocapmend_algorithms.params import (
    option,
    parse,
    restore,
    training_names,
    training_option,
)


@dataclasses.dataclass(frozen=True)
class Example:
    count: int = option(3, label="Count", text="How many.", minimum=1, maximum=9)
    size: float | None = option(None, label="Size", text="How big.", minimum=0.5, unit="mm")
    loud: bool = option(False, label="Loud", text="Whether to shout.")
    way: Literal["up", "down"] = option("up", label="Way", text="Where to.")
    names: tuple[str, ...] = option((), label="Names", text="Whose.")


@dataclasses.dataclass(frozen=True)
class Nothing:
    """No parameters."""


def test_the_methods_and_their_order():
    interpolations = ["constant", "linear", "cubic", "pchip", "woltring", "cyclic"]
    donors = ["rigid", "pattern", "local-frame"]
    low_rank = ["pca-r1", "pca-r2", "burke-lasenby", "tsmc"]
    sparse = ["pose-code", "bone-dictionary", "smbs"]
    assert list(METHODS) == [*interpolations, *donors, *low_rank, *sparse, "kalman", "auto"]
    for key, entry in METHODS.items():
        assert entry.id == key
        assert entry.label
        assert entry.help.endswith(".")
        assert method(key) is entry


def test_unknown_methods_are_answered_with_the_list():
    with pytest.raises(KeyError, match=", ".join(METHODS)):
        method("magic")


def test_a_form_can_be_made_of_every_parameter():
    for entry in METHODS.values():
        defaults = entry.params()
        hints = get_type_hints(entry.params)
        for field in dataclasses.fields(entry.params):
            assert set(field.metadata) == {"label", "help", "min", "max", "unit", "training"}
            assert field.metadata["label"]
            assert field.metadata["help"].endswith(".")
            hint, value = hints[field.name], getattr(defaults, field.name)
            kinds = (*get_args(hint), get_origin(hint), hint)
            assert value in kinds or (value is None and type(None) in kinds) or type(value) in kinds
        with pytest.raises(dataclasses.FrozenInstanceError):
            defaults.anything = 1


def test_text_becomes_parameters():
    assert parse(Example, {}) == Example()
    pairs = {"count": " 5 ", "size": "2.5", "loud": "Yes", "way": "down"}
    assert parse(Example, pairs) == Example(5, 2.5, True, "down")
    for word in ("auto", "None", "automatic", ""):
        assert parse(Example, {"size": word}).size is None
    assert parse(Example, {"names": " a b, c,,a b "}).names == ("a b", "c")
    assert parse(Example, {"names": "Automatic"}).names == ()
    kalman = METHODS["kalman"]
    assert parse_params(kalman, {"noise_mm": "0.5"}) == kalman.params(noise_mm=0.5)


@pytest.mark.parametrize(
    "params",
    [Example(), Example(5, 2.5, True, "down", ("a, b", "")), Example(size=0.1 + 0.7)],
    ids=repr,
)
def test_a_dictionary_becomes_the_same_parameters(params: Example):
    assert restore(Example, json.loads(json.dumps(dataclasses.asdict(params)))) == params


@pytest.mark.parametrize(
    "values", [{"count": 2.5}, {"count": []}, {"size": "wide"}, {"other": 1}, {"count": 99}]
)
def test_a_wrong_dictionary_is_refused(values: dict[str, object]):
    with pytest.raises(ValueError, match=r"must (not )?be|no parameter"):
        restore(Example, values)


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        (
            "weight",
            "1",
            "there is no parameter 'weight'; the parameters are: count, size, loud, way, names",
        ),
        ("count", "2.5", "count must be a whole number, not '2.5'"),
        ("count", "0", "count must be at least 1, not 0"),
        ("count", "10", "count must be at most 9, not 10"),
        ("size", "big", "size must be a number, not 'big'"),
        ("size", "nan", "size must be a number, not 'nan'"),
        ("size", "0.1", "size must be at least 0.5 mm, not 0.1"),
        ("loud", "maybe", "loud must be true or false, not 'maybe'"),
        ("way", "left", "way must be one of up, down, not 'left'"),
    ],
)
def test_wrong_text_is_answered_with_one_sentence(name, text, message):
    with pytest.raises(ValueError) as caught:
        parse(Example, {name: text})
    assert str(caught.value) == message


def test_a_method_without_parameters_says_so():
    with pytest.raises(ValueError, match="the parameters are: none"):
        parse(Nothing, {"hold": "after"})


@pytest.mark.parametrize("entry", METHODS.values(), ids=METHODS)
def test_what_older_files_say_of_parameters_is_understood(entry):
    # The parameters of version 0.1; those that came later have their defaults.
    known = {"constant": {"hold": "after"}, "kalman": {"direction": "causal", "noise_mm": None}}
    made = restore_params(entry, known.get(entry.id, {}))
    assert made == entry.params(**known.get(entry.id, {}))
    assert restore_params(entry, dataclasses.asdict(made)) == made


@pytest.mark.parametrize("entry", METHODS.values(), ids=METHODS)
def test_the_texts_among_the_parameters_are_training_sets(entry):
    texts = {name for name, hint in get_type_hints(entry.params).items() if hint is str}
    assert texts == set(training_names(entry.params))


@dataclasses.dataclass(frozen=True)
class Taught:
    training: str = training_option("What to learn from.")


def test_a_training_set_is_a_text_as_it_was_given():
    assert Taught().training == ""
    assert training_names(Taught) == ("training",)
    assert training_names(Example) == ()
    made = parse(Taught, {"training": " My walks, two=2.npz "})
    assert made.training == "My walks, two=2.npz"
    assert restore(Taught, json.loads(json.dumps(dataclasses.asdict(made)))) == made
