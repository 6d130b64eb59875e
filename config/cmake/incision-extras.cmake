# Eigen's types are laid out alike whatever processor the code that uses our headers is compiled for.
add_definitions(-DEIGEN_MAX_ALIGN_BYTES=16)
