//! The book in a student's repository, so that students need nothing else to read.

use std::fs;

use super::plain;
use pinhole_testing::{fresh, pinhole, root, trusted};

#[test]
fn a_built_book_is_handed_out_unless_it_shows_an_answer() {
    let folder = fresh(&trusted(), "handout-book");
    let (book, out) = (folder.join("built"), folder.join("students"));
    let hand_out = || pinhole(&["handout", "--out", plain(&out), "--book", plain(&book)]);
    fs::create_dir_all(&book).expect("there is room");
    let sphere = fs::read_to_string(root().join("assignments/ray_casting/reference/src/sphere.rs"));
    let sphere = sphere.expect("it is there");
    let answer = sphere.lines().find(|line| line.contains("discriminant ="));
    fs::write(book.join("sphere.html"), answer.expect("it has one")).expect("there is room");
    hand_out()
        .expect_code(2)
        .expect_err("book/sphere.html would give away a line of the reference");
    fs::write(book.join("sphere.html"), "<h1>Sphere</h1>").expect("there is room");
    fs::write(book.join("index.html"), "<h1>Begin</h1>").expect("there is room");
    hand_out().expect_code(0);
    let page = fs::read_to_string(out.join("book/sphere.html")).expect("it was copied");
    assert_eq!(page, "<h1>Sphere</h1>");
    let readme = fs::read_to_string(out.join("README.md")).expect("it has one");
    assert!(readme.contains("open\n`book/index.html`"), "{readme}");
    assert!(!readme.contains("<!--"), "{readme}");
    let ask = "ask your instructor";
    assert!(!readme.contains(ask), "{readme}");
    let without = folder.join("without");
    pinhole(&["handout", "--out", plain(&without)]).expect_code(0);
    let readme = fs::read_to_string(without.join("README.md")).expect("it has one");
    assert!(
        readme.contains(ask) && !readme.contains("index.html"),
        "{readme}"
    );
}
