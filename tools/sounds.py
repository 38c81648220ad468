# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the short sounds of the window, resources/sounds/*.wav: `python tools/sounds.py`.

Each is a few sine tones with soft ends, so that no two are taken for each other: alarm alternates, end rises, pause is
two equal ones, a part beyond the work surface is one low one.
"""

from __future__ import annotations

import math
import wave
from io import BytesIO
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[1] / "resources" / "sounds"
RATE_HZ = 11_025
LOUD = 0.5  # of the most
SOFT_S = 0.01  # at both ends of a tone: without it a click is heard
SOUNDS = {  # tones: Hz (0 is silence) and s
    "alarm": ((880, 0.12), (587, 0.12), (880, 0.12), (587, 0.12)),
    "end": ((523, 0.12), (659, 0.12), (784, 0.24)),
    "pause": ((659, 0.12), (0, 0.08), (659, 0.12)),
    "beyond": ((247, 0.4),),
}


def sound(tones: tuple[tuple[int, float], ...]) -> bytes:
    """Return the WAV file of some tones: one channel, 8 bits."""
    samples = b"".join(_tone(frequency_hz, length_s) for frequency_hz, length_s in tones)
    data = BytesIO()
    with wave.open(data, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(1)
        file.setframerate(RATE_HZ)
        file.writeframes(samples)
    return data.getvalue()


def _tone(frequency_hz: int, length_s: float) -> bytes:
    count, soft = round(length_s * RATE_HZ), SOFT_S * RATE_HZ
    turn = math.tau * frequency_hz / RATE_HZ
    return bytes(
        round(127.5 + 127.0 * LOUD * min(1.0, n / soft, (count - n) / soft) * math.sin(turn * n)) for n in range(count)
    )


def main() -> None:
    """Write all sounds."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name, tones in SOUNDS.items():
        (FOLDER / f"{name}.wav").write_bytes(sound(tones))


if __name__ == "__main__":
    main()
