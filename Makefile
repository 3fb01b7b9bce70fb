# Everything a newcomer needs. Each target first installs what a bare Debian 12 lacks for it, and
# only for it (tools/install.sh); when all is there that takes no noticeable time.
SHELL := /bin/bash
export JOBS ?= $(shell nproc)
# A folder of further meshes for `make test` and `make papers`.
DATA ?= $(wildcard ../shared/data)

.PHONY: help demo build studio web test bench curve counts papers format lint clean
help:  ## print this list
	@sed -n 's/^\([a-z]*\):.*## /  make \1: /p' $(MAKEFILE_LIST)

demo: need-demo build/release/build.ninja  ## build the command line, interpolate a few meshes, draw them into build/demo
	@cmake --build build/release --target surpass_app -j $(JOBS)
	@tools/demo.sh build/release/surpass build/demo

build: need-build build/release/build.ninja  ## build the libraries and the command line: build/release/surpass
	@cmake --build build/release -j $(JOBS)

studio: need-studio  ## build the studio, a page that interpolates in the browser: build/studio
	@tools/web.sh studio
	@echo "Open $(CURDIR)/build/studio/index.html"

web: need-web  ## build the frame of HTML reports, for --html and surpass view
	@tools/web.sh report

test: need-test  ## build and run the everyday tests; DATA=DIR adds a folder of real meshes
	@tools/web.sh report
	@tools/web.sh studio
	@cmake --preset release --log-level=WARNING -DSURPASS_TESTS=ON -DSURPASS_WEB_TESTS=ON
	@cmake --build build/release -j $(JOBS)
	@tools/test.sh build/release "$(DATA)" -LE slow

bench: need-bench  ## time Surpass beside other libraries; figures go to bench/results
	@cmake --preset bench --log-level=WARNING
	@cmake --build build/bench -j $(JOBS)
	@bench/run.sh build/bench bench/results

curve: need-bench  ## time the whole program to 1e7 vertices and 2e6 points; plots go to docs/images
	@cmake --preset bench --log-level=WARNING
	@cmake --build build/bench -j $(JOBS) --target surpass_app surpass_torus
	@bench/curve.py build/bench bench/results docs/images/curve.svg
	@bench/points_curve.py build/bench bench/results docs/images/points_curve.svg

counts: need-counts build/release/build.ninja  ## check that six small jobs take no more instructions
	@cmake --build build/release --target surpass_app -j $(JOBS)
	@tools/instructions.py build/release/surpass

papers: need-papers build/release/build.ninja  ## repeat the papers' figures into docs/papers, compare the methods; needs DATA=DIR
	@cmake --build build/release --target surpass_app -j $(JOBS)
	@tools/pictures.sh build/release/surpass docs/images
	@python3 tools/papers.py build/release/surpass "$(DATA)" docs/papers
	@python3 tools/iterations.py build/release/surpass "$(DATA)" docs/papers/iterations.md
	@python3 tools/reconstruction.py build/release/surpass "$(DATA)" docs/papers
	@python3 tools/similarity.py build/release/surpass "$(DATA)" docs/papers
	@python3 tools/nonstationary.py build/release/surpass "$(DATA)" docs/papers
	@python3 tools/compare_methods.py build/release/surpass "$(DATA)" docs

format: need-format  ## rewrite the sources in the project's format
	@tools/sources.sh | xargs clang-format -i

lint: need-lint  ## check format and names; every warning is an error
	@tools/lint.sh

clean:  ## remove everything that was built
	@rm -rf build

need-%:
	@tools/install.sh $*

build/release/build.ninja:
	@cmake --preset release --log-level=WARNING -DSURPASS_TESTS=OFF
