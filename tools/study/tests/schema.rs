//! The document against its schema: as much of JSON Schema as that uses.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// What is wrong, and where.
fn faults(
    value: &Value,
    schema: &Value,
    root: &Value,
    place: &str,
    faults_so_far: &mut Vec<String>,
) {
    if let Some(name) = schema["$ref"].as_str() {
        let target = root
            .pointer(name.trim_start_matches('#'))
            .expect("the schema is whole");
        return faults(value, target, root, place, faults_so_far);
    }
    let mut fault = |what: &str| faults_so_far.push(format!("{place}: {what}: {value}"));
    if schema.get("const").is_some_and(|wanted| wanted != value) {
        fault("another constant");
    }
    if schema["enum"]
        .as_array()
        .is_some_and(|allowed| !allowed.contains(value))
    {
        fault("none of the allowed words");
    }
    let is_of = |kind: &Value| match kind.as_str() {
        Some("object") => value.is_object(),
        Some("array") => value.is_array(),
        Some("string") => value.is_string(),
        Some("integer") => value.is_i64() || value.is_u64(),
        Some("number") => value.is_number(),
        Some("boolean") => value.is_boolean(),
        Some("null") => value.is_null(),
        other => panic!("the test does not know {other:?}"),
    };
    match &schema["type"] {
        Value::Null => (),
        Value::Array(kinds) if kinds.iter().any(is_of) => (),
        kind if kind.is_string() && is_of(kind) => (),
        _ => fault("another type"),
    }
    if let (Some(fields), Some(known)) = (value.as_object(), schema["properties"].as_object()) {
        for name in schema["required"].as_array().expect("it lists them") {
            let name = name.as_str().expect("a name");
            if !fields.contains_key(name) {
                faults_so_far.push(format!("{place}: {name} is missing"));
            }
        }
        for (name, field) in fields {
            match known.get(name) {
                None => faults_so_far.push(format!("{place}: {name} is unknown")),
                Some(schema) => faults(
                    field,
                    schema,
                    root,
                    &format!("{place}/{name}"),
                    faults_so_far,
                ),
            }
        }
    }
    for (at, item) in value.as_array().into_iter().flatten().enumerate() {
        faults(
            item,
            &schema["items"],
            root,
            &format!("{place}/{at}"),
            faults_so_far,
        );
    }
}

fn all_faults(document: &Value) -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("schema/study-2.json");
    let schema = fs::read_to_string(path).expect("it is committed");
    let schema: Value = serde_json::from_str(&schema).expect("it is JSON");
    let mut found = Vec::new();
    faults(document, &schema, &schema, "", &mut found);
    found
}

/// The real program, on one small part.
fn studied(part: &str) -> (Option<i32>, String, std::path::PathBuf) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(part);
    let output = Command::new(env!("CARGO_BIN_EXE_pinhole-study"))
        .args(["study", "--quick", "--json", "--only", part, "--out"])
        .arg(&folder)
        .output()
        .expect("it runs");
    let said = String::from_utf8(output.stdout).expect("text");
    (output.status.code(), said, folder)
}

#[test]
fn a_document_follows_its_schema_and_a_spoilt_one_does_not() {
    for part in ["flat", "mesh", "scenes", "plans", "secondary"] {
        let (_, said, folder) = studied(part);
        let document: Value = serde_json::from_str(&said).expect("one JSON document");
        assert_eq!(all_faults(&document), Vec::<String>::new());
        let written = fs::read_to_string(folder.join("study.json")).expect("it was written");
        assert_eq!(written, said);
        for list in ["families", "meshes", "scenes", "plans", "secondary"] {
            let Some(first) = document[list].get(0) else {
                continue;
            };
            for (name, value) in first.as_object().expect("an object") {
                let mut spoilt = document.clone();
                spoilt[list][0][name] = match value {
                    Value::Bool(_) => Value::Null,
                    _ => Value::Bool(true),
                };
                assert!(
                    !all_faults(&spoilt).is_empty(),
                    "{list}: {name} may be anything"
                );
            }
        }
    }
}

#[test]
fn an_unknown_family_is_refused_by_name() {
    let (code, said, _) = studied("nonsense");
    let error: Value = serde_json::from_str(&said).expect("an error is a document too");
    let problem = error["error"].as_str().expect("it has words");
    assert!(
        code == Some(2) && problem.contains("nonsense"),
        "{code:?} {said}"
    );
}

#[test]
fn plots_and_the_page_are_written_and_name_each_other() {
    let (_, _, folder) = studied("edge-on");
    let page = fs::read_to_string(folder.join("summary.md")).expect("it was written");
    let name = "triangle-edge-on.svg";
    assert!(page.contains(name), "{name} is not shown");
    let plot = fs::read_to_string(folder.join(name)).expect("it was written");
    assert!(
        plot.contains("<svg") && plot.contains("adaptive exact"),
        "{name} has no labels"
    );
}
