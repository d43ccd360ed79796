//! 3×3 matrices, small and plain, for the expected positions alone.
//!
//! They share nothing with the quaternions that they are to check, nor with the rotations that made the motions.
//! Rows first, column vectors, right-handed, double precision; sine and cosine from `libm`, the same on every
//! system.

/// A 3×3 matrix, row by row.
pub type Matrix = [[f64; 3]; 3];
/// A vector: x, y, z.
pub type Vector = [f64; 3];

/// The matrix that changes nothing.
pub const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The rotation by `degrees` about axis 0 (X), 1 (Y) or 2 (Z).
pub fn rotation(axis: usize, degrees: f64) -> Matrix {
    let angle = degrees * (std::f64::consts::PI / 180.0);
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    // The plane that turns: from Y to Z, from Z to X, from X to Y.
    let (from, to) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = IDENTITY;
    matrix[from][from] = cosine;
    matrix[to][to] = cosine;
    matrix[to][from] = sine;
    matrix[from][to] = -sine;
    matrix
}

/// The product `a` · `b`, which does `b` first.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut product = [[0.0; 3]; 3];
    for row in 0..3 {
        for column in 0..3 {
            product[row][column] = (0..3).map(|k| a[row][k] * b[k][column]).sum();
        }
    }
    product
}

/// The transpose: of a rotation its inverse.
pub fn transposed(matrix: &Matrix) -> Matrix {
    std::array::from_fn(|row| std::array::from_fn(|column| matrix[column][row]))
}

/// The matrix applied to a vector.
pub fn apply(matrix: &Matrix, vector: Vector) -> Vector {
    matrix.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
}

/// The unit quaternion (w, x, y, z) with w ≥ 0 of a rotation matrix.
///
/// Of the four ways to compute it this takes the one that divides by the largest component (Shepperd 1978,
/// "Quaternion from rotation matrix").
pub fn quaternion_wxyz(m: &Matrix) -> [f64; 4] {
    let trace = m[0][0] + m[1][1] + m[2][2];
    let diagonal = [trace, m[0][0], m[1][1], m[2][2]];
    let largest = (0..4).fold(0, |best, n| if diagonal[n] > diagonal[best] { n } else { best });
    let mut q = [0.0; 4];
    if largest == 0 {
        q = [1.0 + trace, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]];
    } else {
        let i = largest - 1;
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        q[0] = m[k][j] - m[j][k];
        q[1 + i] = 1.0 + m[i][i] - m[j][j] - m[k][k];
        q[1 + j] = m[j][i] + m[i][j];
        q[1 + k] = m[k][i] + m[i][k];
    }
    let length = libm::sqrt(q.iter().map(|part| part * part).sum());
    let length = if q[0] < 0.0 { -length } else { length };
    q.map(|part| part / length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The quaternion turns every axis to where the matrix turns it.
        #[test]
        fn the_quaternion_is_the_same_rotation(x in -400.0..400.0, y in -400.0..400.0, z in -400.0..400.0) {
            let matrix = product(&product(&rotation(2, z), &rotation(0, x)), &rotation(1, y));
            let [w, x, y, z] = quaternion_wxyz(&matrix);
            prop_assert!(w >= 0.0 && (w * w + x * x + y * y + z * z - 1.0).abs() < 1e-12);
            let rows = [
                [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
                [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
                [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
            ];
            for (row, known) in rows.iter().zip(&matrix) {
                for (a, b) in row.iter().zip(known) {
                    prop_assert!((a - b).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn half_turns_have_quaternions_too() {
        for axis in 0..3 {
            let mut known = [0.0; 4];
            known[axis + 1] = 1.0;
            let found = quaternion_wxyz(&rotation(axis, 180.0));
            assert!(found.iter().zip(known).all(|(a, b)| (a.abs() - b).abs() < 1e-9), "{found:?}");
        }
    }

    #[test]
    fn rotations_are_counter_clockwise() {
        let close = |a: Vector, b: Vector| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(close(apply(&rotation(0, 90.0), [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]));
        assert!(close(apply(&rotation(1, 90.0), [0.0, 0.0, 1.0]), [1.0, 0.0, 0.0]));
        assert!(close(apply(&rotation(2, 90.0), [1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]));
    }
}
