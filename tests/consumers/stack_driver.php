<?php
// Runs the question tests of exported STACK questions in STACK itself, outside Moodle:
//     php stack_driver.php CHECKOUT CACHE FILE.xml ...          (with MOST_TESTS=4: that many of each question)
// CHECKOUT is a checkout of github.com/maths/moodle-qtype_stack; CACHE an empty folder, where STACK keeps its saved Maxima image.
// Prints one JSON object: per question and deployed seed the tests with what was expected and what STACK answered.

[, $checkout, $cache] = $argv;
$files = array_map('realpath', array_slice($argv, 3));
foreach (['api/public', 'question/type', 'stack'] as $folder) {
    is_dir("$cache/$folder") || mkdir("$cache/$folder", 0777, true);
}
is_link("$cache/question/type/stack") || symlink(realpath($checkout), "$cache/question/type/stack");
// STACK's sample of a configuration, with the folders and the Maxima of this machine.
$settings = file_get_contents("$checkout/api/config_sample.txt") . '
$CFG->dirroot = ' . var_export(realpath($cache), true) . '; $CFG->dataroot = $CFG->dirroot; $CFG->wwwroot = "http://localhost";
$CFG->libdir = ' . var_export(realpath($checkout), true) . ' . "/api/emulation/libdir"; $CFG->castimeout = 60;
$CFG->platform = "linux"; $CFG->maximaversion = "default"; $CFG->maximacommand = "maxima"; $CFG->maximacommandopt = "";';
file_put_contents("$cache/api/config.php", $settings);
chdir("$cache/api/public");  // STACK looks for ../config.php

function set_config($name, $value) { global $CFG; $CFG->$name = $value; }
if (!function_exists("locale_lookup")) { function locale_lookup($known, $wanted, $canonical, $default) { return $default; } }  // php-intl
function make_upload_directory($name) { global $CFG; is_dir("$CFG->dataroot/$name") || mkdir("$CFG->dataroot/$name", 0777, true); }
require 'Symfony/Component/Yaml/autoload.php';
require 'Parsedown/autoload.php';
ini_set('display_errors', 'stderr');
error_reporting(E_ALL & ~(E_WARNING | E_NOTICE | E_DEPRECATED));
require "$checkout/api/emulation/MoodleEmulation.php";
require "$checkout/api/controller/TestController.php";
require_once "$checkout/stack/cas/installhelper.class.php";
use api\util\StackQuestionLoader;

if (!glob("$cache/stack/maxima_opt_auto*")) {
    [$made, $why] = stack_cas_configuration::create_auto_maxima_image();  // some 90 s, once
    $made || exit("STACK cannot save an image of Maxima: $why\n");
}
$CFG->platform = 'linux-optimised';
$CFG->maximacommandopt = trim(@file_get_contents("$cache/command")) ?: $CFG->maximacommandopt;
file_put_contents("$cache/command", $CFG->maximacommandopt);

$told = [];
foreach ($files as $file) {
    foreach ((new SimpleXMLElement(file_get_contents($file)))->question as $node) {
        if ((string) $node['type'] !== 'stack') { continue; }
        foreach (count($node->deployedseed) ? $node->deployedseed : [-1] as $seed) {
            $began = microtime(true);
            ['question' => $question, 'testcases' => $tests] = StackQuestionLoader::loadxml('<quiz>' . $node->asXML() . '</quiz>', true);
            $tests = array_slice($tests, 0, (int) (getenv('MOST_TESTS') ?: 1000), true);
            $question->castextprocessor = new castext2_qa_processor(new stack_outofcontext_process());
            $question->seed = (int) $seed;
            $question->initialise_question_from_seed();
            $run = (new api\controller\TestController())->qtype_stack_test_question($question, $tests, (int) $seed);
            $text = $question->questiontextinstantiated->get_rendered($question->castextprocessor);
            $run['messages'] .= $question->questiontextinstantiated->get_errors();
            $run += ['text' => $text, 'question' => $question->name, 'seed' => (int) $seed, 'errors' => array_keys($question->runtimeerrors)];
            $told[] = $run + ['seconds' => round(microtime(true) - $began, 2)];
        }
    }
}
echo json_encode($told, JSON_PRETTY_PRINT | JSON_UNESCAPED_UNICODE | JSON_PARTIAL_OUTPUT_ON_ERROR), "\n";
