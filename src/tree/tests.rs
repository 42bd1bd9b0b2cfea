use super::*;

fn leaf(triangles: &[usize]) -> Tree {
    Tree::Leaf(triangles.to_vec())
}

fn branch(first: Tree, second: Tree) -> Tree {
    Tree::Branch(Box::new([first, second]))
}

/// Unit cubes in a row along x, two units apart.
fn cubes(count: usize) -> Vec<BoundingBox> {
    let cube = |index| {
        let min = DVec3::new(2.0 * index as f64, 0.0, 0.0);
        let max = min + DVec3::ONE;
        BoundingBox { min, max }
    };
    (0..count).map(cube).collect()
}

#[track_caller]
fn measured(tree: Tree, count: usize) -> TreeMeasures {
    FlatTree::from(tree).measure(&cubes(count))
}

#[test]
fn a_flat_tree_lists_a_branch_before_its_first_child_and_then_the_second() {
    let tree = branch(branch(leaf(&[2]), leaf(&[0])), leaf(&[1]));
    let flat = FlatTree::from(tree);
    let expected = [
        FlatNode::Branch([1, 4]),
        FlatNode::Branch([2, 3]),
        FlatNode::Leaf(vec![2]),
        FlatNode::Leaf(vec![0]),
        FlatNode::Leaf(vec![1]),
    ];
    assert_eq!(flat.0, expected);
    assert!(flat.is_tree());
    assert_eq!(flat.node(4), Node::Leaf(&[1]));
    assert_eq!(flat.size(), 8);
}

#[test]
fn the_depths_of_its_leaves_determine_a_tree() {
    let shapes = [
        leaf(&[0, 1]),
        branch(leaf(&[0]), leaf(&[1])),
        branch(branch(leaf(&[2]), leaf(&[0])), leaf(&[1])),
        branch(
            leaf(&[2]),
            branch(leaf(&[0]), branch(leaf(&[3]), leaf(&[1]))),
        ),
    ];
    for tree in shapes.map(FlatTree::from) {
        let depths = tree.depths();
        let leaves = tree
            .0
            .iter()
            .zip(depths)
            .filter_map(|(node, depth)| match node {
                FlatNode::Leaf(members) => Some((depth, members.clone())),
                FlatNode::Branch(_) => None,
            });
        assert_eq!(FlatTree::of_leaves(leaves.collect()), Some(tree));
    }
    for depths in [
        &[][..],
        &[1],
        &[0, 0],
        &[1, 2],
        &[1, 1, 1],
        &[usize::MAX, usize::MAX],
    ] {
        let leaves = depths.iter().map(|depth| (*depth, vec![0]));
        assert_eq!(FlatTree::of_leaves(leaves.collect()), None, "{depths:?}");
    }
}

#[test]
fn the_outline_of_a_hostile_tree_is_short() {
    let places = |outline: &[NodeBox]| {
        let places = outline.iter().map(|node| (node.depth, node.bounds.min.x));
        places.collect::<Vec<_>>()
    };
    let tree = branch(leaf(&[7, 1, 1]), branch(leaf(&[]), leaf(&[0])));
    let outline = FlatTree::from(tree).outline(&cubes(2));
    // Nothing is drawn of triangle 7, which does not exist, or of a leaf without any.
    assert_eq!(places(&outline), [(0, 0.0), (1, 2.0), (1, 0.0), (2, 0.0)]);
    let full = |depth: u32| {
        let leaves = (0..1 << depth).map(|_| (depth as usize, vec![0]));
        FlatTree::of_leaves(leaves.collect()).expect("all its leaves are equally deep")
    };
    let outline = full(12).outline(&cubes(1));
    assert_eq!(outline.len(), 15);
    assert_eq!(
        outline.iter().map(|node| node.depth).max(),
        Some(DEEPEST_DRAWN)
    );
    assert_eq!(FlatTree::default().outline(&cubes(1)), []);
}

#[test]
fn boxes_of_branches_enclose_those_of_their_children() {
    let flat = FlatTree::from(branch(leaf(&[0]), leaf(&[1, 2])));
    let cubes = cubes(3);
    let leaf = |members: &[usize]| around(members.iter().map(|&index| cubes[index]));
    let boxes = flat.boxes(leaf, |a, b| around([*a, *b]));
    let from_to = |min: f64, max: f64| BoundingBox {
        min: DVec3::new(min, 0.0, 0.0),
        max: DVec3::new(max, 1.0, 1.0),
    };
    assert_eq!(
        boxes,
        [from_to(0.0, 5.0), from_to(0.0, 1.0), from_to(2.0, 5.0)]
    );
}

#[test]
fn a_list_of_nodes_is_no_tree_if_a_node_is_reached_twice_or_never() {
    let leaf = || FlatNode::Leaf(vec![0]);
    for (nodes, is_tree) in [
        (vec![], false),
        (vec![leaf()], true),
        (vec![leaf(), leaf()], false),
        (vec![FlatNode::Branch([1, 2]), leaf(), leaf()], true),
        (vec![FlatNode::Branch([1, 1]), leaf()], false),
        (vec![FlatNode::Branch([0, 1]), leaf()], false),
        (vec![FlatNode::Branch([1, 3]), leaf(), leaf()], false),
        (
            vec![
                FlatNode::Branch([1, 2]),
                FlatNode::Branch([2, 3]),
                leaf(),
                leaf(),
            ],
            false,
        ),
        (vec![FlatNode::Branch([1, usize::MAX]), leaf()], false),
    ] {
        assert_eq!(FlatTree(nodes.clone()).is_tree(), is_tree, "{nodes:?}");
    }
}

#[test]
fn a_triangle_is_misplaced_unless_it_is_in_one_leaf() {
    for (tree, misplaced) in [
        (leaf(&[0, 1, 2]), 0),
        (branch(leaf(&[2, 0]), leaf(&[1])), 0),
        (leaf(&[0, 1]), 1),
        (leaf(&[0, 1, 1, 2]), 1),
        (branch(leaf(&[0, 1]), leaf(&[1, 2])), 1),
        (branch(leaf(&[]), leaf(&[])), 3),
        (leaf(&[0, 1, 2, 3, usize::MAX]), 2),
    ] {
        assert_eq!(measured(tree.clone(), 3).misplaced, misplaced, "{tree:?}");
    }
}

#[test]
fn depth_counts_the_branches_above_the_deepest_leaf() {
    let chain = |count: usize| {
        let first = leaf(&[0]);
        (1..count).fold(first, |tree, index| branch(leaf(&[index]), tree))
    };
    for count in 1..6 {
        assert_eq!(measured(chain(count), count).depth, count - 1);
    }
    assert_eq!(measured(leaf(&[0, 1, 2]), 3).largest_leaf, 3);
}

#[test]
fn a_tree_that_separates_what_lies_apart_costs_less() {
    let in_order = branch(leaf(&[0, 1]), leaf(&[2, 3]));
    let mixed = branch(leaf(&[0, 2]), leaf(&[1, 3]));
    let cost = |tree| measured(tree, 4).cost;
    // The box of all cubes is 7 long with a half surface of 15, that of two is 3 long with 7, and
    // that of three is 5 long with 11.
    assert_eq!(cost(in_order), 2.0 + (7.0 + 7.0) * 2.0 / 15.0);
    assert_eq!(cost(mixed), 2.0 + (11.0 + 11.0) * 2.0 / 15.0);
    assert_eq!(cost(leaf(&[0, 1, 2, 3])), 4.0);
}

#[test]
fn a_tree_of_boxes_without_surface_costs_nothing() {
    let point = BoundingBox {
        min: DVec3::ONE,
        max: DVec3::ONE,
    };
    let flat = FlatTree::from(branch(leaf(&[0]), leaf(&[1])));
    assert_eq!(flat.measure(&[point; 2]).cost, 0.0);
}

#[test]
fn a_branch_is_told_by_where_it_divides_the_centres() {
    // A column beside the last cube spreads the centres along y, but less than along x.
    let mut boxes = cubes(4);
    boxes[3].min.y += 4.0;
    boxes[3].max.y += 4.0;
    let cut = |a: &[usize], b: &[usize]| FlatTree::from(branch(leaf(a), leaf(b))).cuts(&boxes);
    assert_eq!(cut(&[0, 1], &[2, 3]), [Cut::Middle]);
    assert_eq!(cut(&[3, 2], &[1, 0]), [Cut::Middle]);
    assert_eq!(cut(&[0], &[1, 2, 3]), [Cut::OffMiddle]);
    assert_eq!(cut(&[0, 2], &[1, 3]), [Cut::Mixed]);
    boxes[0].min.y += 4.0;
    boxes[0].max.y += 4.0;
    let cut = |a: &[usize], b: &[usize]| FlatTree::from(branch(leaf(a), leaf(b))).cuts(&boxes);
    assert_eq!(cut(&[0, 3], &[1, 2]), [Cut::OtherAxis]);
    assert_eq!(cut(&[], &[0, 1, 2, 3]), []);
    let alike = vec![boxes[0]; 2];
    let tree = FlatTree::from(branch(leaf(&[0]), leaf(&[1])));
    assert_eq!(tree.cuts(&alike), [Cut::Middle]);
}
