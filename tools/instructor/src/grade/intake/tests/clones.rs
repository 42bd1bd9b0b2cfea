//! Clones from GitHub, which `--named` tells from a class.

use super::hostile::{all_of, placed_among};
use super::*;

#[test]
fn a_repository_with_names_of_others_in_it_brings_nobody_their_work() {
    let github = |id: &str, login: &str| Person {
        id: id.into(),
        name: id.into(),
        github: Some(login.into()),
        ..Person::default()
    };
    let people = [github("1001", "ada"), github("1002", "eve")];
    for (inside, named) in [("1001/", "hw1-{github}"), ("hw1-ada/", "hw1-{github}")] {
        let export = Export::new();
        export.put_all("hw1-eve", answers(inside, "mallory"));
        export.put("hw1-eve.zip", &zip(&answers(inside, "mallory")));
        let wrapped = answers(&format!("hw1-eve/{inside}"), "mallory");
        export.put("clones.zip", &zip(&wrapped));
        for path in ["hw1-eve", "hw1-eve.zip", "clones.zip"] {
            let found = placed_among(&export, &[path], &people, named);
            assert_eq!(all_of(&found, "1001"), [""; 0], "{:#?}", found.1);
            let told = found.0.entries.iter().any(|entry| !entry.doubts.is_empty());
            let is_hers = all_of(&found, "1002").len() == 1;
            assert!(told || is_hers, "{:#?}", found.0);
        }
    }
}

#[test]
fn accounts_that_nobody_knows_hide_no_class() {
    let mut people = [
        Person {
            id: "1001".into(),
            github: Some("ada".into()),
            ..Person::default()
        },
        Person {
            id: "1002".into(),
            ..Person::default()
        },
    ];
    let export = Export::new();
    let mut all = answers("hw1-ada/src/", "ada");
    all.extend((0..4).flat_map(|k| answers(&format!("hw1-zz{k}/src/"), "mallory")));
    for top in ["", "hw1-submissions/"] {
        let wrapped = all
            .iter()
            .map(|(path, text)| (format!("{top}{path}"), text.clone()));
        export.put("hw1-submissions.zip", &zip(&wrapped.collect::<Vec<_>>()));
        let found = placed_among(&export, &["hw1-submissions.zip"], &people, "hw1-{github}");
        assert_eq!(
            all_of(&found, "1001"),
            ["// sphere by ada"],
            "{:#?}",
            found.1
        );
        assert_eq!(found.1.unknown.len(), 4, "{:#?}", found.1);
    }
    // What stands behind a login may do so before the ending of an archive.
    let clones = ["ada", "zz1", "zz2", "zz3"].map(|login| {
        let clone = zip(&answers("", login));
        (format!("hw1-{login}-main.zip"), clone)
    });
    export.put("clones.zip", &zip(&clones));
    let found = placed_among(&export, &["clones.zip"], &people, "hw1-{github}-main");
    assert_eq!(
        all_of(&found, "1001"),
        ["// sphere by ada"],
        "{:#?}",
        found.1
    );
    // As GitHub writes it.
    let own = zip(&answers("hw1-ada-main/src/", "ada"));
    export.put("hw1-ada-main.zip", &own);
    let found = placed_among(&export, &["hw1-ada-main.zip"], &people, "hw1-{github}-main");
    assert_eq!(
        all_of(&found, "1001"),
        ["// sphere by ada"],
        "{:#?}",
        found.1
    );
    // A class's folder may be called like a clone. Then nobody is certain.
    export.put_all("hw1-ada/1002", answers("", "bob"));
    let found = placed_among(&export, &["hw1-ada"], &people, "hw1-{github}");
    assert!(found.1.of.is_empty(), "{:#?}", found.1);
    // But among clones, it is one.
    export.put_all("hw1-zz1", answers("", "zz1"));
    let found = placed_among(&export, &["hw1-ada", "hw1-zz1"], &people, "hw1-{github}");
    let names: Vec<&str> = found.0.entries.iter().map(|it| &*it.name).collect();
    assert_eq!(names, ["hw1-ada", "hw1-zz1"]);
    fs::remove_dir_all(export.path("hw1-ada")).expect("it is there");
    // A clone may be graded again, wherever its answers are, and beside a class. Somebody may have
    // the name of a folder in it.
    people[0].name = "mine".into();
    export.put_all("hw1-ada", answers("mine/", "ada"));
    export.put_all("few/hw1-ada", answers("", "ada"));
    for (id, is_hers) in [("1001", true), ("1002", false)] {
        let found = placed_among(&export, &["hw1-ada"], &people, "hw1-{github}");
        assert_eq!(
            found.0.entries[0].doubts.is_empty(),
            is_hers,
            "{id}: {:#?}",
            found.0
        );
        // Now somebody else has this name.
        people[0].name = "Ada Lovelace".into();
        people[1].name = "mine".into();
    }
    let placed = |paths| placed_among(&export, paths, &people, "hw1-{github}");
    let found = placed(&["hw1-ada"]);
    assert_eq!(all_of(&found, "1001"), ["// sphere by ada"]);
    // A student may have made one of two classes.
    let (_, found) = placed(&["few", "hw1-submissions.zip"]);
    assert!(found.of.is_empty(), "{found:#?}");
    assert_eq!(found.in_doubt()[0].id, "1001");
}

#[test]
fn a_pattern_outweighs_what_looks_like_a_platforms_name() {
    let people = ["ada", "bob"].map(|login| Person {
        id: format!("id of {login}"),
        github: Some(login.into()),
        number: Some(if login == "ada" { "101" } else { "2026" }.into()),
        ..Person::default()
    });
    let export = Export::new();
    // Canvas writes numbers in this way.
    export.put_all("class/cs_101_2026_hw1-ada", answers("", "ada"));
    export.put_all("class/cs_101_2026_hw1-bob", answers("", "bob"));
    let found = placed_among(&export, &["class"], &people, "cs_101_2026_hw1-{github}");
    assert_eq!(
        all_of(&found, "id of ada"),
        ["// sphere by ada"],
        "{:#?}",
        found.1
    );
    assert_eq!(
        all_of(&found, "id of bob"),
        ["// sphere by bob"],
        "{:#?}",
        found.1
    );
    assert!(found.1.by_name.is_empty(), "{:#?}", found.1);
    let path = "class/cs_101_2026_hw1-bob";
    let found = placed_among(&export, &[path], &people, "cs_101_2026_hw1-{github}");
    assert_eq!(
        all_of(&found, "id of bob"),
        ["// sphere by bob"],
        "{:#?}",
        found.1
    );
}
