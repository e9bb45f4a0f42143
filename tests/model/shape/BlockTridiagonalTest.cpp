// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/BlockTridiagonal.h"

#include "tests/support/TestClasses.h"

#include <QTest>

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>

namespace espalier::test {

class BlockTridiagonalTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void solution_isThatOfTheDenseSystem_data();
    void solution_isThatOfTheDenseSystem();
    void solve_readsOnlyLowerTriangles();
    void sameSystem_givesTheSameBits();
};

namespace {

/// A positive definite system of @p rows whose elements follow from their places.
BlockTridiagonal systemOf(std::size_t rows)
{
    BlockTridiagonal system(rows);
    system.setZero();
    double angle = 0.0;
    for (BlockTridiagonal::Row& row : system.rows()) {
        BlockTridiagonal::Matrix6 mixed;
        for (Eigen::Index i = 0; i < 36; ++i)
            mixed(i / 6, i % 6) = std::sin(angle += 1.7);
        row.own = mixed * mixed.transpose() + 8.0 * BlockTridiagonal::Matrix6::Identity();
        for (Eigen::Index i = 0; i < 36; ++i)
            row.above(i / 6, i % 6) = 0.6 * std::sin(angle += 2.3);
        for (Eigen::Index i = 0; i < 6; ++i)
            row.right(i) = std::cos(angle += 0.9);
    }
    return system;
}

Eigen::VectorXd denseSolution(const BlockTridiagonal& system)
{
    const auto count = static_cast<Eigen::Index>(system.rows().size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6 * count, 6 * count);
    Eigen::VectorXd right(6 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const BlockTridiagonal::Row& row = system.rows()[static_cast<std::size_t>(i)];
        matrix.block<6, 6>(6 * i, 6 * i) = row.own;
        right.segment<6>(6 * i) = row.right;
        if (i + 1 < count) {
            matrix.block<6, 6>(6 * i, 6 * i + 6) = row.above;
            matrix.block<6, 6>(6 * i + 6, 6 * i) = row.above.transpose();
        }
    }
    return matrix.ldlt().solve(right);
}

} // namespace

void BlockTridiagonalTest::solution_isThatOfTheDenseSystem_data()
{
    QTest::addColumn<int>("rows");
    for (const int rows : {0, 1, 2, 3, 40})
        QTest::addRow("%d rows", rows) << rows;
}

void BlockTridiagonalTest::solution_isThatOfTheDenseSystem()
{
    QFETCH(const int, rows);
    BlockTridiagonal system = systemOf(static_cast<std::size_t>(rows));
    const Eigen::VectorXd wanted = denseSolution(system);
    system.solve();
    for (Eigen::Index i = 0; i < rows; ++i) {
        const BlockTridiagonal::Row& row = system.rows()[static_cast<std::size_t>(i)];
        QVERIFY((row.solution - wanted.segment<6>(6 * i)).norm() < 1e-12);
    }
}

void BlockTridiagonalTest::solve_readsOnlyLowerTriangles()
{
    BlockTridiagonal whole = systemOf(5);
    BlockTridiagonal lower = whole;
    for (BlockTridiagonal::Row& row : lower.rows())
        row.own.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
    whole.solve();
    lower.solve();
    for (std::size_t i = 0; i < 5; ++i)
        QVERIFY(lower.rows()[i].solution == whole.rows()[i].solution);
}

void BlockTridiagonalTest::sameSystem_givesTheSameBits()
{
    BlockTridiagonal one = systemOf(20);
    BlockTridiagonal other = one;
    one.solve();
    other.solve();
    for (std::size_t i = 0; i < 20; ++i)
        QVERIFY(one.rows()[i].solution == other.rows()[i].solution);
}

const TestClass<BlockTridiagonalTest> blockTridiagonalTest;

} // namespace espalier::test

#include "BlockTridiagonalTest.moc"
