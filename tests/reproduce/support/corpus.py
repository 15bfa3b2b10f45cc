# SPDX-License-Identifier: MIT
"""Real meshes of pinned packages of the Python index: robots, furniture, tools, food, scans. None of them is shipped."""
import hashlib
import subprocess
import zipfile

from support.peer_environment import ROOT, Skipped, environment

PACKAGES = {'example_robot_data': '6.0.0', 'pybullet': '3.2.7', 'gymnasium_robotics': '1.4.2', 'dm_control': '1.0.50',
            'robosuite': '1.5.2'}
FOLDER = ROOT / 'build' / 'corpus'
KINDS = ('.stl', '.obj')


def package(name, folder=FOLDER):
    """The folder with the meshes of a package, brought at the first time. @raises Skipped."""
    target = folder / name
    if (target / 'done').exists():
        return target
    target.mkdir(parents=True, exist_ok=True)
    pip = [environment(), '-m', 'pip', 'download', '--quiet', '--disable-pip-version-check', '--no-deps', '--retries', '1']
    made = subprocess.run([*pip, '--dest', target, f'{name}=={PACKAGES[name]}'], capture_output=True, text=True, check=False)
    wheels = list(target.glob('*.whl'))
    if made.returncode != 0 or not wheels:
        raise Skipped(f'{name} {PACKAGES[name]}: ' + (made.stderr.strip().splitlines() or ['no wheel'])[-1])
    with zipfile.ZipFile(wheels[0]) as archive:
        archive.extractall(target, [entry for entry in archive.namelist() if entry.lower().endswith(KINDS)])
    wheels[0].unlink()
    (target / 'done').touch()
    return target


def meshes(skipped, folder=FOLDER):
    """(name, path) of all different files of all packages, in the order of their hashes: a shuffle that everybody repeats.
    What could not be had goes to the list `skipped`."""
    found = {}
    for name in PACKAGES:
        try:
            place = package(name, folder)
        except Skipped as reason:
            skipped.append(str(reason))
            continue
        for path in sorted(place.rglob('*')):
            if path.suffix.lower() in KINDS:
                digest = hashlib.sha256(path.read_bytes()).hexdigest()
                found.setdefault(digest, (f'{name}/{path.relative_to(place).as_posix().rsplit("/", 1)[-1]}', path))
    return [found[digest] for digest in sorted(found)]
