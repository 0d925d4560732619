# SPDX-License-Identifier: MIT
"""Builds the wheel of clipscope with CMake, for pip: PEP 517 without any further package.

It takes pybind11 (2.10 or later) and numpy from the system, so pip must not isolate the build:

    pip install . --no-build-isolation
"""

import base64
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def _project() -> dict:
    return tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def _build() -> pathlib.Path:
    """Configures and builds what the package needs; the folder of the build."""
    build = ROOT / "build" / "wheel"
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    options = {
        "CMAKE_BUILD_TYPE": "Release",
        "CLIPSCOPE_PROGRAM": "OFF",
        "CLIPSCOPE_BATCH": "ON",
        "CLIPSCOPE_PYTHON": "REQUIRED",
        "Python_EXECUTABLE": sys.executable,
    }
    given = [f"-D{name}={value}" for name, value in options.items()]
    subprocess.run(["cmake", *generator, "-S", ROOT, "-B", build, *given], check=True)
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
    target = "clipscope_python_all"
    subprocess.run(["cmake", "--build", build, "--parallel", jobs, "--target", target], check=True)
    return build


def _install(build: pathlib.Path, prefix: pathlib.Path) -> pathlib.Path:
    """Installs the component `python` of a build; the folder that then holds the package."""
    subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", prefix], check=True)
    return next(prefix.rglob("clipscope/__init__.py")).parents[1]


def _tag() -> str:
    version = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{version}-{version}-{platform}"


def _metadata(project: dict) -> str:
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {project['name']}",
        f"Version: {project['version']}",
        f"Summary: {project['description']}",
        f"License: {project['license']['text']}",
        f"Requires-Python: {project['requires-python']}",
        *(f"Requires-Dist: {needed}" for needed in project["dependencies"]),
    ]
    return "\n".join(lines) + "\n"


def _write_info(folder: pathlib.Path, project: dict) -> None:
    folder.mkdir()
    (folder / "METADATA").write_text(_metadata(project))
    wheel = f"Wheel-Version: 1.0\nGenerator: clipscope\nRoot-Is-Purelib: false\nTag: {_tag()}\n"
    (folder / "WHEEL").write_text(wheel)
    shutil.copy(ROOT / "spaces" / "LICENSE", folder / "LICENSE.MIT")
    shutil.copy(ROOT / "LICENSE", folder / "LICENSE.GPL")


def _record_line(name: str, content: bytes) -> str:
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def _zip(stage: pathlib.Path, info: str, file: pathlib.Path) -> None:
    record = ""
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path in sorted(p for p in stage.rglob("*") if p.is_file()):
            inside = path.relative_to(stage).as_posix()
            wheel.write(path, inside)
            record += _record_line(inside, path.read_bytes())
        wheel.writestr(f"{info}/RECORD", record + f"{info}/RECORD,,\n")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """config_settings: build-dir: the folder of a build that is there already, to be used as it is."""
    project = _project()
    base = f"{project['name']}-{project['version']}"
    name = f"{base}-{_tag()}.whl"
    given = (config_settings or {}).get("build-dir")
    build = pathlib.Path(given) if given else _build()
    with tempfile.TemporaryDirectory() as folder:
        stage = _install(build, pathlib.Path(folder))
        _write_info(stage / f"{base}.dist-info", project)
        _zip(stage, f"{base}.dist-info", pathlib.Path(wheel_directory) / name)
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("clipscope has no source distribution: use its git repository")
