use std::fs;
use std::path::Path;

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::json;

use super::*;
use crate::grade::provenance::{GradingInputs, Tool};

/// Declares a type whose schema is in `outcome.schema.json`.
macro_rules! reference {
    ($name:ident, $definition:literal) => {
        pub struct $name;

        impl JsonSchema for $name {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                $definition.into()
            }

            fn inline_schema() -> bool {
                true
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!({ "$ref": concat!("outcome.schema.json#/$defs/", $definition) })
            }
        }
    };
}

reference!(StatusReference, "Status");
reference!(SceneReference, "SceneOutcome");

/// A graded submission with these points.
pub fn graded(id: &str, points: u32, possible: u32) -> Record {
    let mut got = Outcome::new("Assignment", id.into(), "bubblewrap");
    (got.points, got.possible) = (Some(points), possible);
    Record {
        id: id.into(),
        status: Status::Graded,
        explanation: String::new(),
        got,
        remarks: Vec::new(),
        fresh_scenes: Vec::new(),
        most_for_scenes: None,
        needs: Default::default(),
        tokens: BTreeMap::new(),
        provenance: Provenance {
            answers: Vec::new(),
            made_with: GradingInputs {
                judged_on: "public goldens only".into(),
                seed: None,
                goldens: String::new(),
                fresh: None,
                assignment: String::new(),
                tool: Tool {
                    version: String::new(),
                    sha256: String::new(),
                    rustc: String::new(),
                },
                sandbox: "bubblewrap".into(),
                timeout: 10,
                reveal: None,
            },
        },
        timings: Timings::default(),
    }
}

#[test]
fn the_committed_schema_is_that_of_the_type() {
    let generator = SchemaSettings::draft2020_12().into_generator();
    let mut schema = generator.into_root_schema_for::<Record>();
    schema.insert("allOf".into(), json!([{ "$ref": "outcome.schema.json" }]));
    let text = serde_json::to_string_pretty(&schema).expect("it can be written") + "\n";
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../schema/result.schema.json");
    if std::env::var_os("UPDATE_SCHEMAS").is_some() {
        fs::write(&path, &text).expect("it can be written");
    }
    let committed = fs::read_to_string(&path).unwrap_or_default();
    let again = "UPDATE_SCHEMAS=1 cargo test -p pinhole-instructor schema";
    assert_eq!(committed, text, "if this is meant, run: {again}");
}
