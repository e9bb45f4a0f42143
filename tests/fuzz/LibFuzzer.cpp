// SPDX-License-Identifier: GPL-3.0-or-later
// One program for each target, driven by libFuzzer: "cmake --preset fuzz", see scripts/nightly.sh. Archives
// are mutated entry by entry, since their checksums would refuse nearly everything else.
#include "tests/fuzz/Targets.h"
#include "tests/support/ZipEntries.h"

#include <QGuiApplication>

#include <algorithm>
#include <cstdint>
#include <cstring>

extern "C" {
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
}

namespace {

QByteArray bytesOf(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), static_cast<qsizetype>(size)};
}

std::size_t mutatedEntry(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed)
{
    using namespace espalier::test;
    const QByteArray archive = bytesOf(data, size);
    // The test's own reader trusts its archives.
    ZipEntries entries = espalier::ZipReader::open(archive) ? unpackEntries(archive) : ZipEntries();
    if (entries.empty())
        return LLVMFuzzerMutate(data, size, most);
    QByteArray& content = entries[seed % entries.size()].second;
    const auto before = static_cast<std::size_t>(content.size());
    const std::size_t room = before + 64;
    content.resize(static_cast<qsizetype>(room));
    const std::size_t after = LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(content.data()), before, room);
    content.resize(static_cast<qsizetype>(after));
    const QByteArray packed = packEntries(entries);
    const auto packedSize = static_cast<std::size_t>(packed.size());
    if (packedSize > most)
        return size;
    std::memcpy(data, packed.constData(), packedSize);
    return packedSize;
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("QT_LOGGING_RULES", "*.warning=false");
    static const QGuiApplication application(*argc, *argv);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const espalier::test::FuzzTarget* const target = espalier::test::fuzzTarget(FUZZ_TARGET);
    target->read(bytesOf(data, size));
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed)
{
    const bool isArchive = size > 4 && std::memcmp(data, "PK\x03\x04", 4) == 0;
    return isArchive && seed % 16 != 0 ? mutatedEntry(data, size, most, seed / 16)
                                       : LLVMFuzzerMutate(data, size, most);
}
