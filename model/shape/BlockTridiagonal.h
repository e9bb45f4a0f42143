// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// A symmetric positive definite system of linear equations A x = b in 6 × 6 blocks. Each block row is
/// coupled with its two neighbours only. Solved by block elimination with Eigen's LDLT of each diagonal
/// block, in a time that is proportional to the number of rows. The same input gives the same bits.
class BlockTridiagonal {
public:
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    using Vector6 = Eigen::Matrix<double, 6, 1>;

    struct Row {
        Matrix6 own;      ///< Diagonal block; only its lower triangle is read
        Matrix6 above;    ///< Block that couples this row with the next; ignored in the last row
        Vector6 right;    ///< b
        Vector6 solution; ///< x, after solve()
    };

    explicit BlockTridiagonal(std::size_t rows = 0) : m_rows(rows), m_carried(rows) {}

    std::vector<Row>& rows() { return m_rows; }
    const std::vector<Row>& rows() const { return m_rows; }

    /// Sets all blocks and right sides to zero.
    void setZero();
    /// Computes the solution of each row. Overwrites the diagonal blocks. If the matrix is not positive
    /// definite, the solution may contain values that are not finite.
    void solve();

private:
    std::vector<Row> m_rows;
    std::vector<Matrix6> m_carried; ///< own⁻¹ above of each row, after its elimination
};

} // namespace espalier
