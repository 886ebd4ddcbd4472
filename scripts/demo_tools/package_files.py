"""Files of Debian packages, installed or not."""
import gzip
import os
import subprocess
import tarfile
import tempfile


def read_package_files(package, paths):
    """The content of files of a Debian package, as a list in the order of `paths`.

    Images of machines that are made small drop /usr/share/doc at installation, and a package
    need not be installed for a few pictures: what is not on the disk is read from the .deb.
    """
    contents = {path: _read_installed(path) for path in paths}
    if None in contents.values():
        contents = _read_from_deb(package, set(paths))
    return [contents[path] for path in paths]


def _unpacked(name, content):
    return gzip.decompress(content) if name.endswith(".gz") else content


def _read_installed(path):
    for name in (path, path + ".gz"):
        if os.path.exists(name):
            with open(name, "rb") as file:
                return _unpacked(name, file.read())
    return None


def _read_from_deb(package, paths):
    contents = {}
    with tempfile.TemporaryDirectory() as folder:
        # apt's own user, which downloads, has to get in.
        os.chmod(folder, 0o777)
        print("  downloading the package %s" % package, flush=True)
        subprocess.run(["apt-get", "download", package], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL)
        (deb,) = os.listdir(folder)
        with subprocess.Popen(["dpkg-deb", "--fsys-tarfile", os.path.join(folder, deb)],
                              stdout=subprocess.PIPE) as process:
            with tarfile.open(fileobj=process.stdout, mode="r|") as archive:
                for member in archive:
                    path = member.name.lstrip(".")
                    if path.endswith(".gz") and path[:-3] in paths:
                        path = path[:-3]
                    if path in paths:
                        contents[path] = _unpacked(member.name, archive.extractfile(member).read())
    missing = sorted(paths - contents.keys())
    if missing:
        raise FileNotFoundError("the package %s has no %s" % (package, ", ".join(missing)))
    return contents
