//! The goldens of the probes as JSON, for the test of the figures' mathematics.

use std::fs;
use std::path::PathBuf;

use pinhole::film::{HIT_CHANNELS, RAY_CHANNELS};
use pinhole::judge::Golden;
use pinhole::kind::Questions;
use pinhole::{Film, Kind, ShapeKind};
use pinhole_course::checkout::Checkout;
use serde_json::{Value, json};

use crate::course::golden;
use crate::error::{Error, Result};

/// Every question of the tasks that figures compute, Mitsuba's answer, and how far from it
/// another may be.
pub fn probes(checkout: &Checkout) -> Result<Value> {
    let folder = golden(checkout).join("probes");
    let entries = fs::read_dir(&folder).map_err(|error| Error::file(&folder, &error))?;
    let mut asked: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    asked.retain(|path| path.to_string_lossy().ends_with(".ask.exr"));
    asked.sort();
    let (mut shapes, mut rays) = (Vec::new(), Vec::new());
    for path in asked {
        let name = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let group = name.trim_end_matches(".ask.exr").to_owned();
        let task = group.split('.').next().unwrap_or_default().to_owned();
        let (kind, shape) = match task.as_str() {
            "viewing_ray" => (Kind::ViewingRay, None),
            "sphere" => (Kind::Intersect, Some(ShapeKind::Sphere)),
            "plane" => (Kind::Intersect, Some(ShapeKind::Plane)),
            "triangle" => (Kind::Intersect, Some(ShapeKind::Triangle)),
            _ => continue,
        };
        let (questions, _) = Questions::read(&path, &task, kind, shape)?;
        let golden = Golden::read(&folder.join(format!("{group}.exr")))?;
        match questions {
            Questions::ViewingRay(questions) => {
                for (index, question) in questions.iter().enumerate() {
                    let mut one = json!(question);
                    add(&mut one, &group, &golden, &RAY_CHANNELS, index);
                    rays.push(one);
                }
            }
            Questions::Intersect(questions) => {
                for (index, question) in questions.iter().enumerate() {
                    let mut one = json!(question);
                    add(&mut one, &group, &golden, &HIT_CHANNELS, index);
                    shapes.push(one);
                }
            }
            _ => {}
        }
    }
    Ok(json!({ "shapes": shapes, "rays": rays }))
}

fn add(question: &mut Value, group: &str, golden: &Golden, channels: &[&str], index: usize) {
    let samples = |film: &Film| -> Vec<f32> {
        let one = |name: &&str| {
            film.channel(name)
                .map_or(f32::NAN, |samples| samples[index])
        };
        channels.iter().map(one).collect()
    };
    question["group"] = json!(group);
    question["expected"] = json!(samples(golden.film()));
    question["allowed"] = json!(samples(golden.tolerance()));
}
