// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <array>
#include <cstdint>
#include <cstring>
#include <random>

namespace espalier::test {

/// Damages bytes in the ways that disks, networks and attackers do; the same seed gives the same damage.
class Mutator {
public:
    explicit Mutator(std::uint64_t seed) : m_random(seed) {}

    std::uint64_t below(std::uint64_t limit) { return limit == 0 ? 0 : m_random() % limit; }
    bool chance(int percent) { return below(100) < static_cast<std::uint64_t>(percent); }

    /// One to three changes; @p donor gives what is spliced in.
    QByteArray mutated(QByteArray bytes, const QByteArray& donor)
    {
        for (std::uint64_t i = below(3) + 1; i-- > 0;)
            mutateOnce(bytes, donor);
        return bytes;
    }

    /// Replaces a number in a JSON text by another number, word or bracket, or swaps two numbers.
    QByteArray mutatedJson(QByteArray text)
    {
        static constexpr std::array kWords{"0",          "-1",       "1",       "2",          "7",
                                           "1e999",      "1e308",    "-1e-320", "4294967295", "4294967296",
                                           "2147483648", "1e12",     "0.5",     "-0",         "null",
                                           "true",       "[]",       "{}",      "\"\"",       "\"0\"",
                                           "65536",      "20000000", "99999",   "1000",       "NaN"};
        const auto [from, length] = someNumber(text);
        if (length == 0)
            return text;
        if (chance(60))
            return text.replace(from, length, kWords[below(kWords.size())]);
        const auto [otherFrom, otherLength] = someNumber(text);
        return text.replace(from, length, text.sliced(otherFrom, otherLength));
    }

    /// Changes one element of a column of numbers: to the value of another row, to a nearby value, or to an
    /// extreme.
    void mutateColumn(QByteArray& column, qsizetype elementSize)
    {
        const qsizetype rows = column.size() / elementSize;
        if (rows == 0)
            return;
        char* const place =
            column.data() + elementSize * static_cast<qsizetype>(below(static_cast<std::uint64_t>(rows)));
        const qsizetype other = elementSize * static_cast<qsizetype>(below(static_cast<std::uint64_t>(rows)));
        if (chance(40)) {
            std::memcpy(place, column.constData() + other, static_cast<std::size_t>(elementSize));
        } else if (chance(50)) {
            *place = static_cast<char>(*place + static_cast<char>(below(5)) - 2);
        } else {
            const std::uint64_t extreme = interesting();
            std::memcpy(place, &extreme, static_cast<std::size_t>(std::min<qsizetype>(elementSize, 8)));
        }
    }

private:
    std::uint64_t interesting()
    {
        static constexpr std::array<std::uint64_t, 14> kNumbers{0,
                                                                1,
                                                                2,
                                                                3,
                                                                7,
                                                                0x7f,
                                                                0x80,
                                                                0xffff,
                                                                0x7fffffff,
                                                                0x80000000,
                                                                0xffffffff,
                                                                0x7fc00000, // not a number
                                                                0x7fffffffffffffff,
                                                                0xffffffffffffffff};
        return kNumbers[below(kNumbers.size())];
    }

    void mutateOnce(QByteArray& bytes, const QByteArray& donor)
    {
        const auto size = static_cast<std::uint64_t>(bytes.size());
        const auto at = static_cast<qsizetype>(below(size));
        const auto length = static_cast<qsizetype>(
            below(std::min<std::uint64_t>(size - static_cast<std::uint64_t>(at), 64) + 1));
        switch (below(7)) {
        case 0:
            bytes.truncate(at);
            break;
        case 1:
            for (std::uint64_t i = below(8) + 1; i-- > 0 && size > 0;) {
                const auto place = static_cast<qsizetype>(below(size));
                bytes[place] = static_cast<char>(bytes[place] ^ (1 << below(8)));
            }
            break;
        case 2:
            bytes.remove(at, length);
            break;
        case 3:
            bytes.insert(at, bytes.sliced(at, length));
            break;
        case 4: {
            const auto from = static_cast<qsizetype>(below(static_cast<std::uint64_t>(donor.size())));
            bytes.replace(at, length, donor.sliced(from, std::min<qsizetype>(donor.size() - from, length)));
            break;
        }
        default: {
            const std::uint64_t number = interesting();
            const qsizetype width = qsizetype{1} << below(4);
            if (at + width <= bytes.size())
                std::memcpy(bytes.data() + at, &number, static_cast<std::size_t>(width));
            break;
        }
        }
    }

    struct Piece {
        qsizetype from = 0;
        qsizetype length = 0;
    };
    Piece someNumber(const QByteArray& text)
    {
        const auto isDigit = [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; };
        const auto start = static_cast<qsizetype>(below(static_cast<std::uint64_t>(text.size())));
        for (qsizetype i = 0; i < text.size(); ++i) {
            const qsizetype from = (start + i) % text.size();
            if (!isDigit(text[from]))
                continue;
            qsizetype end = from;
            while (end < text.size() && isDigit(text[end]))
                ++end;
            return {from, end - from};
        }
        return {};
    }

    std::mt19937_64 m_random;
};

} // namespace espalier::test
