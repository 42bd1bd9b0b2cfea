//! How questions about cameras are sent: all pixels of a film ask about the same
//! camera, which is sent once.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::CameraQuestion;
use crate::camera::{Camera, Pixel, Resolution};

/// Consecutive questions about one camera.
#[derive(Serialize, Deserialize)]
struct Run {
    camera: Camera,
    resolution: Resolution,
    pixels: Vec<Pixel>,
}

pub fn serialize<S: Serializer>(
    questions: &[CameraQuestion],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let same = |a: &CameraQuestion, b: &CameraQuestion| {
        a.camera == b.camera && a.resolution == b.resolution
    };
    let runs = questions.chunk_by(same).map(|run| Run {
        camera: run[0].camera,
        resolution: run[0].resolution,
        pixels: run.iter().map(|question| question.pixel).collect(),
    });
    runs.collect::<Vec<_>>().serialize(serializer)
}

pub fn deserialize<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Vec<CameraQuestion>, D::Error> {
    let mut questions = Vec::new();
    for run in Vec::<Run>::deserialize(deserializer)? {
        let Run {
            camera, resolution, ..
        } = run;
        questions.extend(run.pixels.iter().map(|&pixel| CameraQuestion {
            camera,
            pixel,
            resolution,
        }));
    }
    Ok(questions)
}
