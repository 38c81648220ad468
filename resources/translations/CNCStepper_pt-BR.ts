<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_BR" sourcelanguage="en">
    <context>
        <name>App::Property</name>
        <message>
            <source>A shipped profile's name, or a profile's file</source>
            <translation>O nome de um perfil fornecido, ou o arquivo de um perfil</translation>
        </message>
        <message>
            <source>A sketch or wire that holds one ellipse; without it the numbers count</source>
            <translation>Um esboço ou arame com uma elipse; sem ele valem os números</translation>
        </message>
        <message>
            <source>Active</source>
            <translation>Ativa</translation>
        </message>
        <message>
            <source>Arcs within a tolerance, or the published points</source>
            <translation>Arcos dentro de uma tolerância, ou os pontos publicados</translation>
        </message>
        <message>
            <source>Centre</source>
            <translation>Centro</translation>
        </message>
        <message>
            <source>Clearance</source>
            <translation>Altura de segurança</translation>
        </message>
        <message>
            <source>Closed</source>
            <translation>Fechada</translation>
        </message>
        <message>
            <source>Containers</source>
            <translation>Recipientes</translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation>Refrigeração</translation>
        </message>
        <message>
            <source>Cut</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Cutting</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Deleted Drawing</source>
            <translation>Desenho excluído</translation>
        </message>
        <message>
            <source>Deleted drawing</source>
            <translation>Desenho excluído</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Profundidade</translation>
        </message>
        <message>
            <source>Dialect</source>
            <translation>Dialeto</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Diâmetro</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>Sentido</translation>
        </message>
        <message>
            <source>Drawing</source>
            <translation>Desenho</translation>
        </message>
        <message>
            <source>Ellipse</source>
            <translation>Elipse</translation>
        </message>
        <message>
            <source>Entry</source>
            <translation>Entrada</translation>
        </message>
        <message>
            <source>Entry Angle</source>
            <translation>Ângulo de entrada</translation>
        </message>
        <message>
            <source>Entry angle</source>
            <translation>Ângulo de entrada</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>Avanço</translation>
        </message>
        <message>
            <source>Feed at the wall</source>
            <translation>Avanço na parede</translation>
        </message>
        <message>
            <source>Finish</source>
            <translation>Acabamento</translation>
        </message>
        <message>
            <source>Finish Feed</source>
            <translation>Avanço de acabamento</translation>
        </message>
        <message>
            <source>Finish Stepdown</source>
            <translation>Última profundidade de corte</translation>
        </message>
        <message>
            <source>Finish Stepover</source>
            <translation>Última penetração de trabalho</translation>
        </message>
        <message>
            <source>First half axis</source>
            <translation>Primeiro semieixo</translation>
        </message>
        <message>
            <source>From X to the ellipse's first axis</source>
            <translation>De X até o primeiro eixo da elipse</translation>
        </message>
        <message>
            <source>From here down the tool feeds</source>
            <translation>Daqui para baixo a ferramenta avança em velocidade de corte</translation>
        </message>
        <message>
            <source>Half the width along its second axis</source>
            <translation>Metade da largura ao longo do segundo eixo</translation>
        </message>
        <message>
            <source>Half the width along the ellipse's first axis</source>
            <translation>Metade da largura ao longo do primeiro eixo da elipse</translation>
        </message>
        <message>
            <source>Heights</source>
            <translation>Alturas</translation>
        </message>
        <message>
            <source>How far the path may be off an ellipse or a B-spline; lines and arcs are exact</source>
            <translation>Quanto a trajetória pode desviar de uma elipse ou B-spline; retas e arcos são exatos</translation>
        </message>
        <message>
            <source>How far the wall may be off the ellipse</source>
            <translation>Quanto a parede pode desviar da elipse</translation>
        </message>
        <message>
            <source>How many passes at each depth</source>
            <translation>Número de passes em cada profundidade</translation>
        </message>
        <message>
            <source>How many passes in depth</source>
            <translation>Número de passes em profundidade</translation>
        </message>
        <message>
            <source>How many points the wire has</source>
            <translation>Número de pontos do arame</translation>
        </message>
        <message>
            <source>How steeply a helix or ramp goes down</source>
            <translation>Inclinação com que a hélice ou rampa desce</translation>
        </message>
        <message>
            <source>How the cutter turns against the feed</source>
            <translation>Como a fresa gira em relação ao avanço</translation>
        </message>
        <message>
            <source>How the tool goes down</source>
            <translation>Como a ferramenta desce</translation>
        </message>
        <message>
            <source>Job</source>
            <translation>Trabalho</translation>
        </message>
        <message>
            <source>Kept</source>
            <translation>Pontos mantidos</translation>
        </message>
        <message>
            <source>Last stepdown</source>
            <translation>Última profundidade de corte</translation>
        </message>
        <message>
            <source>Last stepover</source>
            <translation>Última penetração de trabalho</translation>
        </message>
        <message>
            <source>Length, width and height</source>
            <translation>Comprimento, largura e altura</translation>
        </message>
        <message>
            <source>Levels</source>
            <translation>Níveis</translation>
        </message>
        <message>
            <source>Line</source>
            <translation>Linha</translation>
        </message>
        <message>
            <source>Line Length</source>
            <translation>Comprimento das linhas</translation>
        </message>
        <message>
            <source>Line length</source>
            <translation>Comprimento das linhas</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>Linhas</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Máquina</translation>
        </message>
        <message>
            <source>Message</source>
            <translation>Mensagem</translation>
        </message>
        <message>
            <source>Method</source>
            <translation>Método</translation>
        </message>
        <message>
            <source>Number</source>
            <translation>Número</translation>
        </message>
        <message>
            <source>Of the written program</source>
            <translation>Do programa gerado</translation>
        </message>
        <message>
            <source>Operation</source>
            <translation>Operação</translation>
        </message>
        <message>
            <source>Operations</source>
            <translation>Operações</translation>
        </message>
        <message>
            <source>Passes</source>
            <translation>Passes</translation>
        </message>
        <message>
            <source>Path</source>
            <translation>Trajetória</translation>
        </message>
        <message>
            <source>Plunge</source>
            <translation>Mergulho</translation>
        </message>
        <message>
            <source>Plunge feed</source>
            <translation>Avanço de mergulho</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Pontos</translation>
        </message>
        <message>
            <source>Points kept</source>
            <translation>Pontos mantidos</translation>
        </message>
        <message>
            <source>Preview</source>
            <translation>Prévia</translation>
        </message>
        <message>
            <source>Problem</source>
            <translation>Problema</translation>
        </message>
        <message>
            <source>Profile</source>
            <translation>Perfil</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>Programa</translation>
        </message>
        <message>
            <source>Radius X</source>
            <translation>Semieixo X</translation>
        </message>
        <message>
            <source>Radius Y</source>
            <translation>Semieixo Y</translation>
        </message>
        <message>
            <source>Recalculated to whole passes</source>
            <translation>Recalculado para passes inteiros</translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation>Resolução</translation>
        </message>
        <message>
            <source>Retract</source>
            <translation>Retração</translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation>Rotação</translation>
        </message>
        <message>
            <source>Second half axis</source>
            <translation>Segundo semieixo</translation>
        </message>
        <message>
            <source>Shape</source>
            <translation>Forma</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Tamanho</translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation>Spindle</translation>
        </message>
        <message>
            <source>Spindle Speed</source>
            <translation>Rotação do spindle</translation>
        </message>
        <message>
            <source>Spindle turns a minute</source>
            <translation>Rotações do spindle por minuto</translation>
        </message>
        <message>
            <source>Stepdown</source>
            <translation>Profundidade de corte</translation>
        </message>
        <message>
            <source>Stepdown Used</source>
            <translation>Profundidade de corte usada</translation>
        </message>
        <message>
            <source>Stepdown ap</source>
            <translation>Profundidade de corte ap</translation>
        </message>
        <message>
            <source>Stepover</source>
            <translation>Penetração de trabalho</translation>
        </message>
        <message>
            <source>Stepover Used</source>
            <translation>Penetração de trabalho usada</translation>
        </message>
        <message>
            <source>Stepover ae</source>
            <translation>Penetração de trabalho ae</translation>
        </message>
        <message>
            <source>Stock</source>
            <translation>Bloco</translation>
        </message>
        <message>
            <source>Stock Origin</source>
            <translation>Origem no bloco</translation>
        </message>
        <message>
            <source>Stock Size</source>
            <translation>Tamanho do bloco</translation>
        </message>
        <message>
            <source>The T word of the program</source>
            <translation>A palavra T do programa</translation>
        </message>
        <message>
            <source>The centre, from the work zero</source>
            <translation>O centro, a partir do zero-peça</translation>
        </message>
        <message>
            <source>The depth below the top of the stock</source>
            <translation>A profundidade abaixo do topo do bloco</translation>
        </message>
        <message>
            <source>The depth of one pass at most, ap</source>
            <translation>A profundidade máxima de um passe, ap</translation>
        </message>
        <message>
            <source>The depth of one pass at most; 0: all at once</source>
            <translation>A profundidade máxima de um passe; 0: tudo de uma vez</translation>
        </message>
        <message>
            <source>The depth of the pocket, ap_total</source>
            <translation>A profundidade do bolsão, ap_total</translation>
        </message>
        <message>
            <source>The diameter of the cutter</source>
            <translation>O diâmetro da fresa</translation>
        </message>
        <message>
            <source>The drawing it followed, when that was deleted</source>
            <translation>O desenho que ela seguia, se foi excluído</translation>
        </message>
        <message>
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
            <translation>O avanço do último passe na parede; 0: o avanço da própria ferramenta</translation>
        </message>
        <message>
            <source>The form of the cutter</source>
            <translation>A forma da fresa</translation>
        </message>
        <message>
            <source>The job whose program is shown</source>
            <translation>O trabalho cujo programa é mostrado</translation>
        </message>
        <message>
            <source>The last pass at the wall, ae_acab; 0: none</source>
            <translation>O último passe na parede, ae_acab; 0: nenhum</translation>
        </message>
        <message>
            <source>The last pass in depth, ap_acab; 0: none</source>
            <translation>O último passe em profundidade, ap_acab; 0: nenhum</translation>
        </message>
        <message>
            <source>The length of all lines</source>
            <translation>O comprimento de todas as linhas</translation>
        </message>
        <message>
            <source>The parts and bodies that the drawing moves with</source>
            <translation>As peças e corpos com que o desenho se move</translation>
        </message>
        <message>
            <source>The points as they were drawn</source>
            <translation>Os pontos como foram desenhados</translation>
        </message>
        <message>
            <source>The program's dialect; empty: the machine's own</source>
            <translation>O dialeto do programa; vazio: o da própria máquina</translation>
        </message>
        <message>
            <source>The program, kept in this document</source>
            <translation>O programa, guardado neste documento</translation>
        </message>
        <message>
            <source>The sketch, wire, B-spline or freehand line to follow</source>
            <translation>O esboço, arame, B-spline ou linha à mão livre a seguir</translation>
        </message>
        <message>
            <source>The speed of cutting moves</source>
            <translation>A velocidade dos movimentos de corte</translation>
        </message>
        <message>
            <source>The speed straight down</source>
            <translation>A velocidade descendo na vertical</translation>
        </message>
        <message>
            <source>The step of the published method</source>
            <translation>O passo do método publicado</translation>
        </message>
        <message>
            <source>The tool that cuts it</source>
            <translation>A ferramenta que a executa</translation>
        </message>
        <message>
            <source>The tools that operations may choose from</source>
            <translation>As ferramentas que as operações podem escolher</translation>
        </message>
        <message>
            <source>The width of one pass at most, ae</source>
            <translation>A largura máxima de um passe, ae</translation>
        </message>
        <message>
            <source>The wire stays this close to every drawn point; 0 keeps every point that bends the line</source>
            <translation>O arame fica a no máximo esta distância de cada ponto desenhado; 0 mantém todos os pontos que curvam a linha</translation>
        </message>
        <message>
            <source>The work coordinate system</source>
            <translation>O sistema de coordenadas da peça</translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation>Tolerância</translation>
        </message>
        <message>
            <source>Tool</source>
            <translation>Ferramenta</translation>
        </message>
        <message>
            <source>Tool Shape</source>
            <translation>Forma da ferramenta</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Ferramentas</translation>
        </message>
        <message>
            <source>Units</source>
            <translation>Unidades</translation>
        </message>
        <message>
            <source>Unreachable</source>
            <translation>Inalcançável</translation>
        </message>
        <message>
            <source>What is cut, in this order</source>
            <translation>O que é usinado, nesta ordem</translation>
        </message>
        <message>
            <source>What is switched on while cutting</source>
            <translation>O que fica ligado durante o corte</translation>
        </message>
        <message>
            <source>What the round tool must leave at the ends of the long axis</source>
            <translation>O que a ferramenta redonda deixa nas pontas do eixo maior</translation>
        </message>
        <message>
            <source>Where on the stock the work zero lies</source>
            <translation>Onde fica o zero-peça no bloco</translation>
        </message>
        <message>
            <source>Where rapids travel across the work</source>
            <translation>Altura dos movimentos rápidos sobre a peça</translation>
        </message>
        <message>
            <source>Where the work zero lies in this document</source>
            <translation>Onde fica o zero-peça neste documento</translation>
        </message>
        <message>
            <source>Whether the last point joins the first</source>
            <translation>Se o último ponto se une ao primeiro</translation>
        </message>
        <message>
            <source>Whether the program holds it</source>
            <translation>Se o programa a contém</translation>
        </message>
        <message>
            <source>Why it cannot be made; empty when it can</source>
            <translation>Por que não pode ser feito; vazio quando pode</translation>
        </message>
        <message>
            <source>Why there is no program</source>
            <translation>Por que não há programa</translation>
        </message>
        <message>
            <source>Work Offset</source>
            <translation>Sistema de coordenadas</translation>
        </message>
        <message>
            <source>Work Origin</source>
            <translation>Zero-peça</translation>
        </message>
        <message>
            <source>Work offset</source>
            <translation>Sistema de coordenadas</translation>
        </message>
        <message>
            <source>Work zero</source>
            <translation>Zero-peça</translation>
        </message>
        <message>
            <source>Zero's place</source>
            <translation>Lugar do zero</translation>
        </message>
        <message>
            <source>ae, recalculated to whole passes</source>
            <translation>ae, recalculada para passes inteiros</translation>
        </message>
        <message>
            <source>ap, recalculated to whole passes</source>
            <translation>ap, recalculada para passes inteiros</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper</name>
        <message>
            <source>'{0}' has no meaning in a number</source>
            <translation>'{0}' não faz sentido em um número</translation>
        </message>
        <message>
            <source>'{0}' has several decimal separators; write 1234.5 or 1234,5</source>
            <translation>'{0}' tem vários separadores decimais; escreva 1234,5 ou 1234.5</translation>
        </message>
        <message>
            <source>'{0}' is no number</source>
            <translation>'{0}' não é um número</translation>
        </message>
        <message>
            <source>'{0}' is no value in {1}</source>
            <translation>'{0}' não é um valor em {1}</translation>
        </message>
        <message>
            <source>'{0}' is no whole number</source>
            <translation>'{0}' não é um número inteiro</translation>
        </message>
        <message>
            <source>'{0}' is too large</source>
            <translation>'{0}' é grande demais</translation>
        </message>
        <message>
            <source>A controller is connected already.</source>
            <translation>Um controlador já está conectado.</translation>
        </message>
        <message>
            <source>A job is being cut</source>
            <translation>Um trabalho está sendo usinado</translation>
        </message>
        <message>
            <source>A job is being cut already: wait for its end, or stop it.</source>
            <translation>Um trabalho já está sendo usinado: espere o fim ou pare-o.</translation>
        </message>
        <message>
            <source>A job is being cut: stop it first.</source>
            <translation>Um trabalho está sendo usinado: pare-o antes.</translation>
        </message>
        <message>
            <source>A machine's profile</source>
            <translation>Perfil de uma máquina</translation>
        </message>
        <message>
            <source>A profile's file…</source>
            <translation>Arquivo de perfil…</translation>
        </message>
        <message>
            <source>A serial port, or an address as socket://192.168.0.7:23</source>
            <translation>Uma porta serial, ou um endereço como socket://192.168.0.7:23</translation>
        </message>
        <message>
            <source>A shipped profile's name, or a profile's file</source>
            <translation>O nome de um perfil fornecido, ou o arquivo de um perfil</translation>
        </message>
        <message>
            <source>A sketch or wire that holds one ellipse; without it the numbers count</source>
            <translation>Um esboço ou arame com uma elipse; sem ele valem os números</translation>
        </message>
        <message>
            <source>A value is missing here</source>
            <translation>Falta um valor aqui</translation>
        </message>
        <message>
            <source>Active</source>
            <translation>Ativa</translation>
        </message>
        <message>
            <source>Add a tool to this job</source>
            <translation>Adiciona uma ferramenta a este trabalho</translation>
        </message>
        <message>
            <source>Add tool</source>
            <translation>Adicionar ferramenta</translation>
        </message>
        <message>
            <source>Alarm</source>
            <translation>Alarme</translation>
        </message>
        <message>
            <source>All = 0</source>
            <translation>Todos = 0</translation>
        </message>
        <message>
            <source>All files ({0})</source>
            <translation>Todos os arquivos ({0})</translation>
        </message>
        <message>
            <source>All lines are sent; the last moves are being cut.</source>
            <translation>Todas as linhas foram enviadas; os últimos movimentos estão sendo usinados.</translation>
        </message>
        <message>
            <source>An expression gives this value; change it in the property editor</source>
            <translation>Uma expressão define este valor; altere-o no editor de propriedades</translation>
        </message>
        <message>
            <source>Another machine?</source>
            <translation>Outra máquina?</translation>
        </message>
        <message>
            <source>Arcs within a tolerance, or the published points</source>
            <translation>Arcos dentro de uma tolerância, ou os pontos publicados</translation>
        </message>
        <message>
            <source>Attached again to the controller at {0}.</source>
            <translation>Reconectado ao controlador em {0}.</translation>
        </message>
        <message>
            <source>Busy</source>
            <translation>Ocupado</translation>
        </message>
        <message>
            <source>CNCStepper has a fault: {0}</source>
            <translation>O CNCStepper tem uma falha: {0}</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Cancelar</translation>
        </message>
        <message>
            <source>Centre</source>
            <translation>Centro</translation>
        </message>
        <message>
            <source>Change the programmed value while cutting, in percent.</source>
            <translation>Ajusta o valor programado durante o corte, em porcento.</translation>
        </message>
        <message>
            <source>Check and simulate: {0}</source>
            <translation>Verificar e simular: {0}</translation>
        </message>
        <message>
            <source>Checking against the machine…</source>
            <translation>Comparando com a máquina…</translation>
        </message>
        <message>
            <source>Checking the program</source>
            <translation>Verificando o programa</translation>
        </message>
        <message>
            <source>Choose a port, then connect.</source>
            <translation>Escolha uma porta e conecte.</translation>
        </message>
        <message>
            <source>Choose above where to cut, then connect.</source>
            <translation>Escolha acima onde usinar e conecte.</translation>
        </message>
        <message>
            <source>Choose one here</source>
            <translation>Escolha aqui</translation>
        </message>
        <message>
            <source>Clearance</source>
            <translation>Altura de segurança</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Fechar</translation>
        </message>
        <message>
            <source>Close the open task panel first</source>
            <translation>Feche antes o painel de tarefas aberto</translation>
        </message>
        <message>
            <source>Close the safety door, then resume.</source>
            <translation>Feche a porta de segurança e retome.</translation>
        </message>
        <message>
            <source>Closed</source>
            <translation>Fechada</translation>
        </message>
        <message>
            <source>Comparing the cut with the drawing…</source>
            <translation>Comparando o corte com o desenho…</translation>
        </message>
        <message>
            <source>Connect</source>
            <translation>Conectar</translation>
        </message>
        <message>
            <source>Connect to a controller first.</source>
            <translation>Conecte-se antes a um controlador.</translation>
        </message>
        <message>
            <source>Connect to the controller at this port</source>
            <translation>Conecta ao controlador nesta porta</translation>
        </message>
        <message>
            <source>Connecting…</source>
            <translation>Conectando…</translation>
        </message>
        <message>
            <source>Connection lost</source>
            <translation>Conexão perdida</translation>
        </message>
        <message>
            <source>Containers</source>
            <translation>Recipientes</translation>
        </message>
        <message>
            <source>Controller</source>
            <translation>Controlador</translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation>Refrigeração</translation>
        </message>
        <message>
            <source>Cut</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Cut in this order; what is not checked is left out of the program</source>
            <translation>Usinadas nesta ordem; o que não está marcado fica fora do programa</translation>
        </message>
        <message>
            <source>Cut it after the one below</source>
            <translation>Usinar depois da seguinte</translation>
        </message>
        <message>
            <source>Cut it before the one above</source>
            <translation>Usinar antes da anterior</translation>
        </message>
        <message>
            <source>Cutting</source>
            <translation>Corte</translation>
        </message>
        <message>
            <source>Cutting the part…</source>
            <translation>Usinando a peça…</translation>
        </message>
        <message>
            <source>Delete a point</source>
            <translation>Excluir um ponto</translation>
        </message>
        <message>
            <source>Delete the marked tool</source>
            <translation>Exclui a ferramenta marcada</translation>
        </message>
        <message>
            <source>Deleted drawing</source>
            <translation>Desenho excluído</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Profundidade</translation>
        </message>
        <message>
            <source>Dialect</source>
            <translation>Dialeto</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Diâmetro</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>Sentido</translation>
        </message>
        <message>
            <source>Disconnect</source>
            <translation>Desconectar</translation>
        </message>
        <message>
            <source>Done</source>
            <translation>Concluído</translation>
        </message>
        <message>
            <source>Door</source>
            <translation>Porta</translation>
        </message>
        <message>
            <source>Drag a point to move it, the line to add one; Delete takes the point under the pointer. Esc: done.</source>
            <translation>Arraste um ponto para movê-lo, a linha para adicionar um; Delete exclui o ponto sob o cursor. Esc: terminar.</translation>
        </message>
        <message>
            <source>Draw a freehand line</source>
            <translation>Desenhar linha à mão livre</translation>
        </message>
        <message>
            <source>Draw a line: press the left button, move, release. Shift: straight. Esc: end drawing.</source>
            <translation>Desenhe uma linha: pressione o botão esquerdo, mova, solte. Shift: reta. Esc: encerrar o desenho.</translation>
        </message>
        <message>
            <source>Drawing</source>
            <translation>Desenho</translation>
        </message>
        <message>
            <source>Earlier</source>
            <translation>Antes</translation>
        </message>
        <message>
            <source>Edit</source>
            <translation>Editar</translation>
        </message>
        <message>
            <source>Edit {0}</source>
            <translation>Editar {0}</translation>
        </message>
        <message>
            <source>Elapsed</source>
            <translation>Decorrido</translation>
        </message>
        <message>
            <source>Ellipse</source>
            <translation>Elipse</translation>
        </message>
        <message>
            <source>Elliptical pocket</source>
            <translation>Bolsão elíptico</translation>
        </message>
        <message>
            <source>Engrave</source>
            <translation>Gravar</translation>
        </message>
        <message>
            <source>Engraving</source>
            <translation>Gravação</translation>
        </message>
        <message>
            <source>Entry</source>
            <translation>Entrada</translation>
        </message>
        <message>
            <source>Entry angle</source>
            <translation>Ângulo de entrada</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>Erro</translation>
        </message>
        <message>
            <source>Failed</source>
            <translation>Falhou</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>Avanço</translation>
        </message>
        <message>
            <source>Feed at the wall</source>
            <translation>Avanço na parede</translation>
        </message>
        <message>
            <source>Feeding in air</source>
            <translation>Avanço no ar</translation>
        </message>
        <message>
            <source>Find the cause, then home the machine or unlock it.</source>
            <translation>Encontre a causa, depois referencie a máquina ou destrave-a.</translation>
        </message>
        <message>
            <source>Finding</source>
            <translation>Ocorrência</translation>
        </message>
        <message>
            <source>Findings ({0})</source>
            <translation>Ocorrências ({0})</translation>
        </message>
        <message>
            <source>Findings ({0}): the program must not be sent</source>
            <translation>Ocorrências ({0}): o programa não pode ser enviado</translation>
        </message>
        <message>
            <source>Finish</source>
            <translation>Acabamento</translation>
        </message>
        <message>
            <source>Finishing</source>
            <translation>Terminando</translation>
        </message>
        <message>
            <source>First half axis</source>
            <translation>Primeiro semieixo</translation>
        </message>
        <message>
            <source>Fit to drawing</source>
            <translation>Ajustar ao desenho</translation>
        </message>
        <message>
            <source>Follow the drawing that is selected in the tree or in the 3D view</source>
            <translation>Seguir o desenho selecionado na árvore ou na vista 3D</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks numba. All works without, but planning and simulating are slow.</source>
            <translation>Falta numba no Python do FreeCAD. Tudo funciona sem ele, mas o planejamento e a simulação ficam lentos.</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks pyserial. No machine can be reached without.</source>
            <translation>Falta pyserial no Python do FreeCAD. Sem ele não se alcança nenhuma máquina.</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}</source>
            <translation>Falta no Python do FreeCAD: {0}</translation>
        </message>
        <message>
            <source>FreeCAD's Python lacks {0}. No program can be made without.</source>
            <translation>Falta no Python do FreeCAD: {0}. Sem isso não é possível gerar programas.</translation>
        </message>
        <message>
            <source>From X to the ellipse's first axis</source>
            <translation>De X até o primeiro eixo da elipse</translation>
        </message>
        <message>
            <source>From here down the tool feeds</source>
            <translation>Daqui para baixo a ferramenta avança em velocidade de corte</translation>
        </message>
        <message>
            <source>Go on</source>
            <translation>Continuar</translation>
        </message>
        <message>
            <source>Go on after a hold, a pause or the door.</source>
            <translation>Continua após uma pausa, uma espera ou a porta.</translation>
        </message>
        <message>
            <source>Half the width along its second axis</source>
            <translation>Metade da largura ao longo do segundo eixo</translation>
        </message>
        <message>
            <source>Half the width along the ellipse's first axis</source>
            <translation>Metade da largura ao longo do primeiro eixo da elipse</translation>
        </message>
        <message>
            <source>Height above the top of the stock; lines: where the tool's tip goes</source>
            <translation>Altura acima do topo do bloco; linhas: por onde passa a ponta da ferramenta</translation>
        </message>
        <message>
            <source>Heights</source>
            <translation>Alturas</translation>
        </message>
        <message>
            <source>Held</source>
            <translation>Em pausa</translation>
        </message>
        <message>
            <source>Hold</source>
            <translation>Pausar</translation>
        </message>
        <message>
            <source>Hold: slow down and stand still; nothing is lost, the spindle goes on turning.</source>
            <translation>Pausar: desacelera e fica parada; nada se perde, o spindle continua girando.</translation>
        </message>
        <message>
            <source>Holding…</source>
            <translation>Pausando…</translation>
        </message>
        <message>
            <source>Home</source>
            <translation>Referenciar</translation>
        </message>
        <message>
            <source>Homing</source>
            <translation>Referenciando</translation>
        </message>
        <message>
            <source>Homing works only while the machine is idle or in alarm.</source>
            <translation>Só é possível referenciar com a máquina pronta ou em alarme.</translation>
        </message>
        <message>
            <source>How far one click moves the machine.</source>
            <translation>Quanto um clique move a máquina.</translation>
        </message>
        <message>
            <source>How far the path may be off an ellipse or a B-spline; lines and arcs are exact</source>
            <translation>Quanto a trajetória pode desviar de uma elipse ou B-spline; retas e arcos são exatos</translation>
        </message>
        <message>
            <source>How far the wall may be off the ellipse</source>
            <translation>Quanto a parede pode desviar da elipse</translation>
        </message>
        <message>
            <source>How fast the machine moves while jogging; it never goes faster than it can.</source>
            <translation>Velocidade da máquina no movimento manual; nunca acima do que ela pode.</translation>
        </message>
        <message>
            <source>How many passes at each depth</source>
            <translation>Número de passes em cada profundidade</translation>
        </message>
        <message>
            <source>How many passes in depth</source>
            <translation>Número de passes em profundidade</translation>
        </message>
        <message>
            <source>How many points the wire has</source>
            <translation>Número de pontos do arame</translation>
        </message>
        <message>
            <source>How many times faster than a real one the virtual machine moves</source>
            <translation>Quantas vezes mais rápido que uma real a máquina virtual se move</translation>
        </message>
        <message>
            <source>How many times faster than the machine</source>
            <translation>Quantas vezes mais rápido que a máquina</translation>
        </message>
        <message>
            <source>How steeply a helix or ramp goes down</source>
            <translation>Inclinação com que a hélice ou rampa desce</translation>
        </message>
        <message>
            <source>How the cutter turns against the feed</source>
            <translation>Como a fresa gira em relação ao avanço</translation>
        </message>
        <message>
            <source>How the tool goes down</source>
            <translation>Como a ferramenta desce</translation>
        </message>
        <message>
            <source>Idle</source>
            <translation>Pronta</translation>
        </message>
        <message>
            <source>Is the work zero set on the stock and the way free?</source>
            <translation>O zero-peça está definido no bloco e o caminho está livre?</translation>
        </message>
        <message>
            <source>Job</source>
            <translation>Trabalho</translation>
        </message>
        <message>
            <source>Job: {0}</source>
            <translation>Trabalho: {0}</translation>
        </message>
        <message>
            <source>Jog</source>
            <translation>Movimento manual</translation>
        </message>
        <message>
            <source>Jogging</source>
            <translation>Movimento manual</translation>
        </message>
        <message>
            <source>Jogging works only while the machine is idle.</source>
            <translation>O movimento manual só funciona com a máquina pronta.</translation>
        </message>
        <message>
            <source>Keep cutting and close</source>
            <translation>Continuar usinando e fechar</translation>
        </message>
        <message>
            <source>Last stepdown</source>
            <translation>Última profundidade de corte</translation>
        </message>
        <message>
            <source>Last stepover</source>
            <translation>Última penetração de trabalho</translation>
        </message>
        <message>
            <source>Later</source>
            <translation>Depois</translation>
        </message>
        <message>
            <source>Leave out of the program</source>
            <translation>Deixar fora do programa</translation>
        </message>
        <message>
            <source>Length, width and height</source>
            <translation>Comprimento, largura e altura</translation>
        </message>
        <message>
            <source>Let go of the controller</source>
            <translation>Libera o controlador</translation>
        </message>
        <message>
            <source>Let the machine find its own zero with its switches.</source>
            <translation>Deixa a máquina encontrar o próprio zero com os fins de curso.</translation>
        </message>
        <message>
            <source>Levels</source>
            <translation>Níveis</translation>
        </message>
        <message>
            <source>Line</source>
            <translation>Linha</translation>
        </message>
        <message>
            <source>Line length</source>
            <translation>Comprimento das linhas</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>Linhas</translation>
        </message>
        <message>
            <source>Look at the findings, then decide.</source>
            <translation>Examine as ocorrências e decida.</translation>
        </message>
        <message>
            <source>Look at the machine, then connect again.</source>
            <translation>Examine a máquina e conecte de novo.</translation>
        </message>
        <message>
            <source>Look at the port, then connect again.</source>
            <translation>Examine a porta e conecte de novo.</translation>
        </message>
        <message>
            <source>Looking for a Python…</source>
            <translation>Procurando um Python…</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Máquina</translation>
        </message>
        <message>
            <source>Make a job first, with New job</source>
            <translation>Crie antes um trabalho, com Novo trabalho</translation>
        </message>
        <message>
            <source>Make this position the work zero of the axis.</source>
            <translation>Faz desta posição o zero-peça do eixo.</translation>
        </message>
        <message>
            <source>Message</source>
            <translation>Mensagem</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>Mensagens</translation>
        </message>
        <message>
            <source>Method</source>
            <translation>Método</translation>
        </message>
        <message>
            <source>Move a point</source>
            <translation>Mover um ponto</translation>
        </message>
        <message>
            <source>Move for as long as an arrow is held down; letting go stops.</source>
            <translation>Move enquanto uma seta estiver pressionada; soltar para o movimento.</translation>
        </message>
        <message>
            <source>Move the machine in this direction.</source>
            <translation>Move a máquina neste sentido.</translation>
        </message>
        <message>
            <source>New job</source>
            <translation>Novo trabalho</translation>
        </message>
        <message>
            <source>No connection</source>
            <translation>Sem conexão</translation>
        </message>
        <message>
            <source>No controller is connected.</source>
            <translation>Nenhum controlador está conectado.</translation>
        </message>
        <message>
            <source>No messages yet</source>
            <translation>Nenhuma mensagem ainda</translation>
        </message>
        <message>
            <source>No port can be opened here.</source>
            <translation>Nenhuma porta pode ser aberta aqui.</translation>
        </message>
        <message>
            <source>Not connected</source>
            <translation>Desconectado</translation>
        </message>
        <message>
            <source>Not sent</source>
            <translation>Não enviado</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>Observação</translation>
        </message>
        <message>
            <source>Nothing moves that could be held.</source>
            <translation>Nada se move que possa ser pausado.</translation>
        </message>
        <message>
            <source>Nothing moves that could be stopped. The emergency stop is on the machine.</source>
            <translation>Nada se move que possa ser parado. A parada de emergência fica na máquina.</translation>
        </message>
        <message>
            <source>Nothing was found: the program can be sent.</source>
            <translation>Nada foi encontrado: o programa pode ser enviado.</translation>
        </message>
        <message>
            <source>Number</source>
            <translation>Número</translation>
        </message>
        <message>
            <source>Of the written program</source>
            <translation>Do programa gerado</translation>
        </message>
        <message>
            <source>One line of the program back</source>
            <translation>Uma linha do programa para trás</translation>
        </message>
        <message>
            <source>One line of the program on</source>
            <translation>Uma linha do programa para a frente</translation>
        </message>
        <message>
            <source>Open or make a document first</source>
            <translation>Abra ou crie antes um documento</translation>
        </message>
        <message>
            <source>Open the 3D view of the document first</source>
            <translation>Abra antes a vista 3D do documento</translation>
        </message>
        <message>
            <source>Operation</source>
            <translation>Operação</translation>
        </message>
        <message>
            <source>Operations</source>
            <translation>Operações</translation>
        </message>
        <message>
            <source>Overrides</source>
            <translation>Ajustes (override)</translation>
        </message>
        <message>
            <source>Overrides work only while the machine is idle or cutting.</source>
            <translation>Os ajustes só funcionam com a máquina pronta ou usinando.</translation>
        </message>
        <message>
            <source>Passes</source>
            <translation>Passes</translation>
        </message>
        <message>
            <source>Path</source>
            <translation>Trajetória</translation>
        </message>
        <message>
            <source>Paused</source>
            <translation>Em espera</translation>
        </message>
        <message>
            <source>Play or pause</source>
            <translation>Reproduzir ou pausar</translation>
        </message>
        <message>
            <source>Please report it, with the details, at {0}</source>
            <translation>Relate-a, com os detalhes, em {0}</translation>
        </message>
        <message>
            <source>Plunge feed</source>
            <translation>Avanço de mergulho</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Pontos</translation>
        </message>
        <message>
            <source>Points kept</source>
            <translation>Pontos mantidos</translation>
        </message>
        <message>
            <source>Port</source>
            <translation>Porta</translation>
        </message>
        <message>
            <source>Preview</source>
            <translation>Prévia</translation>
        </message>
        <message>
            <source>Problem</source>
            <translation>Problema</translation>
        </message>
        <message>
            <source>Profile</source>
            <translation>Perfil</translation>
        </message>
        <message>
            <source>Profiles (*.toml)</source>
            <translation>Perfis (*.toml)</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>Programa</translation>
        </message>
        <message>
            <source>Programs ({0})</source>
            <translation>Programas ({0})</translation>
        </message>
        <message>
            <source>Put the stock around what is selected, or around the drawings of the operations</source>
            <translation>Põe o bloco em torno do que está selecionado, ou dos desenhos das operações</translation>
        </message>
        <message>
            <source>Rapid</source>
            <translation>Rápido</translation>
        </message>
        <message>
            <source>Rapids</source>
            <translation>Rápidos</translation>
        </message>
        <message>
            <source>Reading the job…</source>
            <translation>Lendo o trabalho…</translation>
        </message>
        <message>
            <source>Reading the program back…</source>
            <translation>Relendo o programa…</translation>
        </message>
        <message>
            <source>Recalculated to whole passes</source>
            <translation>Recalculado para passes inteiros</translation>
        </message>
        <message>
            <source>Refused</source>
            <translation>Recusado</translation>
        </message>
        <message>
            <source>Refused by the machine</source>
            <translation>Recusado pela máquina</translation>
        </message>
        <message>
            <source>Release to close the line. Esc: give up this line.</source>
            <translation>Solte para fechar a linha. Esc: desistir desta linha.</translation>
        </message>
        <message>
            <source>Release: done. Release at the start: close the line. Shift: straight. Esc: give up this line.</source>
            <translation>Soltar: pronto. Soltar no início: fechar a linha. Shift: reta. Esc: desistir desta linha.</translation>
        </message>
        <message>
            <source>Remaining</source>
            <translation>Restante</translation>
        </message>
        <message>
            <source>Remove tool</source>
            <translation>Remover ferramenta</translation>
        </message>
        <message>
            <source>Removed</source>
            <translation>Removido</translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation>Resolução</translation>
        </message>
        <message>
            <source>Resume</source>
            <translation>Retomar</translation>
        </message>
        <message>
            <source>Retract</source>
            <translation>Retração</translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation>Rotação</translation>
        </message>
        <message>
            <source>Running</source>
            <translation>Usinando</translation>
        </message>
        <message>
            <source>Save program as…</source>
            <translation>Salvar programa como…</translation>
        </message>
        <message>
            <source>Saved {0}</source>
            <translation>{0} salvo</translation>
        </message>
        <message>
            <source>Second half axis</source>
            <translation>Segundo semieixo</translation>
        </message>
        <message>
            <source>Select a drawing in the tree or in the 3D view first</source>
            <translation>Selecione antes um desenho na árvore ou na vista 3D</translation>
        </message>
        <message>
            <source>Select a drawing or a solid first</source>
            <translation>Selecione antes um desenho ou um sólido</translation>
        </message>
        <message>
            <source>Select the job in the tree: this document has several</source>
            <translation>Selecione o trabalho na árvore: este documento tem vários</translation>
        </message>
        <message>
            <source>Select what is to be engraved: a sketch, a wire, a B-spline or a freehand line</source>
            <translation>Selecione o que será gravado: um esboço, um arame, uma B-spline ou uma linha à mão livre</translation>
        </message>
        <message>
            <source>Send anyway</source>
            <translation>Enviar assim mesmo</translation>
        </message>
        <message>
            <source>Shape</source>
            <translation>Forma</translation>
        </message>
        <message>
            <source>Show the tool's path</source>
            <translation>Mostra a trajetória da ferramenta</translation>
        </message>
        <message>
            <source>Simulate again</source>
            <translation>Simular de novo</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Tamanho</translation>
        </message>
        <message>
            <source>Speed</source>
            <translation>Velocidade</translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation>Spindle</translation>
        </message>
        <message>
            <source>Spindle turns a minute</source>
            <translation>Rotações do spindle por minuto</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Iniciar</translation>
        </message>
        <message>
            <source>Starting</source>
            <translation>Iniciando</translation>
        </message>
        <message>
            <source>Step ({0})</source>
            <translation>Passo ({0})</translation>
        </message>
        <message>
            <source>Step {0} of {1}</source>
            <translation>Etapa {0} de {1}</translation>
        </message>
        <message>
            <source>Stepdown ap</source>
            <translation>Profundidade de corte ap</translation>
        </message>
        <message>
            <source>Stepover ae</source>
            <translation>Penetração de trabalho ae</translation>
        </message>
        <message>
            <source>Stock</source>
            <translation>Bloco</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Parar</translation>
        </message>
        <message>
            <source>Stop the cut and close</source>
            <translation>Parar o corte e fechar</translation>
        </message>
        <message>
            <source>Stop: slow down, stand still, spindle off; the rest of the job is not cut. This is not an emergency stop: the emergency stop is on the machine.</source>
            <translation>Parar: desacelera, para e desliga o spindle; o resto do trabalho não é usinado. Isto não é uma parada de emergência: a parada de emergência fica na máquina.</translation>
        </message>
        <message>
            <source>Stopped</source>
            <translation>Parado</translation>
        </message>
        <message>
            <source>Stopping…</source>
            <translation>Parando…</translation>
        </message>
        <message>
            <source>Switch {0}</source>
            <translation>Alternar {0}</translation>
        </message>
        <message>
            <source>Take into the program</source>
            <translation>Incluir no programa</translation>
        </message>
        <message>
            <source>Take selected</source>
            <translation>Usar seleção</translation>
        </message>
        <message>
            <source>Take the alarm away without homing: only when the position is surely right.</source>
            <translation>Retira o alarme sem referenciar: só quando a posição está certa com certeza.</translation>
        </message>
        <message>
            <source>The T word of the program</source>
            <translation>A palavra T do programa</translation>
        </message>
        <message>
            <source>The baud rate of the serial port</source>
            <translation>A taxa de transmissão (baud) da porta serial</translation>
        </message>
        <message>
            <source>The centre, from the work zero</source>
            <translation>O centro, a partir do zero-peça</translation>
        </message>
        <message>
            <source>The checks found errors: nothing is sent. Mend them, then send again.</source>
            <translation>A verificação encontrou erros: nada foi enviado. Corrija-os e envie de novo.</translation>
        </message>
        <message>
            <source>The connection is being made.</source>
            <translation>A conexão está sendo feita.</translation>
        </message>
        <message>
            <source>The controller does something that was not asked for here.</source>
            <translation>O controlador faz algo que não foi pedido aqui.</translation>
        </message>
        <message>
            <source>The controller is set up differently. Nothing was sent.</source>
            <translation>O controlador está configurado de outro modo. Nada foi enviado.</translation>
        </message>
        <message>
            <source>The controller's panel is attached again to a machine that was left connected.</source>
            <translation>O painel do controlador foi religado a uma máquina que ficou conectada.</translation>
        </message>
        <message>
            <source>The controller's settings are compared.</source>
            <translation>As configurações do controlador são comparadas.</translation>
        </message>
        <message>
            <source>The cut goes on without FreeCAD; the controller's panel finds it again the next time it is opened.</source>
            <translation>O corte continua sem o FreeCAD; o painel do controlador o reencontra na próxima vez que for aberto.</translation>
        </message>
        <message>
            <source>The cut is simulated and checked.</source>
            <translation>O corte é simulado e verificado.</translation>
        </message>
        <message>
            <source>The depth below the top of the stock</source>
            <translation>A profundidade abaixo do topo do bloco</translation>
        </message>
        <message>
            <source>The depth of one pass at most, ap</source>
            <translation>A profundidade máxima de um passe, ap</translation>
        </message>
        <message>
            <source>The depth of one pass at most; 0: all at once</source>
            <translation>A profundidade máxima de um passe; 0: tudo de uma vez</translation>
        </message>
        <message>
            <source>The depth of the pocket, ap_total</source>
            <translation>A profundidade do bolsão, ap_total</translation>
        </message>
        <message>
            <source>The diameter of the cutter</source>
            <translation>O diâmetro da fresa</translation>
        </message>
        <message>
            <source>The drawing gives this value</source>
            <translation>O desenho define este valor</translation>
        </message>
        <message>
            <source>The drawing it followed, when that was deleted</source>
            <translation>O desenho que ela seguia, se foi excluído</translation>
        </message>
        <message>
            <source>The feed of the last pass at the wall; 0: the tool's own feed</source>
            <translation>O avanço do último passe na parede; 0: o avanço da própria ferramenta</translation>
        </message>
        <message>
            <source>The form of the cutter</source>
            <translation>A forma da fresa</translation>
        </message>
        <message>
            <source>The job is being cut.</source>
            <translation>O trabalho está sendo usinado.</translation>
        </message>
        <message>
            <source>The job whose program is shown</source>
            <translation>O trabalho cujo programa é mostrado</translation>
        </message>
        <message>
            <source>The last pass at the wall, ae_acab; 0: none</source>
            <translation>O último passe na parede, ae_acab; 0: nenhum</translation>
        </message>
        <message>
            <source>The last pass in depth, ap_acab; 0: none</source>
            <translation>O último passe em profundidade, ap_acab; 0: nenhum</translation>
        </message>
        <message>
            <source>The length of all lines</source>
            <translation>O comprimento de todas as linhas</translation>
        </message>
        <message>
            <source>The link to the controller is being started.</source>
            <translation>A ligação com o controlador está sendo iniciada.</translation>
        </message>
        <message>
            <source>The machine is cutting a job.</source>
            <translation>A máquina está usinando um trabalho.</translation>
        </message>
        <message>
            <source>The machine is moved by hand.</source>
            <translation>A máquina é movida manualmente.</translation>
        </message>
        <message>
            <source>The machine is not held: there is nothing to resume.</source>
            <translation>A máquina não está em pausa: não há o que retomar.</translation>
        </message>
        <message>
            <source>The machine is not in alarm: there is nothing to unlock.</source>
            <translation>A máquina não está em alarme: não há o que destravar.</translation>
        </message>
        <message>
            <source>The machine looks for its switches.</source>
            <translation>A máquina procura os fins de curso.</translation>
        </message>
        <message>
            <source>The machine must be idle: wait, or home or unlock it first.</source>
            <translation>A máquina precisa estar pronta: espere, ou antes referencie ou destrave-a.</translation>
        </message>
        <message>
            <source>The machine slows down, then the job is ended.</source>
            <translation>A máquina desacelera e o trabalho é encerrado.</translation>
        </message>
        <message>
            <source>The machine slows down.</source>
            <translation>A máquina desacelera.</translation>
        </message>
        <message>
            <source>The machine stands and waits.</source>
            <translation>A máquina está parada e à espera.</translation>
        </message>
        <message>
            <source>The machine stands; nothing is lost. Resume or stop.</source>
            <translation>A máquina está parada; nada se perdeu. Retome ou pare.</translation>
        </message>
        <message>
            <source>The parts and bodies that the drawing moves with</source>
            <translation>As peças e corpos com que o desenho se move</translation>
        </message>
        <message>
            <source>The points as they were drawn</source>
            <translation>Os pontos como foram desenhados</translation>
        </message>
        <message>
            <source>The program has changed since: what is shown is the one before.</source>
            <translation>O programa mudou desde então: o que se vê é o anterior.</translation>
        </message>
        <message>
            <source>The program waits. Resume goes on.</source>
            <translation>O programa espera. Retomar continua.</translation>
        </message>
        <message>
            <source>The program's dialect; empty: the machine's own</source>
            <translation>O dialeto do programa; vazio: o da própria máquina</translation>
        </message>
        <message>
            <source>The program, kept in this document</source>
            <translation>O programa, guardado neste documento</translation>
        </message>
        <message>
            <source>The sketch, wire, B-spline or freehand line to follow</source>
            <translation>O esboço, arame, B-spline ou linha à mão livre a seguir</translation>
        </message>
        <message>
            <source>The speed of cutting moves</source>
            <translation>A velocidade dos movimentos de corte</translation>
        </message>
        <message>
            <source>The speed straight down</source>
            <translation>A velocidade descendo na vertical</translation>
        </message>
        <message>
            <source>The step of the published method</source>
            <translation>O passo do método publicado</translation>
        </message>
        <message>
            <source>The tool that cuts it</source>
            <translation>A ferramenta que a executa</translation>
        </message>
        <message>
            <source>The tools that operations may choose from</source>
            <translation>As ferramentas que as operações podem escolher</translation>
        </message>
        <message>
            <source>The width of one pass at most, ae</source>
            <translation>A largura máxima de um passe, ae</translation>
        </message>
        <message>
            <source>The wire stays this close to every drawn point; 0 keeps every point that bends the line</source>
            <translation>O arame fica a no máximo esta distância de cada ponto desenhado; 0 mantém todos os pontos que curvam a linha</translation>
        </message>
        <message>
            <source>The work coordinate system</source>
            <translation>O sistema de coordenadas da peça</translation>
        </message>
        <message>
            <source>The work zero can be set only while the machine is idle.</source>
            <translation>O zero-peça só pode ser definido com a máquina pronta.</translation>
        </message>
        <message>
            <source>The working plane is seen from its edge: turn the view to draw on it.</source>
            <translation>O plano de trabalho é visto de lado: gire a vista para desenhar nele.</translation>
        </message>
        <message>
            <source>This machine has no homing switches set up ($22=0).</source>
            <translation>Esta máquina não tem fins de curso de referência configurados ($22=0).</translation>
        </message>
        <message>
            <source>This takes a number without a unit, not '{0}'</source>
            <translation>Aqui vai um número sem unidade, não '{0}'</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Tempo</translation>
        </message>
        <message>
            <source>Time in the program</source>
            <translation>Tempo no programa</translation>
        </message>
        <message>
            <source>Timing the moves…</source>
            <translation>Cronometrando os movimentos…</translation>
        </message>
        <message>
            <source>To get what is missing, type in a terminal, with Python {0}, and start FreeCAD again:</source>
            <translation>Para obter o que falta, digite em um terminal, com Python {0}, e reinicie o FreeCAD:</translation>
        </message>
        <message>
            <source>To the begin</source>
            <translation>Ao início</translation>
        </message>
        <message>
            <source>To the end</source>
            <translation>Ao fim</translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation>Tolerância</translation>
        </message>
        <message>
            <source>Tool</source>
            <translation>Ferramenta</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Ferramentas</translation>
        </message>
        <message>
            <source>Units</source>
            <translation>Unidades</translation>
        </message>
        <message>
            <source>Unlock</source>
            <translation>Destravar</translation>
        </message>
        <message>
            <source>Unreachable</source>
            <translation>Inalcançável</translation>
        </message>
        <message>
            <source>V-bit</source>
            <translation>fresa em V</translation>
        </message>
        <message>
            <source>Virtual grbl (no machine)</source>
            <translation>grbl virtual (sem máquina)</translation>
        </message>
        <message>
            <source>Waiting for the controller to answer.</source>
            <translation>Esperando a resposta do controlador.</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>Aviso</translation>
        </message>
        <message>
            <source>Warnings</source>
            <translation>Avisos</translation>
        </message>
        <message>
            <source>What is cut, in this order</source>
            <translation>O que é usinado, nesta ordem</translation>
        </message>
        <message>
            <source>What is switched on while cutting</source>
            <translation>O que fica ligado durante o corte</translation>
        </message>
        <message>
            <source>What the round tool must leave at the ends of the long axis</source>
            <translation>O que a ferramenta redonda deixa nas pontas do eixo maior</translation>
        </message>
        <message>
            <source>Where</source>
            <translation>Onde</translation>
        </message>
        <message>
            <source>Where on the stock the work zero lies</source>
            <translation>Onde fica o zero-peça no bloco</translation>
        </message>
        <message>
            <source>Where rapids travel across the work</source>
            <translation>Altura dos movimentos rápidos sobre a peça</translation>
        </message>
        <message>
            <source>Where the table stands is not known: home the machine, or set the work zero anew.</source>
            <translation>Não se sabe onde a mesa está: referencie a máquina ou defina de novo o zero-peça.</translation>
        </message>
        <message>
            <source>Where the work zero lies in this document</source>
            <translation>Onde fica o zero-peça neste documento</translation>
        </message>
        <message>
            <source>Whether the last point joins the first</source>
            <translation>Se o último ponto se une ao primeiro</translation>
        </message>
        <message>
            <source>Whether the program holds it</source>
            <translation>Se o programa a contém</translation>
        </message>
        <message>
            <source>While pressed</source>
            <translation>Enquanto pressionado</translation>
        </message>
        <message>
            <source>Why it cannot be made; empty when it can</source>
            <translation>Por que não pode ser feito; vazio quando pode</translation>
        </message>
        <message>
            <source>Why there is no program</source>
            <translation>Por que não há programa</translation>
        </message>
        <message>
            <source>Work</source>
            <translation>Peça</translation>
        </message>
        <message>
            <source>Work offset</source>
            <translation>Sistema de coordenadas</translation>
        </message>
        <message>
            <source>Work zero</source>
            <translation>Zero-peça</translation>
        </message>
        <message>
            <source>Writing the report…</source>
            <translation>Escrevendo o relatório…</translation>
        </message>
        <message>
            <source>Zero's place</source>
            <translation>Lugar do zero</translation>
        </message>
        <message>
            <source>ae, recalculated to whole passes</source>
            <translation>ae, recalculada para passes inteiros</translation>
        </message>
        <message>
            <source>ap, recalculated to whole passes</source>
            <translation>ap, recalculada para passes inteiros</translation>
        </message>
        <message>
            <source>arcs within the tolerance</source>
            <translation>arcos dentro da tolerância</translation>
        </message>
        <message>
            <source>ball end mill</source>
            <translation>fresa de topo esférico</translation>
        </message>
        <message>
            <source>bull nose</source>
            <translation>fresa toroidal</translation>
        </message>
        <message>
            <source>centre of the top</source>
            <translation>centro do topo</translation>
        </message>
        <message>
            <source>climb</source>
            <translation>concordante</translation>
        </message>
        <message>
            <source>conventional</source>
            <translation>discordante</translation>
        </message>
        <message>
            <source>drill</source>
            <translation>broca</translation>
        </message>
        <message>
            <source>engraver</source>
            <translation>ferramenta de gravação</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>avanço</translation>
        </message>
        <message>
            <source>flat end mill</source>
            <translation>fresa de topo reto</translation>
        </message>
        <message>
            <source>flood (M8)</source>
            <translation>jato (M8)</translation>
        </message>
        <message>
            <source>front left corner of the top</source>
            <translation>canto frontal esquerdo do topo</translation>
        </message>
        <message>
            <source>helix</source>
            <translation>hélice</translation>
        </message>
        <message>
            <source>inches (G20)</source>
            <translation>polegadas (G20)</translation>
        </message>
        <message>
            <source>limit {0}</source>
            <translation>limite {0}</translation>
        </message>
        <message>
            <source>line {0}</source>
            <translation>linha {0}</translation>
        </message>
        <message>
            <source>make room in the folder for temporary files</source>
            <translation>libere espaço na pasta de arquivos temporários</translation>
        </message>
        <message>
            <source>millimetres (G21)</source>
            <translation>milímetros (G21)</translation>
        </message>
        <message>
            <source>mist (M7)</source>
            <translation>névoa (M7)</translation>
        </message>
        <message>
            <source>must be above {0}</source>
            <translation>deve ser maior que {0}</translation>
        </message>
        <message>
            <source>must be at least {0}</source>
            <translation>deve ser no mínimo {0}</translation>
        </message>
        <message>
            <source>must be at most {0}</source>
            <translation>deve ser no máximo {0}</translation>
        </message>
        <message>
            <source>must be below {0}</source>
            <translation>deve ser menor que {0}</translation>
        </message>
        <message>
            <source>none</source>
            <translation>nenhuma</translation>
        </message>
        <message>
            <source>none yet</source>
            <translation>nenhum ainda</translation>
        </message>
        <message>
            <source>none, the numbers count</source>
            <translation>nenhum, valem os números</translation>
        </message>
        <message>
            <source>open a document or its 3D view</source>
            <translation>abra um documento ou a sua vista 3D</translation>
        </message>
        <message>
            <source>open one and simulate again</source>
            <translation>abra uma e simule de novo</translation>
        </message>
        <message>
            <source>published points (DDA)</source>
            <translation>pontos publicados (DDA)</translation>
        </message>
        <message>
            <source>ramp</source>
            <translation>rampa</translation>
        </message>
        <message>
            <source>rapid</source>
            <translation>rápido</translation>
        </message>
        <message>
            <source>straight down</source>
            <translation>na vertical</translation>
        </message>
        <message>
            <source>the machine's own</source>
            <translation>o da máquina</translation>
        </message>
        <message>
            <source>there is no 3D view to draw in</source>
            <translation>não há vista 3D em que desenhar</translation>
        </message>
        <message>
            <source>this document has no 3D view</source>
            <translation>este documento não tem vista 3D</translation>
        </message>
        <message>
            <source>value {0}</source>
            <translation>valor {0}</translation>
        </message>
        <message>
            <source>{0} %</source>
            <translation>{0} %</translation>
        </message>
        <message>
            <source>{0} = 0</source>
            <translation>{0} = 0</translation>
        </message>
        <message>
            <source>{0} has nothing to cut: add an operation</source>
            <translation>{0} não tem o que usinar: adicione uma operação</translation>
        </message>
        <message>
            <source>{0} is cut with it; choose another tool there first</source>
            <translation>{0} é usinada com ela; escolha antes outra ferramenta lá</translation>
        </message>
        <message>
            <source>{0} moves</source>
            <translation>{0} movimentos</translation>
        </message>
        <message>
            <source>{0} of {1} lines, line {2} of the file</source>
            <translation>{0} de {1} linhas, linha {2} do arquivo</translation>
        </message>
        <message>
            <source>{0} rpm</source>
            <translation>{0} rpm</translation>
        </message>
        <message>
            <source>{0} ×</source>
            <translation>{0} ×</translation>
        </message>
        <message>
            <source>{0}:</source>
            <translation>{0}:</translation>
        </message>
        <message>
            <source>{0}: {1}</source>
            <translation>{0}: {1}</translation>
        </message>
        <message>
            <source>{0}: {1} points, within {2:g} mm of the drawn line. Draw the next one, or Esc: end drawing.</source>
            <translation>{0}: {1} pontos, a até {2:g} mm da linha desenhada. Desenhe a próxima, ou Esc: encerrar.</translation>
        </message>
        <message>
            <source>{0}× speed</source>
            <translation>velocidade {0}×</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Controller</name>
        <message>
            <source>Controller</source>
            <translation>Controlador</translation>
        </message>
        <message>
            <source>Shows the machine: state, position, hold, stop, jog, zero</source>
            <translation>Mostra a máquina: estado, posição, pausar, parar, movimento manual, zero</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_EllipticalPocket</name>
        <message>
            <source>Cuts a pocket: the selected ellipse, or one by numbers</source>
            <translation>Usina um bolsão: a elipse selecionada, ou uma por números</translation>
        </message>
        <message>
            <source>Elliptical pocket</source>
            <translation>Bolsão elíptico</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Engrave</name>
        <message>
            <source>Cuts along the lines of the selected drawing</source>
            <translation>Usina ao longo das linhas do desenho selecionado</translation>
        </message>
        <message>
            <source>Engrave</source>
            <translation>Gravar</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Freehand</name>
        <message>
            <source>Draws a line with the mouse: press, move, release</source>
            <translation>Desenha uma linha com o mouse: pressione, mova, solte</translation>
        </message>
        <message>
            <source>Freehand</source>
            <translation>À mão livre</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_NewJob</name>
        <message>
            <source>Makes a job. A selected solid or drawing gives its stock</source>
            <translation>Cria um trabalho. Um sólido ou desenho selecionado define o bloco</translation>
        </message>
        <message>
            <source>New job</source>
            <translation>Novo trabalho</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Send</name>
        <message>
            <source>Checks the program of the job and streams it to the machine</source>
            <translation>Verifica o programa do trabalho e o transmite à máquina</translation>
        </message>
        <message>
            <source>Send</source>
            <translation>Enviar</translation>
        </message>
    </context>
    <context>
        <name>CNCStepper_Simulate</name>
        <message>
            <source>Check and simulate</source>
            <translation>Verificar e simular</translation>
        </message>
        <message>
            <source>Checks the program of the job and shows what it cuts</source>
            <translation>Verifica o programa do trabalho e mostra o que ele usina</translation>
        </message>
    </context>
</TS>
