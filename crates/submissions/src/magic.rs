/// The format of a file that begins with `bytes`, when it is one that gets handed in by mistake.
pub(crate) fn format(bytes: &[u8]) -> Option<&'static str> {
    const FORMATS: [(&[u8], &str); 24] = [
        (b"PK\x03\x04", ZIP),
        (b"PK\x05\x06", ZIP),
        (b"PK\x07\x08", ZIP),
        (b"Rar!\x1a\x07", "a RAR archive"),
        (b"7z\xbc\xaf\x27\x1c", "a 7-Zip archive"),
        (b"\x1f\x8b", "a gzip file"),
        (b"BZh", "a bzip2 file"),
        (b"\xfd7zXZ\0", "an xz file"),
        (b"\x28\xb5\x2f\xfd", "a Zstandard file"),
        (b"MSCF", "a cabinet archive"),
        (b"xar!", "a xar archive"),
        (b"!<arch>\n", "a library or Debian package"),
        (b"%PDF-", "a PDF"),
        (b"{\\rtf", "a rich text document (RTF)"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "an old Word, Excel or PowerPoint document"),
        (b"\x7fELF", "a compiled program"),
        (b"MZ", "a compiled program"),
        (b"\xcf\xfa\xed\xfe", "a compiled program"),
        (b"\x89PNG\r\n\x1a\n", "a picture (PNG)"),
        (b"\xff\xd8\xff", "a picture (JPEG)"),
        (b"GIF8", "a picture (GIF)"),
        (b"bplist00", "a Mac property list"),
        (b"<!DOCTYPE html", "a web page"),
        (b"<html", "a web page"),
    ];
    if bytes.get(257..262) == Some(b"ustar") {
        return Some("a tar archive");
    }
    FORMATS.iter().find(|(magic, _)| bytes.starts_with(magic)).map(|(_, name)| *name)
}

/// How many bytes [`format`] looks at.
pub(crate) const LOOKS_AT: usize = 262;

const ZIP: &str = "a zip archive";

/// Whether a file that begins with `bytes` is a zip archive.
pub(crate) fn is_zip(bytes: &[u8]) -> bool {
    format(bytes) == Some(ZIP)
}
