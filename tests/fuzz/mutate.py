"""Seeded mutations of cases, JSON files and HDF5 runs. HDF5 files are changed through its own library, so that they are
sound HDF5 of wrong content: what is tested is our reader."""
import json
import math

NUMBERS = [0, -0.0, 1, -1, 2, 3, 0.5, -0.3, 1e-9, 1e-3, 10, 1e3, 1e6, 1e9, 1e18, -1e18, 1e100, -1e100, 1e200, 1e300, 1e308, -1e308,
           1e-100, 1e-300, 5e-324, 2**31 - 1, 2**31, 2**32 + 1, 2**53, 2**63 - 1, -(2**31) - 1]
FORMULA_PARTS = ["t", "d", "d0", "k", "c", "pi", "_pi", "1", "0", "0.5", "0,5", "1e308", "1e-308", "+", "-", "*", "/", "^", "(", ")",
                 "sin(", "exp(", "log(", "sqrt(", "min(", ",", "?", ":", "<", "==", "=", "&&", " ", "\"", "t/0", "1/t", "k*(d0-d)"]
TEXTS = ["", " ", "nan", "inf", "-inf", "0x10", "1 m", "1e400", "8 kPa", "-3 um", "1e-400 s", "true", "é", "\x00", "\x7f", "../x", "/", "a" * 5000]


def number(draw):
    """An interesting number, or any."""
    if draw.random() < 0.7:
        return draw.choice(NUMBERS)
    return draw.choice([1, -1]) * 10 ** draw.uniform(-12, 12)


def formula(draw):
    return "".join(draw.choice(FORMULA_PARTS) for _ in range(draw.randint(1, 9)))


def toml(value):
    """`value` as it stands in a case."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return "nan" if math.isnan(value) else repr(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, list):
        return "[" + ", ".join(toml(v) for v in value) + "]"
    return json.dumps(value)


def case_value(draw, parameter):
    """Something for this key of `supple list --json`: of its kind most often."""
    kind = type(parameter["default"])
    if draw.random() < 0.08:
        return draw.choice([draw.choice(TEXTS), True, [1, 2], number(draw), float("nan"), float("inf")])
    if parameter.get("choices"):
        return draw.choice(parameter["choices"])
    if kind is bool:
        return draw.random() < 0.5
    if kind is int:
        return draw.choice([0, 1, 2, 3, 5, 17]) if draw.random() < 0.6 else int(number(draw))
    if kind is float:
        value = parameter["default"] * 10 ** draw.uniform(-2, 2) if draw.random() < 0.5 else number(draw)
        return float(value)
    return formula(draw) if parameter["name"] in ("rate", "elastic_expression") else draw.choice(TEXTS)


def bytes_of(draw, text):
    """Damages any text: bytes changed, cut out, doubled, or its end lost."""
    data = bytearray(text, "utf-8")
    for _ in range(draw.randint(1, 4)):
        if not data:
            break
        at = draw.randrange(len(data))
        what = draw.random()
        if what < 0.4:
            data[at] = draw.choice(b"0123456789-+.eE\"'[]{},:=\n #\x00\xff") if draw.random() < 0.8 else draw.randrange(256)
        elif what < 0.6:
            del data[at:at + draw.randint(1, 20)]
        elif what < 0.8:
            data[at:at] = data[at:at + draw.randint(1, 40)]
        else:
            del data[at:]
    return bytes(data)


def places(value, path=()):
    """Every place in nested lists and objects: (container, key)."""
    found = []
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else []
    for key, below in items:
        found.append((value, key))
        found += places(below)
    return found


def json_value(draw, root):
    """Changes one to three values, lists or keys of parsed JSON."""
    for _ in range(draw.randint(1, 3)):
        all_places = places(root)
        if not all_places:
            return
        container, key = draw.choice(all_places)
        old, what = container[key], draw.random()
        if what < 0.6:
            container[key] = number(draw) if draw.random() < 0.9 else draw.choice([None, True, "x", [], {}, [1, 2, 3], -1])
        elif what < 0.75:
            del container[key]
        elif isinstance(container, list):
            container.insert(draw.randrange(len(container) + 1), old)
        elif isinstance(old, list) and old:
            draw.shuffle(old)
        else:
            container[str(key) + "x"] = container.pop(key)


def members(group, found):
    """Every dataset and group below `group`."""
    for name in group:
        found.append((group, name))
        if hasattr(group[name], "keys"):
            members(group[name], found)
    return found


def resized(draw, values):
    """An array with another length of one axis, or other numbers of axes."""
    import numpy as np
    if values.ndim == 0 or draw.random() < 0.2:
        return np.resize(values, (draw.randint(0, 3),) * draw.randint(1, 3))
    shape = list(values.shape)
    axis = draw.randrange(values.ndim)
    shape[axis] = max(0, draw.choice([0, 1, shape[axis] - 1, shape[axis] + 1, 2 * shape[axis]]))
    return np.resize(values, shape)


def spoiled(draw, values):
    """An array with a few other numbers."""
    import numpy as np
    out = np.array(values, copy=True)
    flat = out.reshape(-1)
    for _ in range(draw.randint(1, 3)):
        if flat.size == 0:
            break
        new = draw.choice([number(draw), float("nan"), float("inf")]) if out.dtype.kind == "f" else int(number(draw))
        if out.dtype.kind in "iu":
            limits = np.iinfo(out.dtype)
            new = min(max(new, limits.min), limits.max)
        flat[draw.randrange(flat.size)] = new
    return out


def hdf5_file(draw, path):
    """Changes one to three datasets, groups or attributes of a run file."""
    import h5py
    import numpy as np
    with h5py.File(path, "r+") as file:
        for _ in range(draw.randint(1, 3)):
            group, name = draw.choice(members(file, []))
            item, what = group[name], draw.random()
            attributes = list(item.attrs) + list(file.attrs)
            if what < 0.15:
                del group[name]
            elif what < 0.3 and attributes:
                key = draw.choice(attributes)
                owner = item if key in item.attrs else file
                new = draw.choice([number(draw), draw.choice(TEXTS).replace("\x00", ""), [1, 2, 3]])
                owner.attrs[key] = float(new) if isinstance(new, int) else new
                if draw.random() < 0.3:
                    del owner.attrs[key]
            elif isinstance(item, h5py.Dataset):
                values, kept = item[()], dict(item.attrs)
                number_kind = isinstance(values, (np.ndarray, np.generic)) and np.asarray(values).dtype.kind in "fiu"
                if not number_kind:
                    values = draw.choice(TEXTS).replace("\x00", "")
                elif what < 0.7:
                    values = spoiled(draw, np.asarray(values))
                elif what < 0.9:
                    values = resized(draw, np.asarray(values))
                else:
                    values = np.asarray(values).astype(draw.choice(["f4", "i8", "u1", "S3"]))
                del group[name]
                group.create_dataset(name, data=values)
                for key, value in kept.items():
                    group[name].attrs[key] = value
