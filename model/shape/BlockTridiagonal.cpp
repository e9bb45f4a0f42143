// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/BlockTridiagonal.h"

#include <Eigen/Cholesky>

namespace espalier {

void BlockTridiagonal::setZero()
{
    for (Row& row : m_rows) {
        row.own.setZero();
        row.above.setZero();
        row.right.setZero();
    }
}

void BlockTridiagonal::solve()
{
    const std::size_t count = m_rows.size();
    Eigen::LDLT<Matrix6> factors;
    for (std::size_t i = 0; i < count; ++i) {
        Row& row = m_rows[i];
        row.solution = row.right;
        if (i > 0) {
            const Row& below = m_rows[i - 1];
            row.own.noalias() -= below.above.transpose().lazyProduct(m_carried[i - 1]);
            row.solution.noalias() -= below.above.transpose() * below.solution;
        }
        factors.compute(row.own);
        row.solution = factors.solve(row.solution);
        if (i + 1 < count)
            m_carried[i] = factors.solve(row.above);
    }
    for (std::size_t i = count; i-- > 1;)
        m_rows[i - 1].solution.noalias() -= m_carried[i - 1] * m_rows[i].solution;
}

} // namespace espalier
