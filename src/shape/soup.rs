use serde::{Deserialize, Serialize};
use toml::Spanned;

use super::{Notation, ObjectTable, Triangle};
use crate::error::Error;
use crate::film::Samples;
use crate::mesh;

/// Triangles that together are one object.
///
/// Generic over what it holds so that a soup can be judged separately from the triangle:
/// question films fill it with [`Canned`](crate::Canned) objects.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TriangleSoup<T = Triangle> {
    /// In the mesh file's order, which says nothing about distance.
    pub triangles: Vec<T>,
}

impl Notation for TriangleSoup {
    const KEYS: &'static [&'static str] = &["obj"];
    const FILE_KEYS: &'static [&'static str] = &["obj"];

    fn read_table(table: &ObjectTable<'_>) -> Result<TriangleSoup, Error> {
        let obj: Spanned<String> = table.get("obj")?;
        // If the mesh can't be read at all, the error points at the line that names it.
        let mesh = mesh::read(&table.folder().join(obj.get_ref()));
        let corners = mesh.map_err(|error| match error.position {
            Some(_) => error,
            None => table.source.error(
                obj.span(),
                format!("{}: {}", error.path.display(), error.problem),
                error.remedy,
            ),
        })?;
        let triangles = corners.into_iter().map(|corners| Triangle { corners });
        Ok(TriangleSoup {
            triangles: triangles.collect(),
        })
    }

    /// A pixel has no room for a mesh.
    fn read_samples(_: Samples<'_>) -> Result<TriangleSoup, String> {
        Err("no question film holds a mesh; ask about it with `kind = \"soup\"`".into())
    }

    fn words(&self, _: usize) -> String {
        format!("of {} triangles", self.triangles.len())
    }
}
