# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of the manual's worked parts anew, docs/pictures/parts, in both languages; then look at them.

Each is the program's own picture of the proof of a job file in examples/jobs. Part of `make pictures`; with names of
parts only those.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from unittest.mock import patch

from manual import CATALOGUES, DOCS, PARTS, ROOT, Catalogue, localized_name
from pictures import kept
from PIL import Image

from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.prove import prove_job
from CNCStepper.job.turning.make_turning import make_turning
from CNCStepper.job.turning.prove_turning import prove_turning
from CNCStepper.job.turning.turning_job import load_turning_job
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.processes import is_turning
from CNCStepper.quantities import duration_text
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.views.picture_style import TEXTS
from CNCStepper.workbench.services.choice_labels import WORDS as CHOICES

JOBS, KEPT = ROOT / "examples" / "jobs", DOCS / "pictures" / "parts"
WIDTH, COLOURS = 1200, 128  # of a picture in pixels, and of its palette: a page is not wider
PORTUGUESE = {  # of TEXTS; pictures of the command line are in English
    "isometric": "Vista isométrica",
    "xy": "Vista XY, de cima",
    "zy": "Vista ZY, ao longo do eixo X",
    "depth": "Mapa de profundidades",
    "plan": "Profundidade e trajetória, vistas de cima",
    "height": "altura sobre o topo do bloco (mm)",
    "rapids": "rápido",
    "feeds": "avanço",
    "arcs": "arco",
    "plunges": "mergulho",
    "zero": "zero-peça",
    "cutter": "ferramenta",
    "limits": "limites do curso",
    "workpiece": "bloco",
    "fallen": "peça solta",
    "tool": "ferramenta {text}",
    "time": "tempo {text}",
    "moment": "em {text} de {whole}, linha {line}",
    "moves": "{count} movimentos",
    "stock": "bloco {x:g} × {y:g} × {z:g} mm",
    "volume": "removido {volume:.4g} cm³",
    "bar": "barra ø{diameter:g} × {length:g} mm",
    "raw": "barra bruta",
    "part": "peça cortada",
    "wanted": "perfil desejado",
    "chuck": "placa",
    "diameter": "X como diâmetro (mm)",
    "radius": "X como raio (mm)",
}
WORDS = {"en": {}, "pt_BR": PORTUGUESE}


@dataclass(frozen=True)
class WorkedPart:
    """A worked part after its proof: the planned time of all of its programs, what was found, and its picture.

    draw: takes the file, the title, and the language's catalogue.
    """

    time_s: float
    findings: Sequence[Finding]
    draw: Callable[[Path, str, Catalogue], None]


def work(name: str) -> WorkedPart:
    """Return a part whose program was made from its job file and proven."""
    path = JOBS / f"{name}.toml"
    return work_lathe(path) if is_turning(read_toml(path)) else work_table(path)


def work_table(path: Path) -> WorkedPart:
    """Return the part of a job of a table."""
    job, machine = load_job(path)
    proof = prove_job(job, machine, make_program(job, machine, path.stem).program, f"{path.stem}.nc")

    def draw(file: Path, title: str, said: Catalogue) -> None:
        tools = (f"{said.tr(CHOICES[tool.shape])} {tool.diameter_mm:g} mm" for tool in job.tool)
        proof.draw(file, title, ", ".join(dict.fromkeys(tools)))

    return WorkedPart(proof.report["time_s"], proof.findings, draw)


def work_lathe(path: Path) -> WorkedPart:
    """Return the part of a job of a lathe, after all of its programs."""
    job, machine = load_turning_job(path)
    proofs = list(prove_turning(job, machine, make_turning(job, machine), path.parent))
    time_s, verdict = sum(each.proof.report["time_s"] for each in proofs), proofs[-1].verdict

    def draw(file: Path, title: str, said: Catalogue) -> None:
        words = {number: tool.words.translated(said.core) for number, tool in job.tools.items()}
        tools = {number: replace(tool, words=words[number]) for number, tool in verdict.setup.tools.items()}
        shown = replace(verdict, setup=replace(verdict.setup, tools=tools))
        shown.draw(file, title, duration_text(time_s))

    return WorkedPart(time_s, [finding for each in proofs for finding in each.proof.findings], draw)


def keep(name: str) -> None:
    """Work one part and keep its pictures."""
    keep_pictures(work(name), KEPT / f"{name}.png", {language: title(name, language) for language in CATALOGUES})


def keep_pictures(part: WorkedPart, file: Path, titles: Mapping[str, str]) -> None:
    """Keep the picture of a part in each language with its title; ends with its findings when it may not be cut."""
    if errors := [str(finding) for finding in part.findings if finding.severity == "error"]:
        sys.exit("\n".join(errors))
    for language, heading in titles.items():
        with tempfile.TemporaryDirectory() as folder, patch.dict(TEXTS, WORDS[language]):
            drawn = Path(folder) / "part.png"
            part.draw(drawn, heading, Catalogue(language))
            with Image.open(drawn) as picture:
                small = kept(picture, WIDTH, COLOURS)
            small.save(file.with_name(localized_name(file.name, language)), optimize=True)


def title(name: str, language: str) -> str:
    """Return the heading of a part in the page of the worked parts, behind its number."""
    page = DOCS / "manual" / localized_name("worked-parts.md", language)
    headings = [line.partition(". ")[2] for line in page.read_text("utf-8").split("\n") if line.startswith("## ")]
    return headings[PARTS.index(name)]


if __name__ == "__main__":
    KEPT.mkdir(exist_ok=True)
    for chosen in sys.argv[1:] or PARTS:
        keep(chosen)
