//! The replacements for an operator, a number, a method or a field.

use syn::BinOp;

/// The operators that may replace this one.
pub fn others(operator: &BinOp) -> &'static [&'static str] {
    match operator {
        BinOp::Add(_) => &["-", "*", "/"],
        BinOp::Sub(_) => &["+", "*", "/"],
        BinOp::Mul(_) => &["+", "-", "/"],
        BinOp::Div(_) => &["+", "-", "*"],
        BinOp::Lt(_) => &["<=", ">", ">=", "==", "!="],
        BinOp::Le(_) => &["<", ">", ">=", "==", "!="],
        BinOp::Gt(_) => &[">=", "<", "<=", "==", "!="],
        BinOp::Ge(_) => &[">", "<", "<=", "==", "!="],
        BinOp::Eq(_) => &["!=", "<", "<=", ">", ">="],
        BinOp::Ne(_) => &["==", "<", "<=", ">", ">="],
        BinOp::And(_) => &["||"],
        BinOp::Or(_) => &["&&"],
        _ => &[],
    }
}

/// Whether it combines two numbers or vectors into one.
pub fn is_arithmetic(operator: &BinOp) -> bool {
    use BinOp::{Add, Div, Mul, Sub};
    matches!(operator, Add(_) | Sub(_) | Mul(_) | Div(_))
}

/// Whether it is `&&` or `||`.
pub fn is_logical(operator: &BinOp) -> bool {
    matches!(operator, BinOp::And(_) | BinOp::Or(_))
}

/// 0, 1, −x and 2x for x.
pub fn other_numbers(number: f64) -> Vec<String> {
    let mut others: Vec<f64> = Vec::new();
    for other in [0.0, 1.0, -number, 2.0 * number] {
        if other != number && !others.contains(&other) {
            others.push(other);
        }
    }
    others.iter().map(|other| format!("{other:?}")).collect()
}

/// Replacements for `.method`, with its parentheses if those are replaced too.
pub fn other_methods(method: &str) -> &'static [&'static str] {
    match method {
        "min_by" => &["max_by"],
        "max_by" => &["min_by"],
        "find" => &["rfind"],
        "length_squared" => &["length"],
        "length" => &["length_squared"],
        _ => &[],
    }
}

/// Methods without arguments that a student may forget.
pub fn may_be_forgotten(method: &str) -> bool {
    matches!(
        method,
        "normalize" | "sqrt" | "length_squared" | "length" | "rev"
    )
}

/// What may be inserted after a method that begins to iterate over a list.
pub fn detours(method: &str) -> &'static [&'static str] {
    match method {
        "iter" | "into_iter" => &[".rev()", ".skip(1)", ".take(1)"],
        "enumerate" => &[".rev()", ".skip(1)"],
        _ => &[],
    }
}

/// Whether `a.method(b)` differs from `b.method(a)`.
pub fn is_one_sided(method: &str) -> bool {
    matches!(method, "cross" | "total_cmp")
}

/// Fields that are easily confused.
pub fn neighbours(field: &str) -> Vec<&'static str> {
    const FAMILIES: [&[&str]; 7] = [
        &["u", "v", "w"],
        &["x", "y", "z"],
        &["i", "j"],
        &["n_x", "n_y"],
        &["width", "height"],
        &["origin", "direction"],
        &["point", "normal"],
    ];
    let family = FAMILIES.iter().find(|family| family.contains(&field));
    let others = family.into_iter().flat_map(|family| family.iter());
    others.filter(|other| **other != field).copied().collect()
}
