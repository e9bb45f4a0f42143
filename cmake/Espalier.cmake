# SPDX-License-Identifier: GPL-3.0-or-later
# Settings and functions for all targets of this project.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_AUTOMOC ON)
set(CMAKE_AUTORCC ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set_property(GLOBAL PROPERTY AUTOGEN_TARGETS_FOLDER autogen)

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
add_link_options(-Wl,--as-needed)

# The many test programs are linked in less time by gold than by GNU ld, which links them too.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold ESPALIER_HAS_GOLD)
if(ESPALIER_HAS_GOLD)
    add_link_options(-fuse-ld=gold)
endif()

# The same input must give the same tree on every machine: no fused multiply-add, no fast maths, no machine tuning.
add_compile_options(-ffp-contract=off)
# Qt's keyword "emit" breaks TBB's headers: write Q_EMIT, Q_SIGNALS, Q_SLOTS.
add_compile_definitions(QT_NO_KEYWORDS QT_DISABLE_DEPRECATED_BEFORE=0x060000)

if(ESPALIER_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link,address -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address)
endif()
if(ESPALIER_SANITISE)
    # The address sanitizer reports most of what these checks report, and they take a third of the compile time.
    set(unneeded -fno-sanitize=null,alignment,object-size,pointer-overflow,vptr)
    set(sanitisers -fsanitize=address,undefined ${unneeded} -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    add_compile_options(${sanitisers})
    add_link_options(${sanitisers})
endif()

if(ESPALIER_THREADS)
    add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
    add_link_options(-fsanitize=thread)
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC collects garbage from 128 MB on, of which the precompiled headers alone take more: a seventh of the compile time.
    add_compile_options(--param=ggc-min-heapsize=1048576)
endif()

find_program(CCACHE_PROGRAM ccache)
mark_as_advanced(CCACHE_PROGRAM)
if(CCACHE_PROGRAM)
    # Without these, ccache has no hits for sources that use a precompiled header.
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        # What a file includes is known from its compilation: no preprocessing of its own before that.
        CCACHE_DEPEND=1
        # A second checkout uses the results of the first one.
        "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1 "${CCACHE_PROGRAM}")
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
        add_compile_options(-fpch-preprocess)
    endif()
endif()

# Headers that any layer may need, and those that any layer with widgets may need. They are compiled once; a source
# still includes what it uses.
set(ESPALIER_CORE_HEADERS
    <algorithm> <array> <cmath> <cstdint> <functional> <limits> <memory> <numbers> <optional> <span> <string>
    <string_view> <unordered_map> <utility> <variant> <vector>
    <QByteArray> <QHash> <QImage> <QJsonArray> <QJsonDocument> <QJsonObject> <QList> <QObject> <QString> <QUndoStack>
    <Eigen/Core> <Eigen/Geometry>)
set(ESPALIER_WIDGET_HEADERS
    ${ESPALIER_CORE_HEADERS}
    <QAction> <QBoxLayout> <QIcon> <QLabel> <QMainWindow> <QMouseEvent> <QPainter> <QSettings> <QSlider> <QTimer>
    <QToolButton> <QWidget>)

# espalier_fast_moc(target)
#
# If moc knows the include paths, it reads all headers that a source includes, which takes seventy times as long. What it
# makes is the same: no header here has a macro that hides a class, a signal or a slot.
function(espalier_fast_moc target)
    if(NOT CMAKE_HOST_UNIX)
        return()
    endif()
    set(script "${PROJECT_BINARY_DIR}/moc.sh")
    if(NOT EXISTS "${script}")
        get_target_property(moc Qt6::moc LOCATION)
        configure_file("${PROJECT_SOURCE_DIR}/cmake/moc.sh.in" "${script}" @ONLY)
    endif()
    set_target_properties(${target} PROPERTIES AUTOMOC_EXECUTABLE "${script}")
endfunction()

# The strict settings of this project's own code; other projects' code is not compiled with them.
function(espalier_own_code target)
    target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}")
    target_compile_definitions(${target} PRIVATE ESPALIER_VERSION="${PROJECT_VERSION}")
    espalier_fast_moc(${target})
    # Clang, unlike GCC, counts signs that change among the conversions.
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wno-sign-conversion -Wshadow)
    # The sanitizers' own code makes the compiler see faults that are not there.
    if(NOT ESPALIER_SANITISE)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()

# espalier_precompiled(name LINKS target… HEADERS header…)
#
# A set of precompiled headers for the libraries that name it.
function(espalier_precompiled name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINKS;HEADERS")
    file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp" CONTENT "")
    add_library(${name} OBJECT EXCLUDE_FROM_ALL "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
    set_target_properties(${name} PROPERTIES AUTOMOC OFF AUTORCC OFF)
    target_link_libraries(${name} PRIVATE ${arg_LINKS})
    target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
    espalier_own_code(${name})
endfunction()

# espalier_library(name PRECOMPILED set [LINKS target…] [SOURCES file…])
#
# One layer as a static library. A layer without sources is an interface library, so that it can be linked to before
# it has any.
function(espalier_library name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "PRECOMPILED" "LINKS;SOURCES")
    if(arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "espalier_library(${name}): what is ${arg_UNPARSED_ARGUMENTS}?")
    endif()
    if(NOT arg_SOURCES)
        add_library(${name} INTERFACE)
        target_link_libraries(${name} INTERFACE ${arg_LINKS})
        return()
    endif()
    add_library(${name} STATIC)
    target_sources(${name} PRIVATE ${arg_SOURCES})
    target_link_libraries(${name} PUBLIC ${arg_LINKS})
    target_precompile_headers(${name} REUSE_FROM ${arg_PRECOMPILED})
    espalier_own_code(${name})
    # Most of a file's compile time goes into the same headers and templates: together they are read once.
    set_target_properties(${name} PROPERTIES UNITY_BUILD ${ESPALIER_UNITY} UNITY_BUILD_BATCH_SIZE 10)
endfunction()

# espalier_resources(name PREFIX prefix BASE folder FILES file…)
#
# Files to be found under ":/prefix" in every executable that links to the target of that name, directly or not.
# Qt registers a resource while the object file that holds it is loaded, and a linker leaves out of a static library
# any object without references to it; so the objects are linked into the executables directly.
function(espalier_resources name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "PREFIX;BASE" "FILES")
    add_library(${name} INTERFACE)
    if(NOT arg_FILES)
        return()
    endif()
    add_library(${name}_objects OBJECT)
    qt_add_resources(${name}_objects ${name} PREFIX "${arg_PREFIX}" BASE "${arg_BASE}" FILES ${arg_FILES})
    target_link_libraries(${name}_objects PRIVATE Qt6::Core)
    target_link_libraries(${name} INTERFACE $<TARGET_OBJECTS:${name}_objects>)
    add_dependencies(${name} ${name}_objects)
endfunction()
