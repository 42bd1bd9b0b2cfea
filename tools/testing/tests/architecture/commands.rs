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
        let words: Vec<&str> = command.split(' ').collect();
        // A command is one word, or two if it has subcommands of its own.
        let named = match words[..] {
            ["pinhole", group @ ("book" | "golden"), command, ..] => vec![group, command],
            ["pinhole", command, ..] => vec![command],
            _ => Vec::new(),
        };
        if !text.contains(&named.join(" ")) && !text.contains(&named.join("\", \"")) {
            wrong.push(format!("{file} does not have {}", named.join(" ")));
        }
        let mut options = words.into_iter().filter(is_option);
        if let Some(word) = options.find(|word| !text.contains(word)) {
            wrong.push(format!("{file} does not have {word} of {command}"));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}
