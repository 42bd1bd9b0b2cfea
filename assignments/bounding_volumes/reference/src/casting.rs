//! Given code: viewing rays, and meshes, which are searched with your tree.

use std::cell::RefCell;
use std::rc::Rc;

use pinhole::{
    BoundingBox, Camera, Canned, FlatTree, Hit, Intersection, Node, Pixel, Projection, Ray,
    RayTree, Resolution, Shape, Triangle, count_test,
};

use crate::build_tree::build_tree;
use crate::intersect_ray::IntersectRay;
use crate::nearest_hit::nearest_hit;
use crate::ray_box::ray_box;
use crate::triangle_box::{join, triangle_box};

/// The ray through the centre of a pixel.
pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let u = ((pixel.i as f64 + 0.5) / resolution.n_x as f64 - 0.5) * camera.width;
    let v = ((pixel.j as f64 + 0.5) / resolution.n_y as f64 - 0.5) * camera.height;
    let offset = u * camera.u + v * camera.v;
    match camera.projection {
        Projection::Perspective { focal_length } => Ray {
            origin: camera.eye,
            direction: offset - focal_length * camera.w,
        },
        Projection::Orthographic => Ray {
            origin: camera.eye + offset,
            direction: -camera.w,
        },
    }
}

/// Where a ray first meets a shape, at `min_t` or beyond.
pub fn intersect(shape: &Shape, ray: &Ray, min_t: f64) -> Option<Intersection> {
    match shape {
        Shape::Triangle(triangle) => triangle.intersect_ray(ray, min_t),
        Shape::Soup(soup) => {
            let mesh = mesh_of(&soup.triangles);
            let triangles = &soup.triangles;
            let tree = MeshTree {
                mesh: &mesh,
                triangles,
                ray,
            };
            nearest_hit(&tree, min_t).map(|hit| hit.intersection)
        }
        other => panic!("this assignment has no {}", other.kind()),
    }
}

/// The nearest intersection of a ray with a list of shapes.
pub fn first_hit(ray: &Ray, min_t: f64, objects: &[Shape]) -> Option<Hit> {
    nearest(objects.iter().map(|shape| intersect(shape, ray, min_t)))
}

/// The nearest intersection with canned objects, which know their intersections.
pub fn first_canned_hit(ray: &Ray, min_t: f64, objects: &[Canned]) -> Option<Hit> {
    nearest(objects.iter().map(|canned| canned.intersect(ray, min_t)))
}

fn nearest(found: impl Iterator<Item = Option<Intersection>>) -> Option<Hit> {
    let hits = found.enumerate().filter_map(|(object, intersection)| {
        let intersection = intersection?;
        Some(Hit {
            object,
            intersection,
        })
    });
    hits.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
}

/// The tree of a mesh, and the box of each of its nodes.
struct Mesh {
    tree: FlatTree,
    boxes: Vec<BoundingBox>,
}

impl Mesh {
    fn new(triangles: &[Triangle]) -> Mesh {
        let each: Vec<BoundingBox> = triangles.iter().map(triangle_box).collect();
        let tree = FlatTree::from(build_tree(&each));
        let leaf = |members: &[usize]| {
            let boxes = members.iter().map(|&triangle| each[triangle]);
            boxes.reduce(|a, b| join(&a, &b)).unwrap_or(each[0])
        };
        let boxes = tree.boxes(leaf, join);
        Mesh { tree, boxes }
    }
}

thread_local! {
    /// The meshes of this thread's scenes, each with the address of its first triangle. All
    /// scenes of a program exist at the same time, so no other mesh is ever at that address.
    static MESHES: RefCell<Vec<(*const Triangle, Rc<Mesh>)>> = const { RefCell::new(Vec::new()) };
}

/// The mesh of these triangles, built when it is first needed.
fn mesh_of(triangles: &[Triangle]) -> Rc<Mesh> {
    let address = triangles.as_ptr();
    let known = MESHES.with_borrow(|meshes| {
        let mut known = meshes.iter().filter(|(other, _)| *other == address);
        known.next().map(|(_, mesh)| mesh.clone())
    });
    known.unwrap_or_else(|| {
        let mesh = Rc::new(Mesh::new(triangles));
        MESHES.with_borrow_mut(|meshes| meshes.push((address, mesh.clone())));
        mesh
    })
}

/// A mesh's tree as one ray sees it. Its tests are counted for the heat map.
struct MeshTree<'a> {
    mesh: &'a Mesh,
    triangles: &'a [Triangle],
    ray: &'a Ray,
}

impl RayTree for MeshTree<'_> {
    fn node(&self, node: usize) -> Node<'_> {
        self.mesh.tree.node(node)
    }

    fn enter_box(&self, node: usize, min_t: f64, max_t: f64) -> Option<f64> {
        count_test();
        ray_box(&self.mesh.boxes[node], self.ray, min_t, max_t)
    }

    fn intersect_triangle(&self, triangle: usize, min_t: f64) -> Option<Intersection> {
        count_test();
        self.triangles[triangle].intersect_ray(self.ray, min_t)
    }
}
