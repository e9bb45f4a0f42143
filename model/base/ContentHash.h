// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

namespace espalier {

/// A 64-bit hash of values, byte for byte (the rounds of MurmurHash3). Equal values have equal hashes; of two
/// different ones this is so by chance, once in 2^64 pairs.
class ContentHash {
public:
    /// @p value must have no padding.
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value)
    {
        std::uint64_t word = 0;
        std::memcpy(&word, &value, sizeof value);
        addWord(word);
    }
    /// Elements must have no padding.
    template <class T>
    void addAll(std::span<const T> elements)
    {
        const auto* bytes = reinterpret_cast<const std::byte*>(elements.data());
        std::size_t left = elements.size_bytes();
        addWord(left);
        for (; left >= sizeof(std::uint64_t); left -= sizeof(std::uint64_t)) {
            std::uint64_t word;
            std::memcpy(&word, bytes, sizeof word);
            addWord(word);
            bytes += sizeof word;
        }
        if (left > 0) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes, left);
            addWord(word);
        }
    }

    std::uint64_t value() const
    {
        std::uint64_t hash = m_state ^ m_words;
        hash = (hash ^ (hash >> 33U)) * 0xff51afd7ed558ccdU;
        hash = (hash ^ (hash >> 33U)) * 0xc4ceb9fe1a85ec53U;
        return hash ^ (hash >> 33U);
    }

private:
    void addWord(std::uint64_t word)
    {
        word = std::rotl(word * 0x87c37b91114253d5U, 31) * 0x4cf5ad432745937fU;
        m_state = std::rotl(m_state ^ word, 27) * 5 + 0x52dce729U;
        ++m_words;
    }

    std::uint64_t m_state = 0;
    std::uint64_t m_words = 0;
};

} // namespace espalier
