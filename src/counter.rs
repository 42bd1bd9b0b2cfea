//! Tests that a submission counts itself while it casts a scene.
//!
//! They are for pictures only, because a submission can count whatever it likes. The work
//! that is judged is counted by the asker (see [`SearchQuestion`](crate::kind::SearchQuestion)).

use std::cell::Cell;

thread_local! {
    static TESTS: Cell<u32> = const { Cell::new(0) };
}

/// Counts a test of the pixel that this thread is casting, for its heat map.
pub fn count_test() {
    TESTS.with(|tests| tests.set(tests.get().saturating_add(1)));
}

/// The result of some work, and how many tests this thread counted during it.
pub(crate) fn counted<T>(work: impl FnOnce() -> T) -> (T, u32) {
    TESTS.set(0);
    (work(), TESTS.take())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_piece_of_work_has_its_own_count() {
        count_test();
        let three = || (0..3).for_each(|_| count_test());
        assert_eq!(counted(three), ((), 3));
        assert_eq!(counted(|| 'x'), ('x', 0));
    }
}
