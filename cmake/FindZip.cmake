# SPDX-License-Identifier: GPL-3.0-or-later
# Finds libzip and makes the target Zip::zip. Debian's own libzip-config.cmake cannot be used: it refuses to load
# unless the command line tools zipcmp, zipmerge and ziptool are installed too.
include(FindPackageHandleStandardArgs)
find_path(Zip_INCLUDE_DIR zip.h)
find_library(Zip_LIBRARY zip)
find_package_handle_standard_args(Zip REQUIRED_VARS Zip_LIBRARY Zip_INCLUDE_DIR)
mark_as_advanced(Zip_INCLUDE_DIR Zip_LIBRARY)
if(Zip_FOUND AND NOT TARGET Zip::zip)
    add_library(Zip::zip UNKNOWN IMPORTED)
    set_target_properties(Zip::zip PROPERTIES
        IMPORTED_LOCATION "${Zip_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${Zip_INCLUDE_DIR}")
endif()
