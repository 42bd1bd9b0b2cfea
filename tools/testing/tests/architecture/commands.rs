//! Every command that the documentation prints is run by a test, or listed with the reason why it
//! is not. Each program's own tests check that its parser accepts them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use pinhole_testing::documented_commands::documented_commands;
use pinhole_testing::root;

/// Commands, and the file that runs each or the reason why none does.
type Table = BTreeMap<String, String>;

fn table() -> (Table, Table) {
    let mut tables: BTreeMap<String, Table> =
        toml::from_str(include_str!("commands.toml")).expect("it is two tables");
    let mut take = |name| tables.remove(name).expect("it has both tables");
    (take("run"), take("not_run"))
}

#[test]
fn every_documented_command_is_run_or_has_a_reason_not_to_be() {
    let (run, not_run) = table();
    let listed: BTreeSet<&str> = run
        .keys()
        .chain(not_run.keys())
        .map(String::as_str)
        .collect();
    let printed: BTreeSet<String> = documented_commands(&[])
        .iter()
        .map(|it| it.text())
        .collect();
    let printed: BTreeSet<&str> = printed.iter().map(String::as_str).collect();
    let missing: Vec<_> = printed.difference(&listed).collect();
    let stale: Vec<_> = listed.difference(&printed).collect();
    assert!(
        missing.is_empty(),
        "not listed in commands.toml: {missing:#?}"
    );
    assert!(
        stale.is_empty(),
        "listed in commands.toml, but printed nowhere: {stale:#?}"
    );
}

#[test]
fn the_file_that_runs_a_command_has_its_subcommand_and_options() {
    let (run, _) = table();
    let mut wrong = Vec::new();
    for (command, file) in run {
        let text = fs::read_to_string(root().join(&file)).unwrap_or_default();
        let is_option = |word: &&str| word.starts_with("--");
        let words = command.split(' ');
        let named = match command.starts_with("pinhole ") {
            true => words.clone().nth(1),
            false => None,
        };
        let options = words.skip(1).filter(is_option);
        let mut absent = named
            .into_iter()
            .chain(options)
            .filter(|word| !text.contains(word));
        if let Some(word) = absent.next() {
            wrong.push(format!("{file} does not have {word} of {command}"));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}
