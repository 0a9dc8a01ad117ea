# SPDX-License-Identifier: GPL-2.0-or-later
"""Mutations of inputs: bytes, words, lines of text; bytes of binary files; words of command lines."""
import re

NASTY = ["nan", "inf", "-inf", "1e308", "-1e308", "1e-320", "-1", "0", "1.5", "9223372036854775808", "0x10", "1e", "--",
         "''", "\x00", "\x1b[31m", "é", "1,5", "+", "pp", "ITEM:", "1e6", "99999999999999999999"]


def flip_bit(data, rng):
    k = rng.randrange(len(data))
    return data[:k] + bytes([data[k] ^ (1 << rng.randrange(8))]) + data[k + 1:]


def delete_byte(data, rng):
    k = rng.randrange(len(data))
    return data[:k] + data[k + 1:]


def insert_byte(data, rng):
    k = rng.randrange(len(data) + 1)
    return data[:k] + bytes([rng.choice([rng.randrange(256), ord(rng.choice("0123456789.-e \n"))])]) + data[k:]


def cut(data, rng):
    return data[:rng.randrange(len(data))]


def zero_block(data, rng):
    k, size = rng.randrange(len(data)), rng.choice([1, 8, 64, 512])
    return data[:k] + bytes(len(data[k:k + size])) + data[k + size:]


def doubled_part(data, rng):
    k = rng.randrange(len(data))
    part = data[k:k + rng.choice([1, 8, 64, 512])]
    return data[:k] + part + data[k:]


def change_digit(data, rng):
    digits = [m.start() for m in re.finditer(rb"[0-9]", data)]
    k = rng.choice(digits)
    other = rng.choice([d for d in b"0123456789" if d != data[k]])
    return data[:k] + bytes([other]) + data[k + 1:]


def _word(data, rng):
    return rng.choice(list(re.finditer(rb"[^\s,]+", data)))


def nasty_word(data, rng):
    m = _word(data, rng)
    return data[:m.start()] + rng.choice(NASTY).encode() + data[m.end():]


def scaled_word(data, rng):
    numbers = list(re.finditer(rb"(?<![^\s,])-?[0-9][^\s,]*", data))
    m = rng.choice(numbers)
    try:
        value = float(m.group()) * rng.choice([-1, 2, 10, 1e6, 1e-6, 1.001]) + rng.choice([0, 0, 1])
    except ValueError:
        return change_digit(data, rng)
    return data[:m.start()] + f"{value:.10g}".encode() + data[m.end():]


def delete_word(data, rng):
    m = _word(data, rng)
    return data[:m.start()] + data[m.end():]


def swap_words(data, rng):
    a, b = sorted((_word(data, rng), _word(data, rng)), key=lambda m: m.start())
    if a.start() == b.start():
        return delete_word(data, rng)
    return data[:a.start()] + b.group() + data[a.end():b.start()] + a.group() + data[b.end():]


def _lines(change):
    def mutation(data, rng):
        lines = data.splitlines(keepends=True)
        change(lines, rng)
        return b"".join(lines)
    mutation.__name__ = change.__name__
    return mutation


def delete_line(lines, rng):
    del lines[rng.randrange(len(lines))]


def double_line(lines, rng):
    k = rng.randrange(len(lines))
    lines.insert(k, lines[k])


def swap_lines(lines, rng):
    a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[a], lines[b] = lines[b], lines[a]


BINARY = [flip_bit, delete_byte, insert_byte, cut, zero_block, doubled_part]
TEXT = [flip_bit, delete_byte, insert_byte, cut, change_digit, change_digit, nasty_word, nasty_word, scaled_word,
        scaled_word, delete_word, swap_words, _lines(delete_line), _lines(double_line), _lines(swap_lines)]


def no_number(words, rng):
    """A number of the command line becomes something that is none; the program must refuse it."""
    places = [k for k, word in enumerate(words) if re.fullmatch(r"-?[0-9][0-9.e-]*", word)]
    place = rng.choice(places)
    words[place] = rng.choice(["nan", "inf", "-inf", "", "x", "1e999", "1,2", "0x", "1..2", "--1"])
    return not (words[place] == "1,2" and words[place - 1] == "--bulk-types")  # a list of types


def misspelt(words, rng):
    """An option or a verb with a letter too many; the program must refuse it."""
    k = rng.choice([k for k, word in enumerate(words) if re.match(r"--[a-z]", word) or k == 0])
    at = rng.randrange(3, len(words[k]) + 1)
    words[k] = words[k][:at] + rng.choice("qzx") + words[k][at:]
    return True


def other_number(words, rng):
    places = [k for k, word in enumerate(words) if re.fullmatch(r"-?[0-9][0-9.e-]*", word)]
    words[rng.choice(places)] = rng.choice(["0", "-1", "-.5", "1e-300", "1e300", "1e9", "3", "0.5", "2147483648", "-0"])
    return False


def without_a_word(words, rng):
    del words[rng.randrange(len(words))]
    return False


def word_twice(words, rng):
    k = rng.randrange(len(words))
    words.insert(k, words[k])
    return False


def two_words_swapped(words, rng):
    a, b = rng.randrange(len(words)), rng.randrange(len(words))
    words[a], words[b] = words[b], words[a]
    return False


COMMAND_LINE = [no_number, no_number, misspelt, other_number, other_number, without_a_word, word_twice, two_words_swapped]
