//! The triangles of Wavefront OBJ files, through `tobj`.

use std::io::{self, BufRead, Read};
use std::path::Path;

use glam::DVec3;
use tobj::{LoadError, LoadOptions};

use crate::error::{Error, read_text};

/// The corners of one triangle, in the order of its face.
pub type Corners = [DVec3; 3];

/// Reads every face of an OBJ file as triangles, in file order.
///
/// Polygons become fans around their first corner. Normals, texture coordinates, groups and
/// materials are ignored, because a triangle's normal comes from its corners.
///
/// # Errors
/// If the file cannot be read, is not an OBJ file, or has no face; if a face names a vertex that
/// is not there; or if a vertex is not finite.
pub fn read(path: &Path) -> Result<Vec<Corners>, Error> {
    let text = read_text(path).map_err(|error| {
        Error::new(
            path,
            format!("cannot read this mesh: {error}"),
            "check the `obj` path in the scene; it is relative to the scene's folder",
        )
    })?;
    parse(&text, path)
}

/// What the goldens' reader, in Python, takes for the end of a line or a word, but Rust does not.
const ONLY_IN_PYTHON: [char; 10] = [
    '\r', '\u{b}', '\u{c}', '\u{1c}', '\u{1d}', '\u{1e}', '\u{1f}', '\u{85}', '\u{2028}',
    '\u{2029}',
];

fn parse(text: &str, path: &Path) -> Result<Vec<Corners>, Error> {
    let mut lines = (1..).zip(text.lines());
    if let Some((number, _)) = lines.find(|(_, line)| line.contains(ONLY_IN_PYTHON)) {
        return Err(Error::new(
            path,
            "not all programs agree where this line or its words end",
            "use only spaces between words, and end each line with \\n or \\r\\n",
        )
        .at(number, 1));
    }
    let text = corners_and_faces(text);
    if let Some(error) = absent_vertex(&text, path) {
        return Err(error);
    }
    let options = LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        ..LoadOptions::default()
    };
    let mut lines = CountLines {
        inner: text.as_bytes(),
        line: 0,
    };
    let loaded = tobj::load_obj_buf(&mut lines, &options, |_| Err(LoadError::GenericFailure));
    let (models, _materials) = loaded.map_err(|error| {
        Error::new(
            path,
            format!("this is not a mesh: {error}"),
            "export it again as OBJ",
        )
        .at(lines.line.max(1), 1)
    })?;

    let mut triangles = Vec::new();
    for model in &models {
        let corner =
            |index: &u32| DVec3::from_slice(&model.mesh.positions[3 * *index as usize..][..3]);
        for face in model.mesh.indices.chunks_exact(3) {
            let corners = [corner(&face[0]), corner(&face[1]), corner(&face[2])];
            if !corners.iter().all(|corner| corner.is_finite()) {
                return Err(not_finite(&text, path));
            }
            triangles.push(corners);
        }
    }
    if triangles.is_empty() {
        return Err(Error::new(
            path,
            "this mesh has no faces",
            "add `f` lines, or name another file",
        ));
    }
    Ok(triangles)
}

/// Keeps only vertex positions and the vertex indices of faces. tobj would also make triangles of
/// polylines, divide by a vertex's w, and reject comments after values and texture coordinates that
/// it cannot find. The goldens' reader (tools/mitsuba/mesh.py) does none of that.
fn corners_and_faces(text: &str) -> String {
    let mut kept = String::with_capacity(text.len());
    for line in text.lines() {
        let mut words = line
            .split('#')
            .next()
            .unwrap_or_default()
            .split_whitespace();
        match words.next() {
            Some("v") => {
                kept.push('v');
                words.take(3).for_each(|word| kept.extend([" ", word]));
            }
            Some("f") => {
                let mut vertices = words.map(|word| word.split('/').next().unwrap_or_default());
                if let Some(first) = vertices.next() {
                    kept.extend(["f ", first]);
                    vertices.for_each(|vertex| kept.extend([" ", vertex]));
                }
            }
            _ => {}
        }
        kept.push('\n');
    }
    kept
}

/// The first face that names a vertex that is not yet defined. tobj notices only after the last
/// line, and not at all if the vertex comes later.
fn absent_vertex(text: &str, path: &Path) -> Option<Error> {
    let mut vertices = 0;
    for (number, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => vertices += 1,
            Some("f") => {
                let index = |word: &str| word.parse::<i64>().ok();
                let outside = |index: &i64| *index == 0 || index.unsigned_abs() > vertices;
                if let Some(bad) = words.filter_map(index).find(outside) {
                    let problem =
                        format!("this face names vertex {bad}, but {vertices} vertices precede it");
                    return Some(
                        Error::new(
                            path,
                            problem,
                            "count from 1, and put `v` lines before the face",
                        )
                        .at(number + 1, 1),
                    );
                }
            }
            _ => {}
        }
    }
    None
}

fn not_finite(text: &str, path: &Path) -> Error {
    let is_bad = |line: &str| {
        let mut words = line.split_whitespace();
        words.next() == Some("v")
            && words.any(|word| word.parse::<f64>().is_ok_and(|value| !value.is_finite()))
    };
    let error = Error::new(
        path,
        "a vertex is not finite",
        "replace nan or inf with a number",
    );
    match text.lines().position(is_bad) {
        Some(index) => error.at(index + 1, 1),
        None => error,
    }
}

/// Keeps track of the parser's line, for its error message.
struct CountLines<R> {
    inner: R,
    line: usize,
}

impl<R: BufRead> Read for CountLines<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.inner.read(buffer)
    }
}

impl<R: BufRead> BufRead for CountLines<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.inner.fill_buf()
    }

    // `lines` consumes up to each newline, so one call with data is at most a line.
    fn consume(&mut self, amount: usize) {
        self.line += usize::from(amount > 0);
        self.inner.consume(amount);
    }
}

#[cfg(test)]
mod tests;
