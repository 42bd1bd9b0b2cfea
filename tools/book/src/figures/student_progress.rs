//! What `render` shows of one scene after each task: the same pictures, faded where they are
//! still Mitsuba's.

use pinhole::job::Job;
use pinhole::preview::Preview;
use pinhole::{Film, Shape, ShapeKind, false_colour};
use pinhole_course::checkout::Checkout;

use super::FigureFile;
use super::pictures::{GAP, made};
use crate::course::assignment;
use crate::error::Result;
use crate::png::{beside, enlarged};
use crate::reference::Reference;

/// The scene, which has every shape.
pub const SCENE: &str = "tilted_camera";

/// The shapes in the order of their chapters.
const SHAPES: [ShapeKind; 4] = [
    ShapeKind::Plane,
    ShapeKind::Sphere,
    ShapeKind::Triangle,
    ShapeKind::Soup,
];

/// Objects and normals once viewing rays and the first `shapes` shapes are answered.
pub fn after_shapes(shapes: usize, checkout: &Checkout) -> Result<FigureFile> {
    let reference = Reference::build(checkout)?;
    let assignment = assignment(checkout)?;
    let (scene, _) = assignment.find_scene(SCENE)?;
    let golden = assignment.golden().join(SCENE);
    let rays = Film::read(&golden.with_extension("rays.exr"))?;
    let golden = Film::read(&golden.with_extension("exr"))?;
    let preview = Preview::new(&scene, &golden, &rays, &mut |job| {
        let is_answered = match job {
            Job::Meet(scene, rays) => {
                let shape = rays.first().map(|(_, object)| &scene.objects[*object]);
                let shape = shape.map(Shape::kind);
                SHAPES[..shapes]
                    .iter()
                    .any(|answered| Some(*answered) == shape)
            }
            _ => true,
        };
        is_answered.then(|| reference.reply(job)).transpose()
    })?;
    let picture = |mut picture| {
        false_colour::fade(&mut picture, &preview.copied);
        enlarged(&picture, 3)
    };
    let pictures = [
        picture(false_colour::id(&preview.film)),
        picture(false_colour::normal(&preview.film)),
    ];
    made(&beside(&pictures, GAP))
}
