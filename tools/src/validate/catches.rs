//! How much each group of questions and each scene catches, and what only it catches.

use serde::Serialize;

use super::bench::Bench;
use super::submissions::Judged;

/// One row for each film, probes and scenes apart.
#[derive(Debug, Serialize)]
pub struct Catches {
    /// How many single mistakes were judged.
    pub mistakes: usize,
    /// Groups of questions, in the assignment's order.
    pub probes: Vec<Catch>,
    /// Scenes, in the assignment's order.
    pub scenes: Vec<Catch>,
}

/// What one group of questions or one scene catches. Only single mistakes count: one
/// that holds two beliefs fails wherever either does.
#[derive(Debug, Serialize)]
pub struct Catch {
    /// `task.group`, or the scene.
    pub name: String,
    /// How many mistakes fail here.
    pub catches: usize,
    /// Mistakes that fail nowhere else among the groups, or among the scenes.
    pub only_of_its_kind: Vec<String>,
    /// Mistakes that fail nowhere else at all.
    pub only: Vec<String>,
}

impl Catches {
    /// Counts over single mistakes.
    pub fn count(bench: &Bench, judged: &[Judged]) -> Catches {
        let single: Vec<&Judged> = judged.iter().filter(|judged| judged.single).collect();
        let groups = bench.assignment.tasks.iter().flat_map(|task| {
            let named = |(group, _): &(String, u32)| format!("{}.{group}", task.name);
            task.points.iter().map(named)
        });
        let scenes = bench.goldens.scenes.iter().map(|scene| scene.name.clone());
        let groups = groups.map(|name| Catch::count(name, &single, |judged| &judged.groups));
        let scenes = scenes.map(|name| Catch::count(name, &single, |judged| &judged.scenes));
        Catches {
            mistakes: single.len(),
            probes: groups.collect(),
            scenes: scenes.collect(),
        }
    }
}

impl Catch {
    fn count(name: String, judged: &[&Judged], kind: impl Fn(&Judged) -> &Vec<String>) -> Catch {
        let here: Vec<&&Judged> = judged
            .iter()
            .filter(|judged| kind(judged).contains(&name))
            .collect();
        let names = |keep: &dyn Fn(&Judged) -> bool| {
            let kept = here.iter().filter(|judged| keep(judged));
            kept.map(|judged| judged.name.clone()).collect()
        };
        Catch {
            catches: here.len(),
            only_of_its_kind: names(&|judged| kind(judged).len() == 1),
            only: names(&|judged| judged.groups.len() + judged.scenes.len() == 1),
            name,
        }
    }
}
