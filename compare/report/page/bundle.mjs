// Makes the page's scripts: node bundle.mjs FOLDER, where npm has installed the packages of package.json in FOLDER.
// Leaves there plots.js and view3d.js, each one self-contained text that begins with the licences of what is in it, and
// LICENSES.txt. The same packages give the same bytes.
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const folder = resolve(process.argv[2]), here = dirname(fileURLToPath(import.meta.url));
const modules = join(folder, 'node_modules');
const esbuild = createRequire(join(folder, 'package.json'))('esbuild');

function licence(name) {
  const {version} = JSON.parse(readFileSync(join(modules, name, 'package.json'), 'utf8'));
  return `${name} ${version}\n\n${readFileSync(join(modules, name, 'LICENSE'), 'utf8').trim()}\n`;
}

let all = '';
for (const [script, library] of [['plots.js', 'uplot'], ['view3d.js', 'three']]) {
  const text = licence(library);
  all += (all ? '\n----\n\n' : '') + text;
  const {outputFiles} = esbuild.buildSync({
    entryPoints: [join(here, script)], nodePaths: [modules], bundle: true, minify: true, write: false, format: 'iife',
    target: 'es2020', charset: 'ascii', legalComments: 'none', loader: {'.css': 'text'}, banner: {js: `/*!\n${text}*/`},
    logLevel: 'error',
  });
  const made = outputFiles[0].text;
  // It stands within markup, and within a string of the program.
  for (const end of ['</script', '<!--', ')~script~"'])
    if (made.includes(end)) throw new Error(`${script} holds ${end}, which would end it early`);
  writeFileSync(join(folder, script), made);
}
writeFileSync(join(folder, 'LICENSES.txt'), all);
