//! What a run may replace in a folder that holds a graded class.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf, absolute};

use super::Roll;
use crate::grade::intake::Entry;
use crate::grade::intake::matching::Proof;
use pinhole_course::error::{Error, Result};
use pinhole_course::link;

/// Refuses results inside a folder that is graded, because whoever filled that folder may have put
/// results there.
pub fn refuse_inside(passed: &[PathBuf], out: &Path) -> Result<()> {
    link::refuse(out)?;
    let out = absolute(out).unwrap_or(out.into());
    let mut existing = out.ancestors().filter_map(|it| it.canonicalize().ok());
    let around = existing.next().unwrap_or_default();
    // A link in that folder may lead elsewhere.
    let is_plain = !out.components().any(|it| it == Component::ParentDir);
    let is_around = |path: &&PathBuf| {
        let Some(path) = path.canonicalize().ok().filter(|_| !path.is_symlink()) else {
            return false;
        };
        around.starts_with(&path) || is_plain && out.starts_with(&path)
    };
    match passed.iter().find(is_around) {
        None => Ok(()),
        Some(path) => Err(Error::input(
            format!(
                "{} is inside {}, which is to be graded",
                out.display(),
                path.display()
            ),
            "name another folder with --out",
        )),
    }
}

/// Refuses a class that lacks the policy or submissions of the class in the `--out` folder, whose
/// roll is the file `earlier`. The user may have passed a folder with only one late submission, and
/// everyone else would then be listed as absent. Or the folder may hold another class. `instead` says
/// what the user may want to do.
pub fn refuse_partial_class(roll: &Roll, earlier: &Path, instead: &str) -> Result<()> {
    // A class of another version is graded again.
    let Ok(class) = Roll::read(earlier) else {
        return Ok(());
    };
    let here = roll.keys();
    let absent = class.entries.iter().filter(|it| !here.contains(it.key()));
    let absent: Vec<&str> = absent.map(|it| &*it.id).collect();
    if absent.is_empty() {
        refuse_other_rules(roll, &class, false)?;
        return refuse_other_paths(roll, &class, earlier);
    }
    let mut some = absent[..absent.len().min(3)].join(", ");
    if absent.len() > 3 {
        some += ", …";
    }
    let count = match absent.len() {
        1 => "1 submission that is".to_owned(),
        count => format!("{count} submissions that are"),
    };
    Err(Error::input(
        format!("the --out folder has results for {count} now missing: {some}"),
        format!(
            "{instead}; to drop those that are missing, first delete {}, and pass a newer table of times \
             if there is one (`times` in policy.toml)",
            earlier.display()
        ),
    ))
}

/// Refuses a class without the folders and archives that the class in the `--out` folder was read
/// from, because it may be one person's upload, and hold work in the names of all.
fn refuse_other_paths(roll: &Roll, class: &Roll, earlier: &Path) -> Result<()> {
    let passed: BTreeSet<&String> = roll.passed.iter().collect();
    let mut old = class.passed.iter();
    let was = match (old.find(|it| !passed.contains(it)), &class.passed[..]) {
        _ if roll.passed.is_empty() => return Ok(()),
        (Some(lost), _) => format!("was read from {lost}, which was not passed now"),
        (None, []) => "was passed one submission at a time".into(),
        (None, _) => return Ok(()),
    };
    Err(Error::input(
        format!("the class in the --out folder {was}"),
        format!(
            "pass all paths that you passed before, or name another folder with --out; to replace \
             the class, first delete {}",
            earlier.display()
        ),
    ))
}

/// Refuses results of another assignment.
pub fn refuse_other_assignment(now: &str, class: &Roll) -> Result<()> {
    let was = &class.assignment;
    if was == now {
        return Ok(());
    }
    Err(Error::input(
        format!("that class was graded for the assignment {was}, not for {now}"),
        "name that assignment with --assignment, or name another folder",
    ))
}

/// Refuses another assignment, to change the roster or the policy for submissions that are not passed
/// now, and to forget one of them.
pub fn refuse_other_rules(roll: &Roll, class: &Roll, is_single: bool) -> Result<()> {
    refuse_other_assignment(&roll.assignment, class)?;
    let (new, old) = (&roll.policy, &class.policy);
    let is_part = is_single && !class.keys().is_subset(&roll.keys());
    // People's groups come from the policy.
    let people = |roll: &Roll| {
        let mut people = roll.people.clone()?;
        people.iter_mut().for_each(|person| person.group = None);
        Some(people)
    };
    let what = match () {
        () if is_part && new.is_some() && new != old => "policy",
        () if is_part && roll.people.is_some() && people(roll) != people(class) => "roster",
        () if is_part && roll.named.is_some() && roll.named != class.named => "named",
        () if !is_single && new.is_none() && old.is_some() => "policy",
        // Perhaps somebody's upload looks like the whole class.
        () if !is_single && roll.people.is_none() && class.people.is_some() => "roster",
        () if !is_single && roll.named.is_none() && class.named.is_some() => "named",
        () => return Ok(()),
    };
    Err(Error::input(
        format!("the class in the --out folder was graded with another --{what}"),
        format!(
            "pass the same --{what} as before, or none if there was none; to change it for \
             everyone, grade the whole class with the new one"
        ),
    ))
}

/// Refuses to replace a submission by an archive, because its author may have given it that name, and
/// to replace two submissions by one: the one with its id, and another with its name.
pub fn refuse_chosen_names(roll: &Roll, class: &Roll) -> Result<()> {
    let here = roll.keys();
    let old = class.entries.iter().filter(|it| here.contains(it.key()));
    let old: Vec<&Entry> = old.collect();
    let replaced: BTreeSet<&str> = old.iter().map(|it| it.key()).collect();
    let new = roll.entries.iter();
    let new: Vec<&Entry> = new.filter(|it| replaced.contains(it.key())).collect();
    if new.len() < old.len() {
        let ids: Vec<&str> = old.iter().map(|old| &*old.id).collect();
        return Err(Error::input(
            format!(
                "these in the --out folder would be replaced by fewer submissions: {}",
                ids.join(", ")
            ),
            "grade the whole class, so that nobody's submission is lost",
        ));
    }
    // Only the name of a folder can prove whose it is.
    let is_archive = |new: &Entry| new.at_most < Proof::Id;
    // The same command may be run again, for everybody also with other answers.
    let is_whole = class.keys().is_subset(&here);
    let is_there = |new: &Entry| {
        let is = |old: &&Entry| old.given == new.given && (is_whole || old.answers == new.answers);
        old.iter().any(|old| old.key() == new.key() && is(old))
    };
    let mut new = new.into_iter();
    let Some(new) = new.find(|it| is_archive(it) && !is_there(it)) else {
        return Ok(());
    };
    Err(Error::input(
        format!(
            "{} would replace the submission {} in the --out folder, but the author of an archive \
             can choose its name",
            new.name, new.id
        ),
        "if it belongs to the same person, put it in the place of this person's earlier submission, \
         and pass all submissions of the class again",
    ))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::fs;

    use super::*;
    use crate::grade::class::ROLL;
    use crate::grade::class::marks::tests::{entry, roll};
    use crate::grade::intake::matching::Proof;

    #[test]
    fn an_archive_replaces_no_submission_of_its_name() {
        let named = |given: &str, at_most, answers: &str| {
            let entry = Entry {
                name: given.into(),
                at_most,
                answers: Some(vec![("any".into(), answers.into())]),
                ..entry("ada.2", "ada", given)
            };
            roll(vec![entry], "time_zone = 'UTC'", &[])
        };
        let folder = named("ada", Proof::Id, "old");
        let [archive, hint] = [Proof::Name, Proof::Hint].map(|it| named("ada.zip", it, "old"));
        let [new, same] = ["new", "old"].map(|it| named("ada.zip", Proof::Name, it));
        let beside_bob = |ada: &Roll| {
            let mut class = ada.clone();
            class.entries.push(entry("bob", "bob", "bob"));
            class
        };
        for old in [&folder, &archive, &hint].map(beside_bob) {
            let old = &old;
            let refused = refuse_chosen_names(&new, old).expect_err("eve may have named it");
            assert!(refused.problem.contains("would replace"), "{refused}");
            let new = named("ada", Proof::Id, "new");
            refuse_chosen_names(&new, old).expect("the instructor named it");
        }
        // A name may say when it was handed in.
        refuse_chosen_names(&same, &folder).expect_err("its name is another");
        refuse_chosen_names(&same, &beside_bob(&archive)).expect("nothing changes");
        refuse_chosen_names(&new, &archive).expect("the whole class is passed");
    }

    #[test]
    fn a_submission_passed_alone_replaces_the_one_of_its_name() {
        let of = |entries| roll(entries, "time_zone = 'UTC'", &[]);
        // Beside `Ada`, the id of `ada` was `ada.2`.
        let mut class = of(vec![
            entry("Ada", "Ada", "Ada"),
            entry("ada.2", "ada", "ada"),
        ]);
        class.entries[1].name = "ada".into();
        let mut alone = of(vec![entry("ada", "ada", "ada")]);
        alone.ignored = vec!["bob (a link)".into()];
        alone.take_ids_of(&class);
        let whole = alone.into_class(class);
        let ids = whole.entries.into_iter().map(|it| it.id);
        assert_eq!(ids.collect::<Vec<_>>(), ["Ada", "ada.2"]);
        assert_eq!(whole.ignored, ["bob (a link)"]);
    }

    #[test]
    fn a_class_that_brings_back_older_answers_is_listed() {
        let of = |answers: &str| {
            let entry = Entry {
                answers: Some(vec![("any".into(), answers.into())]),
                ..entry("ada", "ada", "ada")
            };
            roll(
                vec![entry, self::entry("bob", "bob", "bob")],
                "time_zone = 'UTC'",
                &[],
            )
        };
        let after = |mut roll: Roll, class: &Roll| {
            roll.remember_alone(class);
            roll.doubt_earlier_answers();
            roll
        };
        let mut alone = of("new");
        alone.entries.truncate(1);
        let whole = alone.into_class(of("old"));
        for (answers, listed) in [("old", &["ada"][..]), ("new", &[])] {
            let again = after(of(answers), &whole);
            let doubtful = again.entries.iter().filter(|it| !it.doubts.is_empty());
            let doubtful: Vec<&str> = doubtful.map(|it| &*it.id).collect();
            assert_eq!(doubtful, listed);
            // In the next run, too.
            let next = after(of(answers), &again);
            assert_eq!(next.entries[0].doubts.is_empty(), listed.is_empty());
        }
        let newer = after(of("new"), &of("old"));
        assert!(
            newer.entries[0].doubts.is_empty(),
            "the class itself is newer"
        );
        // A merge takes what was passed alone to a part, and keeps what was passed alone to it.
        for (part, merged) in [(whole.clone(), of("old")), (of("old"), whole.clone())] {
            assert!(part.has_same_submissions(&Roll {
                alone: BTreeMap::new(),
                ..part.clone()
            }));
            let again = after(of("old"), &after(part, &merged));
            assert!(!again.entries[0].doubts.is_empty());
        }
        // The class may be passed as `class/*`, also without somebody.
        let again = of("old").into_class(whole.clone());
        for class in [&again, &of("old").into_class(again.clone())] {
            assert_eq!(class.entries[0].doubts.len(), 1);
        }
        let again = of("new").into_class(of("old").into_class(of("old")));
        assert!(again.entries[0].doubts.is_empty(), "it is newer");
        let mut three = of("old");
        three.entries.push(entry("eve", "eve", "eve"));
        let mut alone = of("new");
        alone.entries.truncate(1);
        let again = of("old").into_class(alone.into_class(three));
        assert_eq!(again.entries[0].doubts.len(), 1);
        // Nobody knows which of these are newer.
        let mut alone = of("newer");
        alone.entries.truncate(1);
        let newer = alone.clone().into_class(of("old"));
        let latest = after(of("newer"), &alone.into_class(whole.clone()));
        assert!(latest.entries[0].doubts.is_empty(), "passed alone again");
        for answers in ["new", "newer"] {
            let mut both = of(answers);
            both.remember_alone(&whole);
            let both = after(both, &newer);
            let doubts = &both.entries[0].doubts;
            assert_eq!(doubts.len(), 1, "{answers}: {doubts:?}");
        }
    }

    #[test]
    fn only_the_whole_class_gets_another_roster() {
        let of = |ids: &[&str]| {
            let entries = ids.iter().map(|id| entry(id, id, id)).collect();
            roll(entries, "time_zone = 'UTC'", &[])
        };
        let class = of(&["ada", "bob"]);
        for (ids, is_part) in [(&["ada", "bob"][..], false), (&["ada"], true)] {
            let mut new = of(ids);
            refuse_other_rules(&new, &class, true).expect("it is the same roster");
            new.people = None;
            refuse_other_rules(&new, &class, true).expect("the roster stays");
            new.people = Some(Vec::new());
            let refused = refuse_other_rules(&new, &class, true);
            assert_eq!(refused.is_err(), is_part, "{ids:?}");
        }
        let mut new = of(&["ada", "bob"]);
        refuse_other_rules(&new, &class, false).expect("it is the same roster");
        new.people = None;
        let refused = refuse_other_rules(&new, &class, false);
        refused.expect_err("one person's upload may look like the class");
    }

    #[test]
    fn another_assignment_replaces_no_marks() {
        let of = |assignment: &str| Roll {
            assignment: assignment.into(),
            ..Roll::default()
        };
        let folder = tempfile::tempdir().expect("there is room");
        let earlier = folder.path().join(ROLL);
        let class = serde_json::to_string(&of("spheres")).expect("it is JSON");
        fs::write(&earlier, class).expect("there is room");
        refuse_partial_class(&of("spheres"), &earlier, "pass paths").expect("it is the same");
        let refused = refuse_partial_class(&of("planes"), &earlier, "pass paths");
        let refused = refused.expect_err("another assignment");
        assert!(refused.to_string().contains("spheres"), "{refused}");
    }

    #[test]
    fn no_submission_replaces_those_of_two_people() {
        let of = |ids: &[(&str, &str)]| {
            let entries = ids.iter().map(|(id, name)| Entry {
                name: (*name).into(),
                ..entry(id, name, name)
            });
            roll(entries.collect(), "time_zone = 'UTC'", &[])
        };
        // The id of one is the other's name, which is nobody's before it is handed in.
        let class = of(&[("Ada", "Ada"), ("ada.2", "ada"), ("ada.2.2", "ada.2")]);
        for count in [3, 2] {
            let mut class = class.clone();
            class.entries.truncate(count);
            let mut new = of(&[("ada.2", "ada.2")]);
            refuse_chosen_names(&new, &class).expect("it is nobody else's");
            new.take_ids_of(&class);
            assert_eq!(new.entries[0].id, "ada.2.2");
            assert_eq!(new.into_class(class).entries.len(), 3);
        }
        // Two folders with the same name were passed before.
        let twins = of(&[("ada", "ada"), ("ada.2", "ada")]);
        let mut again = twins.clone();
        again.take_ids_of(&twins);
        assert_eq!(again, twins);
        refuse_chosen_names(&twins, &twins).expect("both are here");
        let refused = refuse_chosen_names(&of(&[("ada", "ada")]), &twins);
        let refused = refused.expect_err("one would be dropped").to_string();
        assert!(refused.contains("ada, ada.2"), "{refused}");
    }

    #[test]
    fn a_folder_with_one_late_submission_does_not_replace_the_class() {
        let of = |ids: &[&str]| {
            let entries = ids.iter().map(|id| entry(id, id, id)).collect();
            let rules = "time_zone = 'UTC'";
            Roll {
                passed: vec!["/hw1".into()],
                ..roll(entries, rules, &[])
            }
        };
        let folder = tempfile::tempdir().expect("there is room");
        let earlier = folder.path().join(ROLL);
        refuse_partial_class(&of(&["ada"]), &earlier, "pass paths")
            .expect("nothing was graded before");
        let text = serde_json::to_string(&of(&["ada", "bob"])).expect("it is JSON");
        fs::write(&earlier, text).expect("there is room");
        refuse_partial_class(&of(&["ada", "bob", "eve"]), &earlier, "pass paths")
            .expect("all are here");
        // Somebody hands in `Ada`, and so the id of ada's answers becomes `ada.2`.
        let mut new = of(&["Ada", "ada.2", "bob"]);
        new.entries[1].name = "ada".into();
        refuse_partial_class(&new, &earlier, "pass paths").expect("all are here");
        let refused = refuse_partial_class(&of(&["bob"]), &earlier, "pass paths");
        let error = refused.expect_err("ada is absent").to_string();
        assert!(error.contains("now missing: ada"), "{error}");
        // Bob's upload may hold work of everybody, and be named like the class.
        let mut new = of(&["ada", "bob"]);
        new.passed.push("/late/hw1".into());
        refuse_partial_class(&new, &earlier, "pass paths").expect("it is the same folder and more");
        new.passed.remove(0);
        let refused = refuse_partial_class(&new, &earlier, "pass paths");
        let error = refused.expect_err("it is another folder").to_string();
        assert!(error.contains("read from /hw1, which"), "{error}");
        // The class was passed one by one, beginning with Bob's folder.
        let alone = Roll {
            passed: Vec::new(),
            ..of(&["ada", "bob"])
        };
        fs::write(&earlier, serde_json::to_string(&alone).expect("it is JSON"))
            .expect("there is room");
        refuse_partial_class(&alone, &earlier, "pass paths").expect("it is the same");
        let refused = refuse_partial_class(&new, &earlier, "pass paths");
        let error = refused.expect_err("it was no folder").to_string();
        assert!(error.contains("one submission at a time"), "{error}");
    }

    #[test]
    fn results_are_not_written_into_a_folder_that_is_graded() {
        let folder = tempfile::tempdir().expect("there is room");
        let root = folder.path().canonicalize().expect("it is there");
        let class = root.join("class");
        fs::create_dir_all(class.join("ada/grades")).expect("there is room");
        let passed = [class.clone()];
        for inside in ["ada/grades", "ada/new/grades", ".", "../class/new"] {
            refuse_inside(&passed, &class.join(inside)).expect_err(inside);
        }
        for outside in ["../grades", "../class-grades"] {
            refuse_inside(&passed, &class.join(outside)).expect("it is beside the class");
        }
        #[cfg(unix)]
        for link in ["ada/link", "../link"] {
            std::os::unix::fs::symlink(&root, class.join(link)).expect("there is room");
            refuse_inside(&passed, &class.join(link)).expect_err("it is a link");
            let beyond = refuse_inside(&passed, &class.join(link).join("new"));
            assert_eq!(beyond.is_err(), link.starts_with("ada"), "{link}");
        }
    }
}
