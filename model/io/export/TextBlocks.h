// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Parallel.h"

#include <QByteArray>
#include <QIODevice>

#include <charconv>
#include <cstdint>
#include <vector>

namespace espalier {

/// A piece of a text of numbers, written without a locale.
class TextBlock {
public:
    TextBlock& operator<<(char c)
    {
        m_text.append(c);
        return *this;
    }
    TextBlock& operator<<(const char* text)
    {
        m_text.append(text);
        return *this;
    }
    TextBlock& operator<<(std::uint64_t number)
    {
        char digits[24];
        m_text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr - digits);
        return *this;
    }
    /// Appends the number with as few digits as lead back to the same value.
    TextBlock& operator<<(float number)
    {
        char digits[24];
        m_text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr - digits);
        return *this;
    }

    const QByteArray& text() const { return m_text; }

private:
    QByteArray m_text;
};

/// Calls @p write(block, i) for i from 0 to @p count - 1 and sends the text to @p device, in that order;
/// blocks are written in parallel. Returns whether the device accepted all of it.
template <class Write>
bool writeBlocks(QIODevice& device, std::size_t count, Write&& write)
{
    constexpr std::size_t kBlock = 8192;
    constexpr std::size_t kBatch = 64; // blocks that are in memory at once
    for (std::size_t batch = 0; batch < count; batch += kBatch * kBlock) {
        const std::size_t blocks = (std::min(count - batch, kBatch * kBlock) + kBlock - 1) / kBlock;
        std::vector<TextBlock> texts(blocks);
        parallelFor(blocks, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t block = begin; block < end; ++block) {
                const std::size_t first = batch + block * kBlock;
                for (std::size_t i = first; i < std::min(first + kBlock, count); ++i)
                    write(texts[block], i);
            }
        });
        for (const TextBlock& block : texts) {
            if (device.write(block.text()) != block.text().size())
                return false;
        }
    }
    return true;
}

} // namespace espalier
