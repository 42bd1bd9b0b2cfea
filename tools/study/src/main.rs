//! Scratch.
use pinhole_study::{contestants::Contested, family::{Studied, questions}, judge::judge, oracle::Known, question::Data, shape::*};
fn run<S: Studied>() {
    for family in S::families() {
        for data in [Data::F64, Data::F32] {
            for x in (family.exponents)(data) {
                let start = std::time::Instant::now();
                let asked = questions(&family, x, data, 500, 1);
                if asked.is_empty() { continue; }
                let truths: Vec<_> = asked.iter().map(S::truth).collect();
                let took = start.elapsed().as_micros() as usize / asked.len();
                println!("{} {} {} {x}: oracle {took} us", S::NAME, family.name, data.name());
                for k in S::contestants().iter().filter(|k| k.data == data) {
                    let t = judge(k, &asked, &truths);
                    println!("  {:20} {:10} wrong {:>6.2}% (fh {} fm {} wr {}) nf {} oor {} silent {} ties {} median {:.2e} worst {:.2e}", k.name, k.numbers, 100.0*t.wrong_share(), t.false_hits, t.false_misses, t.wrong_roots, t.not_finite, t.out_of_range, t.silent, t.ties, t.median_ulp.unwrap_or(-1.0), t.worst_ulp.unwrap_or(-1.0));
                }
            }
        }
    }
}
fn main() { run::<Sphere<f64>>(); run::<Plane<f64>>(); run::<Triangle<f64>>(); }
