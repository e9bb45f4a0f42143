// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/ZipArchive.h"

#include "model/base/WithinMemory.h"
#include "model/io/JsonReader.h"

#include <QCoreApplication>
#include <QFile>

#include <zip.h>

#include <limits>

namespace espalier {

namespace {

struct ZipText {
    Q_DECLARE_TR_FUNCTIONS(ZipArchive)
};

/// Fastest deflate: saving must be quick, and columns of floats hardly get smaller with a higher level.
constexpr zip_uint32_t kFastLevel = 1;
/// 1 January 1980, midnight: the earliest time in a ZIP archive.
constexpr zip_uint16_t kFixedDate = 1 << 5 | 1;
constexpr zip_uint16_t kFixedTime = 0;
/// What all entries together may claim: so many times the size of the archive, and a little for small ones.
/// The columns of a tree pack to a third, those of a history to a tenth.
constexpr std::uint64_t kMaximumGrowth = 64;
constexpr std::uint64_t kAlwaysAllowed = 8 << 20; // bytes
/// Deflate cannot pack tighter than 1032 : 1; a little more for headers.
constexpr std::uint64_t kMaximumRatio = 1040;

struct DiscardArchive {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct FreeSource {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct CloseFile {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

Error outputError(zip_error_t* error)
{
    if (zip_error_code_zip(error) == ZIP_ER_MEMORY)
        return memoryError();
    return {Error::Kind::Output, ZipText::tr("the archive could not be compressed: %1")
                                     .arg(QString::fromUtf8(zip_error_strerror(error)))};
}

Error damaged(const char* name)
{
    return inputError(QString::fromUtf8(name), ZipText::tr("it is damaged"));
}

Result<QByteArray> contentOf(zip_source_t* source)
{
    zip_stat_t stat;
    if (zip_source_stat(source, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0 ||
        zip_source_open(source) != 0)
        return outputError(zip_source_error(source));
    QByteArray content(static_cast<qsizetype>(stat.size), Qt::Uninitialized);
    const zip_int64_t read = zip_source_read(source, content.data(), stat.size);
    zip_source_close(source);
    if (read != content.size())
        return outputError(zip_source_error(source));
    return content;
}

} // namespace

void ZipWriter::add(QByteArray name, QByteArray content, Packing packing)
{
    m_entries.push_back({std::move(name), std::move(content), packing});
}

Result<QByteArray> ZipWriter::finish()
{
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, &error);
    if (target == nullptr)
        return outputError(&error);
    const std::unique_ptr<zip_source_t, FreeSource> keptTarget(target);
    std::unique_ptr<zip_t, DiscardArchive> archive(zip_open_from_source(target, ZIP_TRUNCATE, &error));
    if (!archive)
        return outputError(&error);
    zip_source_keep(target); // the archive owns one reference, keptTarget the other

    for (const Entry& entry : m_entries) {
        zip_source_t* const source = zip_source_buffer(archive.get(), entry.content.constData(),
                                                       static_cast<zip_uint64_t>(entry.content.size()), 0);
        const zip_int64_t index =
            source == nullptr ? -1
                              : zip_file_add(archive.get(), entry.name.constData(), source, ZIP_FL_ENC_UTF_8);
        if (index < 0) {
            zip_source_free(source);
            return outputError(zip_get_error(archive.get()));
        }
        const auto place = static_cast<zip_uint64_t>(index);
        const zip_int32_t method = entry.packing == Packing::Store ? ZIP_CM_STORE : ZIP_CM_DEFLATE;
        if (zip_set_file_compression(archive.get(), place, method, kFastLevel) != 0 ||
            zip_file_set_dostime(archive.get(), place, kFixedTime, kFixedDate, 0) != 0)
            return outputError(zip_get_error(archive.get()));
    }
    if (zip_close(archive.get()) != 0)
        return outputError(zip_get_error(archive.get()));
    static_cast<void>(archive.release()); // closing the archive has freed it
    return contentOf(target);
}

void ZipReader::Close::operator()(zip* archive) const
{
    zip_discard(archive);
}

Result<ZipReader> ZipReader::openSource(zip_source_t* source)
{
    zip_error_t error;
    zip_error_init(&error);
    zip_t* const archive =
        source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error);
    if (archive == nullptr) {
        zip_source_free(source);
        if (zip_error_code_zip(&error) == ZIP_ER_MEMORY)
            return memoryError();
        return inputError({}, ZipText::tr("it is not a project file, or a damaged one (%1)")
                                  .arg(QString::fromUtf8(zip_error_strerror(&error))));
    }
    ZipReader reader(archive);
    const zip_int64_t entries = zip_get_num_entries(archive, 0);
    if (entries <= 0) // to libzip an empty file is an empty archive
        return inputError({}, ZipText::tr("it is not a project file: it is empty"));
    std::uint64_t packed = 0;
    std::uint64_t unpacked = 0;
    for (zip_int64_t i = 0; i < entries; ++i) {
        zip_stat_t stat;
        if (zip_stat_index(archive, static_cast<zip_uint64_t>(i), 0, &stat) != 0)
            continue;
        packed += (stat.valid & ZIP_STAT_COMP_SIZE) != 0 ? stat.comp_size : 0;
        const zip_uint64_t size = (stat.valid & ZIP_STAT_SIZE) != 0 ? stat.size : 0;
        if (size > std::numeric_limits<std::uint64_t>::max() - unpacked)
            return inputError({}, ZipText::tr("it claims to hold far more than its size allows"));
        unpacked += size;
    }
    if (unpacked > kAlwaysAllowed + kMaximumGrowth * packed)
        return inputError({}, ZipText::tr("it claims to hold far more than its size allows"));
    return reader;
}

Result<ZipReader> ZipReader::open(const QByteArray& content)
{
    return openSource(
        zip_source_buffer_create(content.constData(), static_cast<zip_uint64_t>(content.size()), 0, nullptr));
}

Result<ZipReader> ZipReader::openFile(const QString& fileName)
{
    return openSource(zip_source_file_create(QFile::encodeName(fileName).constData(), 0, -1, nullptr));
}

bool ZipReader::contains(const char* name) const
{
    return zip_name_locate(m_archive.get(), name, 0) >= 0;
}

std::vector<QByteArray> ZipReader::names() const
{
    std::vector<QByteArray> names;
    const zip_int64_t entries = zip_get_num_entries(m_archive.get(), 0);
    for (zip_int64_t i = 0; i < entries; ++i) {
        if (const char* name = zip_get_name(m_archive.get(), static_cast<zip_uint64_t>(i), 0))
            names.emplace_back(name);
    }
    return names;
}

Result<std::uint64_t> ZipReader::sizeOf(const char* name) const
{
    zip_stat_t stat;
    if (!contains(name))
        return inputError(QString::fromUtf8(name), ZipText::tr("it is missing"));
    if (zip_stat(m_archive.get(), name, 0, &stat) != 0)
        return damaged(name);
    constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD;
    const bool known = stat.comp_method == ZIP_CM_STORE || stat.comp_method == ZIP_CM_DEFLATE;
    if ((stat.valid & needed) != needed || !known || stat.size / kMaximumRatio > stat.comp_size)
        return damaged(name);
    return stat.size;
}

Result<void> ZipReader::expectSize(const char* name, std::uint64_t bytes) const
{
    const Result<std::uint64_t> size = sizeOf(name);
    if (!size)
        return size.error();
    if (*size != bytes) {
        return inputError(QString::fromUtf8(name),
                          ZipText::tr("it has %1 bytes, but %2 are expected").arg(*size).arg(bytes));
    }
    return {};
}

Result<QByteArray> ZipReader::read(const char* name, std::uint64_t maximumBytes) const
{
    const Result<std::uint64_t> size = sizeOf(name);
    if (!size)
        return size.error();
    if (*size > maximumBytes)
        return inputError(QString::fromUtf8(name),
                          ZipText::tr("it is larger than %1 bytes").arg(maximumBytes));
    QByteArray content(static_cast<qsizetype>(*size), Qt::Uninitialized);
    const auto bytes =
        std::as_writable_bytes(std::span(content.data(), static_cast<std::size_t>(content.size())));
    if (const Result<void> done = readExactly(name, bytes); !done)
        return done.error();
    return content;
}

Result<void> ZipReader::readExactly(const char* name, std::span<std::byte> target) const
{
    if (const Result<void> size = expectSize(name, target.size()); !size)
        return size;
    const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen(m_archive.get(), name, 0));
    if (!file)
        return damaged(name);
    std::size_t done = 0;
    while (done < target.size()) {
        const zip_int64_t count = zip_fread(file.get(), target.data() + done, target.size() - done);
        if (count <= 0)
            return damaged(name);
        done += static_cast<std::size_t>(count);
    }
    // libzip compares the checksum only when the entry is read to its end.
    std::byte beyond{};
    if (zip_fread(file.get(), &beyond, 1) != 0)
        return damaged(name);
    return {};
}

} // namespace espalier
