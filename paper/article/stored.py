# SPDX-License-Identifier: MIT
"""Values of stored files, and a text whose numbers are references to them.

A reference is written <<file: key>> or <<file: key | format>>, with the file's path from the project's folder on:

    <<paper/orders.json: orders[case=fick].value | .2f>>

A key is names separated by points, each followed by selectors in brackets, if it is a list: a number counts from 0, and conditions
name=text, several with a semicolon between them, keep what fulfils them (name~text: what contains the text). A name with points in it
stands in quotes. What is asked for must be there once. Formats are Python's (.2f), after a factor if one is given (*1000 .0f); % is a
factor of 100 with its sign, date the day of a time, text words, short the first letters of an identity, and count the number of elements
of a list. Without a format a number has three digits.

<<table: name>> and <<derived: name>> are functions of tables.py.
"""
import functools
import json
import math
import pathlib
import re

try:
    import tomllib
except ImportError:  # Python before 3.11
    import tomli as tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
REFERENCE = re.compile(r"<<(.*?)>>", re.DOTALL)
STEP = re.compile(r'\.?("[^"]*"|[^."\[\]]+)|\[([^\]]*)\]')


class Unknown(Exception):
    """What a reference asks for is not there, or not once."""


@functools.lru_cache(maxsize=None)
def read(path):
    """The content of a stored file of the project, by its path from the project's folder on."""
    file = ROOT / path
    if not file.is_file():
        raise Unknown("no such file")
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".json":
        return json.loads(text)
    if file.suffix == ".toml":
        return tomllib.loads(text)
    if file.suffix == ".cff":  # flat lines are all that is asked for
        return dict(re.findall(r'^(?:  - )?(\w[\w-]*): "?(.*?)"?$', text, re.MULTILINE)[::-1])
    raise Unknown("neither .json nor .toml nor .cff")


def chosen(values, selector):
    """The elements of a list that a selector keeps; one element for a number."""
    if not isinstance(values, list):
        raise Unknown(f"[{selector}] of what is no list")
    if selector.isdigit():
        if int(selector) >= len(values):
            raise Unknown(f"[{selector}] of {len(values)} elements")
        return values[int(selector)]
    for condition in selector.split(";"):
        name, sign, wanted = re.fullmatch(r"\s*([^=~]+)([=~])(.*)", condition).groups()
        if sign == "=":
            values = [v for v in values if as_text(value_at(v, name)) == wanted]
        else:
            values = [v for v in values if wanted in as_text(value_at(v, name))]
    return values


def as_text(value):
    return json.dumps(value) if isinstance(value, (bool, type(None))) else str(value)


def value_at(value, key):
    """What stands at a key of a value; a list of which one element is left counts as that element."""
    end = 0
    for step in STEP.finditer(key):
        if step.start() != end:
            break
        end = step.end()
        name, selector = step.groups()
        if name is None:
            value = chosen(value, selector)
            continue
        name = name.strip('"')
        if isinstance(value, list):
            value = only(value)
        if not isinstance(value, dict) or name not in value:
            raise Unknown(f"no '{name}' there")
        value = value[name]
    if end != len(key):
        raise Unknown(f"cannot read the key from '{key[end:]}' on")
    return value


def only(values):
    if len(values) != 1:
        raise Unknown(f"{len(values)} elements fit, not one")
    return values[0]


def get(path, key):
    """The value at a key of a stored file."""
    return value_at(read(path), key)


def escaped(text):
    """Plain text as TeX."""
    text = re.sub(r"[\\{}]", "", str(text))
    text = re.sub(r"([&%$#])", r"\\\1", text).replace("~", r"\textasciitilde{}").replace("->", r"$\to$")
    text = re.sub(r"\^(\([^)]*\)|-?\w+)", r"\\textsuperscript{\1}", text).replace("^", r"\textasciicircum{}")
    text = text.replace(">=", r"$\ge$").replace("<=", r"$\le$").replace("+-", r"$\pm$").replace("<", "$<$").replace(">", "$>$")
    text = re.sub(rf"(?<![A-Za-z_])({GREEK}|[A-Za-z])_(\w+)", index, text)
    text = re.sub(rf"(?<![A-Za-z\\_])({GREEK})(?![A-Za-z_])", r"$\\\1$", text)
    return re.sub(r"(?<!\\)_(?!\{)", r"\\_", text).replace(" - ", " $-$ ").replace(r" \%", r"\,\%")


GREEK = "alpha|beta|theta|kappa|lambda|tau|eta|rho|nu|sigma"


def index(match):
    """A symbol with an index, as theta_out."""
    symbol = "\\" + match[1] if len(match[1]) > 1 else match[1]
    return rf"${symbol}_{{\mathrm{{{match[2]}}}}}$"


def code(text):
    """A name of the program's as TeX."""
    return r"\code{" + str(text).replace("_", r"\_") + "}"


def shown(number, form=".3g"):
    """A number as TeX: no bare exponents, a true minus sign."""
    if number is None or not math.isfinite(number):
        raise Unknown("is not a finite number")
    text = format(number, form)
    if "e" in text and 1e-3 <= abs(number) < 1e5:
        text = f"{float(text):.10f}".rstrip("0").rstrip(".")
    if "e" in text:
        mantissa, exponent = text.split("e")
        power = rf"10^{{{int(exponent)}}}"
        return f"${power}$" if mantissa == "1" else rf"${mantissa}\times{power}$"
    return text.replace("-", "$-$")


def formatted(value, form):
    if form == "count":
        if not isinstance(value, list):
            raise Unknown("is no list to count")
        return str(len(value))
    if isinstance(value, list):
        value = only(value)
    if form == "text":
        return escaped(as_text(value))
    if form == "short":
        return as_text(value)[:6]
    if form == "date":
        if not re.match(r"\d{4}-\d\d-\d\d", str(value)):
            raise Unknown("is no date")
        return str(value)[:10]
    if isinstance(value, str):
        try:
            value = float(value)
        except ValueError:
            raise Unknown("is text: it needs the format text") from None
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise Unknown("is no number")
    factor, digits, percent = re.fullmatch(r"(?:\*([\d.e+-]+)\s*)?([+,.\w]*)(%?)", form or "").groups()
    number = value * float(factor or 1) * (100 if percent else 1)
    return shown(number, digits or ".3g") + (r"\,\%" if percent else "")


def filled(text, name, functions):
    """The text with each reference replaced. `functions` has what tables.py offers, as {"table": {...}, "derived": {...}}.

    Raises Unknown with file, line and reference of the first that leads nowhere.
    """

    def replace(match):
        reference = " ".join(match[1].split())
        line = text.count("\n", 0, match.start()) + 1
        try:
            place, _, rest = reference.partition(": ")
            if place in functions:
                if rest not in functions[place]:
                    raise Unknown("no such function in tables.py")
                return functions[place][rest]()
            key, _, form = rest.partition(" | ")
            return formatted(get(place, key.strip()), form.strip())
        except (Unknown, ValueError, AttributeError, KeyError) as error:
            raise Unknown(f"{name}:{line}: <<{reference}>>: {error}") from error

    return REFERENCE.sub(replace, text)


# What may hold a number that is no reference: names (Debian 12), places in the paper (Eq. 19), numbers quoted from a source, what LaTeX
# itself reads, formulas set apart, and digits that are an index or a power.
ALLOWED = re.compile(
    r"(?<!\\)%[^\n]*"
    r"|<<.*?>>"
    r"|\\begin\{(equation|align)\*?\}.*?\\end\{\1\*?\}"
    r"|\\(?:name|paper|quoted|ref|label|cite|url|input|chart|photo|begin|end|code)(?:\[[^\]]*\])?\{[^{}]*\}(?:\{[^{}]*\})?"
    r"|\\href\{[^{}]*\}|P\{[^{}]*\}|\\cmidrule\([lr]*\)\{[^{}]*\}|\\multicolumn\{\d\}|\\textsuperscript\{\d\}"
    r"|[_^](?:\{[^{}]*\}|\w)",
    re.DOTALL)
PLACES = re.compile(r"\(?(?:[Ff]igures?|[Tt]ables?|Sec\.|Secs\.|Eq\.|Eqs\.)[~ ]")


def bare_numbers(text):
    """(line, what stands there) of each number in the text that is neither a reference nor one of the forms that are allowed."""

    def blank(match):
        if match[0].startswith(r"\paper{") and not PLACES.match(match[0][7:]):
            return match[0]
        return re.sub(r"[^\n]", " ", match[0])

    left = ALLOWED.sub(blank, text)
    return [(left.count("\n", 0, m.start()) + 1, m[0]) for m in re.finditer(r"[A-Za-z]*\d[\w.,]*(?:[-+]\d+)?", left)]
