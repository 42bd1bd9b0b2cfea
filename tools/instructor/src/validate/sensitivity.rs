//! Measures the smallest error that each scene detects.
//!
//! For camera errors, the reference's program casts with a disturbed camera. Errors of t and of
//! normals are added to the reference's film.

use std::collections::BTreeMap;

use glam::{DVec3, Vec3};
use pinhole::film::{Channel, MISS};
use pinhole::job::Job;
use pinhole::judge::{Golden, judge};
use pinhole::{Camera, Film, Projection, Scene};
use serde::Serialize;

use super::validator::{Validator, WALL};
use pinhole_course::compile::Program;
use pinhole_course::error::{Error, Result};
use pinhole_course::examine;
use pinhole_course::overlay;
use pinhole_course::sandbox::Limits;

/// The smallest errors that one scene detects.
#[derive(Debug, Serialize)]
pub struct Sensitivity {
    /// The scene.
    pub scene: String,
    /// The smallest detected error of each kind that this scene can have; `None` if not even
    /// [`Kind::most`], the largest that was tried, is detected.
    pub least: BTreeMap<Kind, Option<f64>>,
}

/// Kinds of error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Every ray misses its pixel's centre by this many pixels, along the rows or along the
    /// columns. Only a shift that is detected in both directions counts as detected.
    CameraShift,
    /// The image plane is too far away by this share of its distance.
    FocalLength,
    /// Every t is too large by this share of itself.
    T,
    /// Every normal is tilted by this many radians.
    NormalTilt,
}

impl Kind {
    /// All of them.
    pub const ALL: [Kind; 4] = [
        Kind::CameraShift,
        Kind::FocalLength,
        Kind::T,
        Kind::NormalTilt,
    ];

    /// The largest step that is tried: 32 pixels, a share of 10, 1.3 radians.
    fn last_step(self) -> i32 {
        match self {
            Kind::CameraShift => 15,
            Kind::FocalLength | Kind::T => 10,
            Kind::NormalTilt => 1,
        }
    }

    /// The largest error that is tried.
    pub fn most(self) -> f64 {
        size(self.last_step())
    }
}

/// The size of an error. Errors grow in steps of a tenth of a decade.
fn size(step: i32) -> f64 {
    10_f64.powf(f64::from(step) / 10.0)
}

/// No error smaller than this step is tried: 1e-9.
const FIRST_STEP: i32 = -90;

/// Measures the scenes whose names contain `named`.
pub fn measure(validator: &Validator, named: &str) -> Result<Vec<Sensitivity>> {
    let program = validator
        .compiler
        .compile(&overlay::reference(validator.assignment)?)?;
    let scenes = validator.goldens.scenes.iter();
    let scenes: Vec<_> = scenes.filter(|scene| scene.name.contains(named)).collect();
    let mut subjects = Vec::new();
    for golden_scene in &scenes {
        let asked = validator.goldens.scene_film(golden_scene)?;
        let scene = Scene::read(&golden_scene.file)?;
        let film = cast(validator, &program, &scene)?;
        subjects.push(Subject {
            scene,
            film,
            golden: asked.golden,
        });
    }
    let kinds = subjects.iter().enumerate().flat_map(|(place, subject)| {
        let is_perspective = matches!(
            subject.scene.camera.projection,
            Projection::Perspective { .. }
        );
        let can_have = move |kind: &&Kind| is_perspective || **kind != Kind::FocalLength;
        let kinds = Kind::ALL.iter().filter(can_have);
        kinds.map(move |kind| (place, *kind))
    });
    let kinds: Vec<(usize, Kind)> = kinds.collect();
    let least = validator.all("sensitivity", &kinds, |(place, kind)| {
        subjects[*place].least(validator, &program, *kind)
    })?;
    let mut measured: Vec<Sensitivity> = scenes
        .iter()
        .map(|scene| Sensitivity {
            scene: scene.name.clone(),
            least: BTreeMap::new(),
        })
        .collect();
    for ((place, kind), least) in kinds.into_iter().zip(least) {
        measured[place].least.insert(kind, least);
    }
    Ok(measured)
}

fn cast(validator: &Validator, program: &Program, scene: &Scene) -> Result<Film> {
    let job = Job::Film(scene.clone());
    let reply = examine::run(
        program,
        validator.sandbox,
        &Limits::of_answers(WALL),
        &job,
        &mut |_| {},
    )?;
    match reply.answers.iter().all(Option::is_some) {
        true => Ok(reply.film(scene.resolution)),
        false => Err(Error::environment(
            format!(
                "the reference does not cast all rays of a disturbed camera: {:?}",
                reply.ending
            ),
            "restore the assignment's `reference` folder",
        )),
    }
}

/// A scene, with its films by the reference and by Mitsuba.
struct Subject {
    scene: Scene,
    film: Film,
    golden: Golden,
}

/// A way to disturb a film.
type Disturb<'a> = dyn Fn(f64) -> Result<Film> + 'a;

impl Subject {
    fn least(&self, validator: &Validator, program: &Program, kind: Kind) -> Result<Option<f64>> {
        let with_camera = |camera| {
            let scene = Scene {
                camera,
                ..self.scene.clone()
            };
            cast(validator, program, &scene)
        };
        let search = |disturb: &Disturb| self.search(kind, disturb);
        Ok(match kind {
            Kind::CameraShift => {
                let across = search(&|pixels| with_camera(self.shifted(pixels, 0.0)))?;
                let upward = search(&|pixels| with_camera(self.shifted(0.0, pixels)))?;
                // A shift counts as detected only if both directions are.
                across
                    .zip(upward)
                    .map(|(across, upward)| across.max(upward))
            }
            Kind::FocalLength => search(&|share| with_camera(self.farther(share)))?,
            Kind::T => search(&|share| Ok(self.with_t(share)))?,
            Kind::NormalTilt => search(&|angle| Ok(self.tilted(angle)))?,
        })
    }

    /// Searches by bisection, assuming that an error is detected if a smaller one is.
    fn search(&self, kind: Kind, disturb: &Disturb) -> Result<Option<f64>> {
        let is_seen = |step: i32| -> Result<bool> {
            let film = disturb(size(step))?;
            Ok(!judge(&self.golden, &film).is_ok_and(|verdict| verdict.passes()))
        };
        let (mut unseen, mut seen) = (FIRST_STEP, kind.last_step());
        if !is_seen(seen)? {
            return Ok(None);
        }
        while seen - unseen > 1 {
            let middle = (seen + unseen).div_euclid(2);
            match is_seen(middle)? {
                true => seen = middle,
                false => unseen = middle,
            }
        }
        Ok(Some(size(seen)))
    }

    /// The camera, disturbed so that every ray misses its pixel's centre by these distances.
    fn shifted(&self, across: f64, upward: f64) -> Camera {
        let camera = self.scene.camera;
        let resolution = self.scene.resolution;
        let aside = across * camera.width / resolution.n_x as f64 * camera.u
            + upward * camera.height / resolution.n_y as f64 * camera.v;
        match camera.projection {
            // This is not a frame of unit vectors any more. But d = … − focal_length w now leads
            // to the shifted point of the image plane, while eye and t stay as they are.
            Projection::Perspective { focal_length } => Camera {
                w: camera.w - aside / focal_length,
                ..camera
            },
            Projection::Orthographic => Camera {
                eye: camera.eye + aside,
                ..camera
            },
        }
    }

    fn farther(&self, share: f64) -> Camera {
        let mut camera = self.scene.camera;
        if let Projection::Perspective { focal_length } = &mut camera.projection {
            *focal_length *= 1.0 + share;
        }
        camera
    }

    fn with_t(&self, share: f64) -> Film {
        self.changed(|sample| {
            sample.t = (f64::from(sample.t) * (1.0 + share)) as f32;
        })
    }

    fn tilted(&self, angle: f64) -> Film {
        self.changed(|sample| {
            let normal = sample.normal.as_dvec3();
            let aside = normal
                .try_normalize()
                .unwrap_or(DVec3::X)
                .any_orthonormal_vector();
            sample.normal = (angle.cos() * normal + angle.sin() * aside).as_vec3();
        })
    }

    /// The reference's film with every hit changed.
    fn changed(&self, change: impl Fn(&mut Sample)) -> Film {
        let channel = |name| self.film.channel(name).unwrap_or_default().to_vec();
        let [ids, mut ts, mut xs, mut ys, mut zs] = ["id", "t", "N.X", "N.Y", "N.Z"].map(channel);
        for index in (0..ids.len()).filter(|index| ids[*index] != MISS) {
            let mut sample = Sample {
                t: ts[index],
                normal: Vec3::new(xs[index], ys[index], zs[index]),
            };
            change(&mut sample);
            ts[index] = sample.t;
            [xs[index], ys[index], zs[index]] = sample.normal.to_array();
        }
        let channels = [
            ("id", ids),
            ("t", ts),
            ("N.X", xs),
            ("N.Y", ys),
            ("N.Z", zs),
        ];
        let channels = channels.map(|(name, samples)| Channel {
            name: name.into(),
            samples,
        });
        Film::new(self.scene.resolution, channels.into())
    }
}

/// A pixel that hits something.
struct Sample {
    t: f32,
    normal: Vec3,
}
