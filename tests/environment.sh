# What the test commands need on a machine. They source this in the project's folder.

# The lines `package<TAB>what is missing` of a list of Debian packages, each with what it is needed
# for: command:NAME a program, library:NAME a shared library, python:NAME a Python module,
# module:NAME one of Debian's own Python, file:PATH a file.
missing() {
    grep -v '^#' "$1" | while read -r package need; do
        case $need in
            command:*) command -v "${need#*:}" ;;
            library:*) PATH=$PATH:/sbin:/usr/sbin ldconfig -p | grep -F "${need#*:} " ;;
            python:*) python3 -c "import ${need#*:}" ;;
            module:*) /usr/bin/python3 -c "import ${need#*:}" ;;
            file:*) [ -e "${need#*:}" ] ;;
            *) false ;;
        esac >/dev/null 2>&1 || printf '%s\t%s\n' "$package" "${need#*:}"
    done
}

# Names what is missing, as `missing` tells it; fails if there is something.
complain() {
    local lacking
    lacking=$(missing "$1" | while IFS=$'\t' read -r package need; do
        echo "missing: $need (Debian package $package)"
    done)
    [ -z "$lacking" ] || {
        echo "$lacking" >&2
        return 1
    }
}

# Makes the Python environment, unless the one here is up to date.
python_environment() {
    local pins=tests/consumers/requirements.txt
    cmp -s $pins .venv/installed.txt && return
    rm -rf .venv && python3 -m venv .venv &&
        .venv/bin/pip install --quiet --disable-pip-version-check --requirement $pins &&
        cp $pins .venv/installed.txt
}

# Fetches the Node modules of a folder, unless those there are up to date.
node_modules() {
    local lock=$1/package-lock.json installed=$1/node_modules/installed.json
    cmp -s "$lock" "$installed" && return
    npm ci --prefix "$1" --ignore-scripts --no-audit --no-fund && cp "$lock" "$installed"
}
